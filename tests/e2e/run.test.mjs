// A run from its start to its end, and back and forth in it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp, seconds } from "./app.mjs";

test("cleans a whole room, and time can be wound back", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&robot=cell&speed=0" });
  await app.until("finished");
  const end = await app.numbers();
  assert.equal(end.coverage, 100);
  assert.equal((await app.metric("Coverage")).plan, "100.0 %");
  const planned = seconds((await app.metric("Time")).plan);
  assert.ok(Math.abs(end.time / planned - 1) < 0.03, `planned ${planned} s, driven ${end.time} s`);
  assert.match(await page.locator("#floor").getAttribute("aria-label"), /the run is finished, 100\.0 %/);
  assert.match(await page.locator("#narration").textContent(), /the run is finished/, "said aloud");

  assert.equal(await app.scrub(0.4), "paused");
  const middle = await app.numbers();
  assert.ok(Math.abs(middle.time - 0.4 * end.time) < 0.02 * end.time + 1, `${middle.time} s of ${end.time} s`);
  assert.ok(middle.coverage > 20 && middle.coverage < 60, `${middle.coverage} %`);
  assert.equal(await page.locator("#scrubber").getAttribute("aria-valuenow"), String(middle.time));

  await app.scrub(0.2);
  const early = await app.numbers();
  assert.ok(early.coverage < middle.coverage && early.distance < middle.distance);
  // The same time again is the same moment again.
  await app.scrub(0.4);
  assert.deepEqual(await app.numbers(), middle);

  await app.press("Play");
  await app.until("finished");
  assert.deepEqual(await app.numbers(), end);
});

test("plays again from the start once it is over", async (t) => {
  const { app } = await openApp(t, { address: "#room=thesis8&robot=cell&speed=0" });
  await app.until("finished");
  const end = await app.numbers();
  await app.choose("speed", "1");
  await app.press("Play");
  const { time } = await app.numbersThat((now, then) => now.distance > 0 && now.distance < then.distance, end);
  assert.equal(await app.state(), "playing");
  assert.ok(time < 10, `${time} s`);
});

test("pauses, steps and goes back to the start by buttons", async (t) => {
  const { page, app } = await openApp(t);
  await app.press("Pause");
  assert.equal(await app.until("paused"), "paused");
  const stopped = await app.numbers();
  await app.frames(10);
  assert.deepEqual(await app.numbers(), stopped);

  await app.press("One step");
  const stepped = await app.numbersThat((now, then) => now.distance > then.distance || now.time > then.time, stopped);
  assert.equal(await app.state(), "paused");
  assert.ok(stepped.time - stopped.time <= 6 && stepped.distance - stopped.distance < 0.5, "one step is a small one");

  await app.press("Back to the start");
  await app.until("ready");
  assert.deepEqual(await app.numbers(), { coverage: 0, time: 0, distance: 0 });
  assert.ok(await page.locator("#reset").isDisabled());

  await app.press("Play");
  await app.until("playing");
  await app.press("One step");
  await app.until("paused");
});

test("the speed is what the menu says", async (t) => {
  const { page, app } = await openApp(t);
  const speeds = await page.locator("#speed option").allTextContents();
  assert.deepEqual([speeds[0], speeds.at(-1)], ["1×", "max"]);
  for (const [value, least] of [["64", 16], ["0", 64]]) {
    await app.press("Back to the start");
    await app.choose("speed", value);
    // Before it plays: on a busy machine a run at full speed may be over before it is read.
    const [clock, from] = [await page.evaluate(() => performance.now()), await app.numbers()];
    await app.press("Play");
    await app.numbersThat((now, then) => now.time > then.time + 60, from);
    const [seconds, to] = [((await page.evaluate(() => performance.now())) - clock) / 1000, await app.numbers()];
    assert.ok((to.time - from.time) / seconds > least, `speed ${value}: ${to.time - from.time} s in ${seconds} s`);
  }
  assert.equal(await app.linked("speed", (value) => value === "0"), "0", "the link says so, too");
});
