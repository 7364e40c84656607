// Driving by hand.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

/** The robot stands in the middle and looks to the right. */
const ROOM = "#room=empty&behaviour=manual&start=2.5,2.0,0";
/** A hand's breadth before the wall, looking at it. */
const WALL = "#room=empty&behaviour=manual&start=4.7,2.0,0";

/** Waits until the robot stands; how far it has come. */
const stands = async (app) => {
  await app.still(() => app.numbers().then(({ distance }) => distance));
  return (await app.numbers()).distance;
};

test("time runs as it does, and the page says so", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty" });
  assert.ok(await page.locator("#manual").isHidden());
  await app.choose("algorithm", "manual");
  assert.equal(await page.locator("#speed").inputValue(), "1");
  await app.poll(() => app.text("#manual-note"), (text) => /Time runs at 1×/.test(text));
  assert.equal(await page.locator("#algorithm-kind").textContent(), "you drive");
  await app.choose("algorithm", "bounce");
  assert.equal(await page.locator("#speed").inputValue(), "16", "the speed from before");
});

test("arrow keys and letters drive while they are held, on the floor", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await app.frames(30);
  assert.equal((await app.numbers()).distance, 0, "it waits");
  await page.locator("#floor").focus();
  await page.keyboard.down("ArrowUp");
  await app.numbersThat(({ distance }) => distance > 0.3);
  await page.keyboard.up("ArrowUp");
  const there = await stands(app);

  await page.keyboard.down("KeyS");
  await app.numbersThat((now, then) => now.distance > then + 0.1, there);
  assert.equal(await page.locator("#tools [data-tool=start]").getAttribute("aria-pressed"), "false", "S drives here");
  await page.keyboard.up("KeyS");
  await stands(app);

  const turning = async () => 360 * Number.parseFloat((await app.metric("Turned in all")).soFar);
  const before = await turning();
  await page.keyboard.down("KeyA");
  await app.poll(turning, (degrees) => degrees > before + 30);
  await page.keyboard.up("KeyA");
  await stands(app);

  // Wherever else the focus is, letters of tools drive.
  const { distance } = await app.numbers();
  await page.locator("#tab-explore").focus();
  await page.keyboard.down("KeyW");
  await app.numbersThat((now, then) => now.distance > then + 0.1, distance);
  await page.keyboard.up("KeyW");
});

test("in the closed menu in which driving was chosen keys drive, and opened it chooses", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await app.poll(() => page.locator("#manual").isVisible(), Boolean);
  const menu = page.locator("#algorithm");
  for (const key of ["ArrowUp", "KeyW"]) {
    const { distance } = await app.numbers();
    await menu.focus();
    await page.keyboard.down(key);
    await app.numbersThat((now, then) => now.distance > then + 0.1, distance);
    await page.keyboard.up(key);
    await stands(app);
    assert.equal(await menu.inputValue(), "manual", key);
  }
  await menu.focus();
  await page.keyboard.press("Space");
  await app.poll(() => menu.evaluate((node) => node.matches(":open")), Boolean);
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await app.poll(() => menu.inputValue(), (id) => id !== "manual");
});

test("whoever chooses to drive while drawing walls drives", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&behaviour=bounce" });
  await page.locator("#tools [data-tool=wall]").click();
  await page.locator("#algorithm").focus();
  await page.locator("#algorithm").selectOption("manual");
  await page.locator("#tools [data-tool=view][aria-pressed=true]").waitFor();
  await page.locator("#floor:focus").waitFor();
  await page.keyboard.down("ArrowUp");
  await app.numbersThat(({ distance }) => distance > 0.1);
  await page.keyboard.up("ArrowUp");
});

test("losing the focus, pausing and letting go stop it", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  for (const stop of [() => page.locator("#step").focus(), () => page.evaluate(() => dispatchEvent(new Event("blur"))), () => app.press("Pause")]) {
    await page.locator("#floor").focus();
    const { distance } = await app.numbers();
    await page.keyboard.down("ArrowUp");
    await app.numbersThat((now, then) => now.distance > then + 0.1, distance);
    await stop();
    await stands(app);
    await page.keyboard.up("ArrowUp");
  }
});

test("the joystick drives and comes back to its middle", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  const box = await page.locator("#pad").boundingBox();
  const middle = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0], middle[1] - 40, { steps: 4 });
  await app.numbersThat(({ distance }) => distance > 0.3);
  await page.locator(".way.used[data-way=forward]").waitFor({ state: "attached" });
  await page.mouse.up();
  await stands(app);
  assert.equal(await page.locator("#knob").evaluate((knob) => knob.style.getPropertyValue("--y")), "0");

  await page.locator("#knob").focus();
  const { distance } = await app.numbers();
  await page.keyboard.down("ArrowUp");
  await app.numbersThat((now, then) => now.distance > then + 0.05, distance);
  await page.keyboard.up("ArrowUp");
});

test("what is blocked is shown with the reason", async (t) => {
  const { page, app } = await openApp(t, { address: WALL });
  await page.locator("#floor").focus();
  await page.keyboard.down("ArrowUp");
  await page.locator(".way.shut[data-way=forward]").waitFor({ state: "attached" });
  await app.poll(() => app.text("#blocked"), (text) => /^(Forward blocked: b|B)umper pressed/.test(text));
  assert.equal(await page.locator(".way.shut[data-way=backward]").count(), 0);
  await page.keyboard.up("ArrowUp");
  await page.keyboard.down("ArrowDown");
  await page.locator(".way.shut").first().waitFor({ state: "detached" });
  await page.keyboard.up("ArrowDown");
});

for (const [device, options] of [["laptop", { viewport: { width: 1440, height: 900 } }], ["phone", { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }]]) {
  test(`on a ${device} the joystick and its notes lie beside the room`, async (t) => {
    const { page, app, screenshot } = await openApp(t, { ...options, address: "#room=flat&behaviour=manual" });
    await page.locator("#pad").waitFor();
    /** How many colours the canvas has under them: one, where there is no room. */
    const colours = () =>
      page.evaluate(() => {
        const floor = document.getElementById("floor");
        const [stage, at] = [floor, document.getElementById("manual")].map((node) => node.getBoundingClientRect());
        const ratio = floor.width / stage.width;
        const box = [at.left - stage.left, at.top - stage.top, at.width, at.height].map((length) => Math.round(length * ratio));
        const { data } = floor.getContext("2d").getImageData(...box);
        return new Set(new Uint32Array(data.buffer)).size;
      });
    await app.poll(colours, (count) => count === 1, "nothing under them");
    await screenshot(`manual-${device}`);
    // Other tools have all of the floor.
    await app.tool("wall");
    await page.locator("#manual").waitFor({ state: "hidden" });
  });
}

test("a gamepad drives, and its dead zone doesn't", async (t) => {
  const { page, app } = await openApp(t, {
    address: ROOM,
    init: () => {
      const pad = { connected: true, axes: [0.1, -0.1], buttons: [] };
      Object.assign(globalThis, { testPad: pad });
      navigator.getGamepads = () => /** @type {any} */ ([null, pad]);
    },
  });
  await app.poll(() => app.text("#manual-note"), (text) => /Gamepad connected/.test(text));
  await app.frames(30);
  assert.equal((await app.numbers()).distance, 0);
  await page.evaluate(() => (globalThis.testPad.axes = [0, -1]));
  await app.numbersThat(({ distance }) => distance > 0.2);
  await page.evaluate(() => (globalThis.testPad.axes = [0, 0]));
  await stands(app);
});

test("what was driven by hand is driven again after scrubbing", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await page.locator("#floor").focus();
  await page.keyboard.down("ArrowUp");
  await app.numbersThat(({ distance }) => distance > 0.5);
  await page.keyboard.up("ArrowUp");
  await stands(app);
  await app.pause();
  const end = await app.numbers();
  await app.scrub(0.015);
  const early = await app.numbersThat((now, then) => now.distance < then.distance, end);
  assert.ok(early.time < end.time);
  await page.locator("#scrubber").focus();
  await page.keyboard.press("End");
  await app.settled();
  assert.deepEqual(await app.numbers(), end);
});
