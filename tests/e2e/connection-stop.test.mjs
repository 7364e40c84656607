// The robot stops when the page goes away: tabs closed, left, hidden or hung while it drives, or one of the connection's
// workers. LINK_ROUNDS=100 tries each of them as often, LOAD=2 with that many busy processes per core beside.
import assert from "node:assert/strict";
import { test } from "node:test";
import { noSerial, openDesk, openHidable } from "./serial/desk.mjs";
import { underLoad } from "./serial/load.mjs";
import { Robot, lastStop, moves, now, stops } from "./serial/robot.mjs";

const skip = noSerial() || false;
const ROUNDS = Number(process.env.LINK_ROUNDS ?? 3);
const LIMIT_MS = 250;
underLoad(Number(process.env.LOAD ?? 0));

/** Never meets a wall. */
const TURN = { forward: 0, left: 1 };

/** Waits for further commands, and returns how long after `since`, in seconds, the robot was commanded to stop. */
async function stoppedAfter(robot, since) {
  await new Promise((later) => setTimeout(later, 400));
  // The robot itself is late on a busy machine; when it was told counts.
  await robot.rests();
  const heard = robot.heard();
  assert.ok(!moves(heard[0]), "the first command moved the robot");
  assert.ok(heard.some(moves), "the robot wasn't moving");
  assert.ok(robot.isAtRest(), "the robot moves");
  return (lastStop(heard).time - since) * 1000;
}

function report(t, taken) {
  const sorted = taken.toSorted((a, b) => a - b).map(Math.round);
  t.diagnostic(`${taken.length} of ${ROUNDS} stopped: median ${sorted[sorted.length >> 1]} ms, longest ${sorted.at(-1)} ms`);
  assert.ok(sorted.at(-1) <= LIMIT_MS, `stopped after ${sorted.at(-1)} ms`);
}

// Counted from when the browser first tells the page: tests reach the browser by a detour, and a page that is left for another
// one goes on until that one answers.
const noteLeaving = (tab) =>
  tab.evaluate(() => {
    localStorage.removeItem("left");
    const note = ({ timeStamp }) => localStorage.getItem("left") ?? localStorage.setItem("left", String((performance.timeOrigin + timeStamp) / 1000));
    for (const sign of ["beforeunload", "pagehide"]) addEventListener(sign, note, true);
  });
const leftAt = async (tab) => {
  const left = await tab.evaluate(() => localStorage.getItem("left"));
  assert.notEqual(left, null);
  return Number(left);
};

/** Does something with a page, and says when it was left; another page of the same origin reads that. */
const seenFromOutside = async ({ tab, server }, what) => {
  const other = await tab.context().newPage();
  await other.goto(`${server.url}elsewhere.html`);
  await tab.bringToFront();
  await noteLeaving(tab);
  await what(tab);
  const at = await leftAt(other);
  await other.close();
  return at;
};

/** Does something in one of the page's workers, by its file's name, without waiting for it; says when. */
const inWorker = ({ tab }, name, what) => {
  const worker = tab.workers().find((one) => new URL(one.url()).pathname.endsWith(`/${name}`));
  assert.ok(worker, `there is no ${name} among ${tab.workers().map((one) => one.url())}`);
  const at = now();
  worker.evaluate(what).catch(() => {});
  return at;
};
const hang = () => {
  const end = performance.now() + 3000;
  while (performance.now() < end);
};

const WAYS = {
  "the tab is closed": (desk) => seenFromOutside(desk, (tab) => tab.close()),
  "the user goes back": (desk) => seenFromOutside(desk, (tab) => tab.goBack()),
  // And back again, whether or not the browser has kept the page.
  "the page is left": async ({ tab, server }) => {
    await noteLeaving(tab);
    await tab.goto(`${server.url}elsewhere.html`);
    const at = await leftAt(tab);
    await tab.goBack();
    return at;
  },
  "the page is reloaded": async ({ tab }) => {
    await noteLeaving(tab);
    await tab.reload();
    return leftAt(tab);
  },
  // Longer than any page gets that is only slow.
  "the page hangs": ({ tab }) =>
    tab.evaluate(() => {
      const at = Date.now();
      while (Date.now() - at < 1500);
      return at / 1000;
    }),
  "the driver's worker ends": (desk) => inWorker(desk, "worker.js", () => self.close()),
  "the driver's worker hangs": (desk) => inWorker(desk, "worker.js", hang),
  "the line's worker ends": (desk) => inWorker(desk, "line-worker.js", () => self.close()),
};

for (const [way, go] of Object.entries(WAYS)) {
  test(`stops when ${way}`, { skip, timeout: 60_000 + 5000 * ROUNDS }, async (t) => {
    const robot = await Robot.start(t);
    const { desk: first, open } = await openDesk(t, { robot });
    let desk = first;
    const taken = [];
    for (let round = 0; round < ROUNDS; round++) {
      robot.forget();
      if (desk.tab.isClosed()) desk = await open();
      await desk.load();
      await desk.connect();
      await desk.arm();
      await desk.drive(TURN);
      taken.push(await stoppedAfter(robot, await go(desk, round)));
    }
    report(t, taken);
  });
}

test("who leaves while the robot drives is asked, and it stands by then", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk } = await openDesk(t, { robot });
  await desk.connect();
  const asked = [];
  desk.tab.on("dialog", async (dialog) => {
    // Its stop was sent before; its wheels may still be slowing down.
    asked.push([dialog.type(), stops(lastStop(robot.heard()))]);
    await robot.rests();
    await dialog.dismiss();
  });
  // Nothing is at stake yet.
  await desk.tab.click("body");
  await desk.load();
  assert.deepEqual(asked, []);
  await desk.connect();
  await desk.arm();
  await desk.tab.click("body");
  await desk.drive(TURN);
  await desk.tab.reload({ timeout: 2000 }).catch(() => {});
  assert.deepEqual(asked, [["beforeunload", true]]);
  // The page is still there, and may take control again.
  await desk.letGo();
  await desk.until((view) => view.mode === "Passive");
  assert.match((await desk.view()).notice.text, /about to leave/);
  await desk.arm();
  await desk.ask({ do: "disarm" });
  await desk.until((view) => view.mode === "Passive");
});

test("stops when the tab is hidden, and stays so when it is shown again", { skip, timeout: 60_000 + 5000 * ROUNDS }, async (t) => {
  const robot = await Robot.start(t);
  const { openTab } = await openHidable(t, { robot });
  const tab = await openTab("desk.html");
  const other = await openTab("elsewhere.html");
  const until = (condition) =>
    tab.evaluate(`new Promise((done, fail) => {
      const late = setTimeout(() => fail(new Error("waited in vain for " + ${JSON.stringify(condition)})), 15000);
      const look = () => { try { if (${condition}) return clearTimeout(late), done(true); } catch {} setTimeout(look, 20); };
      look();
    })`);
  await tab.show();
  await until("connection && document.visibilityState === 'visible'");
  await tab.evaluate("navigator.serial.getPorts().then(([port]) => connection.open({ kind: 'serial', port }))");
  await tab.evaluate("document.addEventListener('visibilitychange', (event) => (window.hiddenAt = (performance.timeOrigin + event.timeStamp) / 1000), true)");
  const taken = [];
  for (let round = 0; round < ROUNDS; round++) {
    await until("seen.view.phase === 'connected'");
    robot.forget();
    await tab.evaluate("connection.request({ do: 'arm', full: false })");
    await until("seen.view.can.drive");
    await tab.evaluate("window.stick = setInterval(() => connection.request({ do: 'drive', forward: 0, left: 1 }), 50), 0");
    await until("seen.view.wheels[1] > 0");
    await other.show();
    await until("document.visibilityState === 'hidden'");
    const at = await tab.evaluate("window.hiddenAt");
    taken.push(await stoppedAfter(robot, at));
    // The stick is still held.
    await tab.show();
    await until("document.visibilityState === 'visible'");
    await new Promise((later) => setTimeout(later, 200));
    lastStop(robot.heard());
    assert.ok((await tab.evaluate("seen.view.mode")) === "Passive");
    await tab.evaluate("clearInterval(stick)");
  }
  report(t, taken);
});
