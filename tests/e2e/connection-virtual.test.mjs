// The virtual robot behind the same worker: what is found out about each personality, and rides.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openDesk } from "./serial/desk.mjs";

/** What connecting to each comes to. */
const FOUND = {
  model: (v) => v.phase === "connected" && v.mode === "Passive" && !v.mode_offset,
  asleep: (v) => v.phase === "connected" && v.diagnosis.log.some((line) => line.includes("BRC")),
  no_brc: (v) => v.phase === "waiting" && v.diagnosis.finding === "silence" && v.diagnosis.remedy.includes("CLEAN"),
  slow: (v) => v.phase === "connected" && v.statistics.baud === 19_200 && v.transport.baud === 19_200,
  mode_plus_one: (v) => v.phase === "connected" && v.mode === "Passive" && v.mode_offset,
  chatty: (v) => v.phase === "connected" && v.statistics.texts > 0,
  docked: (v) => v.phase === "connected" && v.statistics.texts > 0,
  angle_bug: (v) => v.phase === "connected",
  noisy: (v) => v.phase === "connected" && v.statistics.bad_checksums > 0,
  deaf: (v) => v.phase === "connected",
  swapped: (v) => v.phase === "connected",
  wrap: (v) => v.phase === "connected",
  bootloader: (v) => v.phase === "connected",
  create1: (v) => v.phase === "connected" && v.statistics.baud === 57_600 && v.notice?.text.includes("Create 1"),
  silent: (v) => v.phase === "waiting" && v.diagnosis.finding === "silence",
};

test("every personality is told apart", async (t) => {
  const { desk } = await openDesk(t);
  // All at once, each with a worker of its own: some take ten seconds until they are given up.
  await desk.tab.evaluate(async (ids) => {
    window.all = {};
    for (const id of ids) {
      const connection = new window.ConnectionClient(window.module);
      const seen = (window.all[id] = { connection, view: null, failures: [] });
      connection.onview = (view) => (seen.view = view);
      connection.onfailed = (failure) => seen.failures.push(failure);
      await connection.follow({ snapshot: { room: "empty" } });
      await connection.open({ kind: "virtual", personality: id });
    }
  }, Object.keys(FOUND));
  const seen = async (id, fits) => {
    await desk.tab.waitForFunction(`window.all.${id}.view && (${fits})(window.all.${id}.view)`, null, { polling: 50 }).catch(async () => {
      const view = await desk.tab.evaluate((name) => window.all[name].view, id);
      assert.fail(`${id}: waited in vain for ${fits}: ${JSON.stringify({ ...view, readings: null })}`);
    });
    return desk.tab.evaluate((name) => window.all[name].view, id);
  };
  for (const [id, fits] of Object.entries(FOUND)) {
    await seen(id, fits);
    assert.deepEqual(await desk.tab.evaluate((name) => window.all[name].failures, id), [], id);
  }

  // A hand on its Clean button helps where the cable doesn't.
  const one = (id, script) => desk.tab.evaluate(`(async ({ connection }) => ${script})(window.all.${id})`);
  await one("no_brc", "connection.virtual({ do: 'press', buttons: 1 })");
  await seen("no_brc", (v) => v.phase === "connected");

  // One that doesn't start any more after a reset.
  assert.equal(await one("bootloader", "connection.request({ do: 'identify' })"), true);
  await seen("bootloader", (v) => v.phase === "waiting" && v.diagnosis.finding === "bootloader" && v.diagnosis.remedy.includes("battery"));

  // On its dock a robot can't be controlled, and it is said why.
  assert.equal(await one("docked", "connection.request({ do: 'arm', full: false })"), true);
  const { drop } = await seen("docked", (v) => v.drop !== null);
  assert.match(drop.text + drop.remedy, /charg|dock/i);
  assert.equal(drop.can_rearm, false);
});

test("a behaviour rides the virtual robot, and lifting it ends that", async (t) => {
  const { desk } = await openDesk(t);
  const open = await desk.tab.evaluate(async () => {
    await window.connection.follow({ snapshot: { room: "empty", choices: { behaviour: "bounce" } } });
    return window.connection.open({ kind: "virtual", personality: "model" });
  });
  assert.ok(open, JSON.stringify(await desk.failures()));
  await desk.until((v) => v.phase === "connected");
  // Not without control.
  assert.equal(await desk.tab.evaluate(() => window.connection.ride([], false)), false);
  assert.deepEqual((await desk.failures()).map(({ kind }) => kind), ["refused"]);
  await desk.arm();
  assert.equal(await desk.tab.evaluate(() => window.connection.ride([], false)), true);
  const { virtual } = await desk.until((v) => v.distance_m > 0.2);
  const trace = await desk.tab.evaluate(() => window.seen.trace);
  assert.equal(trace.length % 4, 0);
  assert.ok(trace.length > 40);
  assert.equal(virtual.mode, "Safe");

  await desk.tab.evaluate(() => window.connection.virtual({ do: "lift" }));
  const lifted = await desk.until((v) => v.drop !== null && v.virtual.lifted);
  assert.match(lifted.drop.text, /wheel/i);
  assert.equal(lifted.ride.done, true);
  assert.notEqual(lifted.ride.ended, "");
  const recording = await desk.tab.evaluate(() => window.connection.recording());
  assert.ok(recording.length > 1000);
});
