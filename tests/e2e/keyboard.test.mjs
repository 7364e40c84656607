// Everything without a mouse.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

// Quick to plan, slow to clean.
const ROOM = "#room=empty&speed=1";

test("plays, steps and goes back by single keys", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await app.until("playing");
  await page.keyboard.press("Space");
  await app.until("paused");
  await page.keyboard.press("r");
  await app.until("ready");
  await page.keyboard.press(".");
  await app.until("paused");
  await page.keyboard.press("Space");
  await app.until("playing");
  for (const [key, tool] of [["w", "wall"], ["e", "erase"], ["s", "start"], ["v", "view"]]) {
    await page.keyboard.press(key);
    await page.waitForFunction((name) => document.querySelector(`#tools [data-tool=${name}]`).getAttribute("aria-pressed") === "true", tool);
  }
});

test("single keys can be switched off, and stay off", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await page.keyboard.press("?");
  await page.getByLabel("Single-key shortcuts work everywhere").uncheck();
  await page.keyboard.press("Escape");
  // Until it is closed the space key is for the box just unchecked.
  await page.getByRole("dialog").waitFor({ state: "hidden" });
  await page.keyboard.press("Space");
  await page.keyboard.press("w");
  await app.frames(3);
  assert.equal(await app.state(), "playing");
  await page.reload();
  await app.until("playing");
  assert.ok(!(await page.locator("#keys-on").isChecked()), "the choice is remembered");
  await page.keyboard.press("Space");
  await app.frames(3);
  assert.equal(await app.state(), "playing");
});

test("help opens by its key and closes by escape", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  const dialog = page.getByRole("dialog");
  assert.ok(!(await dialog.isVisible()));
  await page.keyboard.press("?");
  await dialog.waitFor();
  await dialog.getByText("play or pause").waitFor();
  const state = await app.state();
  await page.keyboard.press("r");
  assert.equal(await app.state(), state, "keys are for the dialog while it is open");
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "hidden" });

  await app.press("Help and keys");
  await dialog.waitFor();
  await dialog.getByRole("button", { name: "Close" }).click();
  await dialog.waitFor({ state: "hidden" });
});

test("everything is reached by tab, in the order in which it is seen", async (t) => {
  const { page } = await openApp(t, { address: ROOM });
  const seen = [];
  for (let i = 0; i < 80; i += 1) {
    await page.keyboard.press("Tab");
    const at = await page.evaluate(() => {
      const { activeElement: node } = document;
      if (!node || node === document.body) return null;
      const { width, height } = node.getBoundingClientRect();
      return { name: node.id || node.dataset.tool || node.textContent.trim(), outlined: getComputedStyle(node).outlineStyle !== "none", shown: width > 0 && height > 0 };
    });
    if (!at || at.name === seen[0]?.name) break;
    seen.push(at);
  }
  const names = seen.map(({ name }) => name);
  const main = ["Skip to the floor", "share", "theme", "help-open", "room", "load", "save", "algorithm", "robot", "floor", "view", "wall", "erase", "start", "zoom-in", "play", "step", "reset", "speed", "scrubber", "Coverage"];
  assert.deepEqual(names.filter((name) => main.includes(name)).slice(0, main.length), main, names.join(", "));
  assert.deepEqual(seen.filter(({ outlined }) => !outlined), [], "where the focus is can be seen");
  assert.deepEqual(seen.filter(({ shown }) => !shown), [], "what has the focus can be seen");
});

test("skipping to the floor leaves the run alone", async (t) => {
  const { page, app } = await openApp(t);
  const before = await app.numbers();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement.id === "floor");
  await app.frames(5);
  assert.ok((await app.numbers()).time >= before.time, "the run goes on");
});

test("the time line follows the arrow keys", async (t) => {
  const { page, app } = await openApp(t);
  await app.pause();
  const before = await app.numbers();
  await page.locator("#scrubber").focus();
  await page.keyboard.press("PageDown");
  await app.settled();
  const back = await app.numbersThat((now, then) => now.time < then.time, before);
  await page.keyboard.press("ArrowRight");
  await app.settled();
  await app.numbersThat((now, then) => now.time > then.time, back);
  await page.keyboard.press("End");
  await app.settled();
  assert.deepEqual(await app.numbers(), before);
  await page.keyboard.press("Home");
  await app.until("ready");
  assert.equal((await app.numbers()).time, 0);
  // What was recorded lies ahead.
  await page.keyboard.press("PageUp");
  await app.numbersThat((now) => now.time > 0);
});

test("draws walls by arrow keys and enter", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&robot=cell" });
  await app.pause();
  const cells = async () => (await app.metric("Cells visited")).plan;
  const before = await cells();
  await page.locator("#floor").focus();
  await page.keyboard.press("w");
  await page.locator("#tools [data-tool=wall][aria-pressed=true]").waitFor();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await app.settled();
  const after = await cells();
  assert.notEqual(after, before);
  await page.keyboard.press("Control+z");
  await app.settled();
  assert.equal(await cells(), before);
  await page.keyboard.press("Control+Shift+z");
  await app.settled();
  assert.equal(await cells(), after);
});
