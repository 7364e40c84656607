// Changing the room on the floor itself.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { openRoom, textMap } from "./maps.mjs";

test("draws and erases walls with the mouse, and takes it back", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty" });
  const whole = await app.reachableArea();
  await app.tool("wall");
  await app.drag([0, 0.5], [1, 0.5]);
  const half = await app.reachableArea();
  assert.ok(half < 0.7 * whole && half > 0.3 * whole, `${half} m² of ${whole} m²`);
  assert.equal(await app.message(), "");

  await app.press("Undo");
  await app.settled();
  assert.equal(await app.reachableArea(), whole);
  await app.press("Redo");
  await app.settled();
  assert.equal(await app.reachableArea(), half);

  await app.tool("erase");
  await app.drag([0, 0.5], [1, 0.5]);
  assert.ok((await app.reachableArea()) > half);
  // The picture has no numbers to read, but drawing must not have cost the run.
  await app.poll(() => app.numbers(), ({ distance }) => distance > 0);
  assert.ok(await page.locator("#redo").isDisabled());
});

test("moves the start, and the robot stands where it was dropped", async (t) => {
  const { app } = await openApp(t, { address: "#room=empty" });
  await app.pause();
  await app.tool("start");
  await app.drag([0.5, 0.5], [0.5, 0.3]);
  const first = await app.linked("start");
  const start = first.split(",").map(Number);
  assert.ok(Math.abs(start[0] - 2.5) < 0.2 && Math.abs(start[1] - 2) < 0.2, `in the middle: ${start}`);
  assert.ok(Math.abs(start[2] - 90) < 10, `turned the way of the drag: ${start}`);

  // The robot is now in the middle, and the view tool drags it.
  await app.tool("view");
  await app.drag([0.5, 0.5], [0.55, 0.6]);
  const moved = (await app.linked("start", (text) => text !== first)).split(",").map(Number);
  assert.ok(moved[0] > start[0] + 0.1 && moved[1] < start[1] - 0.1, `${moved} is right of and below ${start}`);

  await app.press("Undo");
  await app.linked("start", (text) => text === first);
});

test("a start in a wall is refused with a reason, and the old one stays", async (t) => {
  const { app } = await openApp(t, { address: "#room=empty" });
  await app.pause();
  const area = await app.reachableArea();
  await app.tool("start");
  await app.drag([0.005, 0.5], [0.005, 0.5]);
  await app.says(/[Ss]tart .*(wall|outside|fit)/);
  assert.equal((await app.link()).start, undefined);
  assert.equal(await app.reachableArea(), area);
});

test("walling the robot in says what to do, and undo helps", async (t) => {
  const { app } = await openApp(t);
  await app.drop(textMap("closet.txt", openRoom(3, 3)));
  await app.says(/robot.*fits nowhere/);
  assert.equal(await app.state(), "failed");
  await app.press("Undo");
  assert.equal(await app.settled(), "playing");
  assert.equal(await app.message(), "");
});

test("wheel, buttons and keys zoom, and 0 shows the whole room again", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty" });
  await app.pause();
  const picture = async () => {
    await app.frames(3);
    const pixels = await page.locator("#floor").evaluate((canvas) => canvas.toDataURL());
    return createHash("sha256").update(pixels).digest("hex");
  };
  const whole = await picture();
  await page.mouse.move(...(await app.spot(0.5, 0.5)));
  await page.mouse.wheel(0, -300);
  assert.notEqual(await picture(), whole);
  await page.keyboard.press("0");
  assert.equal(await picture(), whole);
  await app.press("Zoom in");
  assert.notEqual(await picture(), whole);
  await app.press("Whole room");
  assert.equal(await picture(), whole);
});
