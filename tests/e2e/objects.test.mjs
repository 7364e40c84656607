// Furniture, docks and movers: placed, moved, saved, and refused where they don't fit.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { anyFile } from "./maps.mjs";

// A behaviour has nothing to plan.
const ROOM = "#room=empty&behaviour=bounce&speed=1";

/** Names in the menu of objects; the first entry is that nothing is selected. */
const names = (page) => page.locator("#selected option").allTextContents().then((all) => all.slice(1));

/** Chooses what is placed, and waits until the tool is there. */
async function placing(app, kind) {
  await app.tool("place");
  await app.page.locator(`#kinds [data-kind=${kind}]`).click();
  await app.page.locator(`#kinds [data-kind=${kind}][aria-pressed=true]`).waitFor();
}

const selected = (page) => page.locator("#selected").evaluate((menu) => menu.selectedOptions[0]?.textContent);

/** The content of a saved scenario. */
async function saved(app) {
  const [download] = await app.save("scenario");
  return fs.readFileSync(await download.path(), "utf8");
}

test("places, moves, undoes, deletes and saves objects with the mouse", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await app.pause();
  await placing(app, "furniture");
  await app.drag([0.45, 0.4], [0.6, 0.5]);
  assert.equal(await selected(page), "Furniture");
  const before = JSON.parse(await saved(app)).objects;
  assert.equal(before[0].furniture.outline.length, 4);
  assert.equal(await app.room(), "Empty room (changed)");
  assert.match(await app.text("#room-note"), /^\d/, "it isn't without obstacles any more");

  // With the view tool it is dragged by its middle.
  await app.tool("view");
  await app.drag([0.525, 0.45], [0.6, 0.6]);
  const after = JSON.parse(await saved(app)).objects;
  const [x, y] = [0, 1].map((axis) => after[0].furniture.outline[0][axis] - before[0].furniture.outline[0][axis]);
  assert.ok(x > 0.1 && y < -0.1, `right and down: ${x} ${y}`);
  await app.press("Undo");
  await app.settled();
  assert.deepEqual(JSON.parse(await saved(app)).objects, before);
  await app.press("Redo");
  await app.settled();
  assert.deepEqual(JSON.parse(await saved(app)).objects, after);

  await placing(app, "pet");
  await app.drag([0.3, 0.7], [0.4, 0.7]);
  assert.deepEqual(await names(page), ["Furniture", "Pet"]);
  await app.tool("wall");
  await app.drag([0.35, 0.6], [0.35, 0.8]);
  await app.says(/^The pet walks here: a wall at .* Move the pet's path first\.$/);
  await app.press("Undo");
  await app.settled();

  await app.settled();
  assert.deepEqual(await names(page), ["Furniture"]);
  assert.match(await page.locator("#floor").getAttribute("aria-label"), /furniture/);
});

test("works without a mouse", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await app.pause();
  await page.locator("#floor").focus();
  await page.keyboard.press("o");
  await page.locator("#kinds [aria-pressed=true]").waitFor();
  await page.keyboard.press("Enter");
  await app.settled();
  assert.equal(await selected(page), "Furniture");
  const corner = async () => JSON.parse(await saved(app)).objects[0].furniture.outline[0];
  const [x, y] = await corner();
  await page.locator("#floor").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  const moved = await corner();
  assert.ok(moved[0] > x && moved[1] > y, `${moved}`);
  await page.locator("#floor").focus();
  await page.keyboard.press("Escape");
  await app.poll(() => selected(page), (name) => name === "Nothing selected");
  await page.keyboard.press("n");
  await app.poll(() => page.locator("#selection-said").textContent(), (text) => /^Furniture selected/.test(text));
  await page.keyboard.press("Shift+ArrowLeft");
  await app.settled();
  assert.notDeepEqual(await corner(), moved);
  await page.locator("#floor").focus();
  await page.keyboard.press("Delete");
  await app.settled();
  assert.deepEqual(await names(page), []);
});

test("the legend names what is on the floor, and the bar of a selected object doesn't lie on the room", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=living&behaviour=bounce&speed=1", viewport: { width: 1440, height: 900 } });
  await app.pause();
  const legend = await page.locator("#legend").innerText();
  for (const name of ["Furniture", "Pet", "Carpet", "Dirt", "Dock"]) assert.ok(legend.includes(name), `${name} in ${legend}`);
  assert.doesNotMatch(legend, /Person|Low obstacle/);
  await page.locator("#floor").focus();
  await page.keyboard.press("n");
  await page.locator("#selection").waitFor();
  /** Colours of the floor's picture below the bar: without the room there is one. */
  const covered = () =>
    page.evaluate(() => {
      const [floor, bar] = ["floor", "selection"].map((id) => document.getElementById(id));
      const [at, it] = [floor.getBoundingClientRect(), bar.getBoundingClientRect()];
      const { data } = floor.getContext("2d").getImageData(it.left - at.left, it.top - at.top, it.width, it.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
  await app.poll(covered, (colours) => colours === 1);
});

test("what can't be there says why, and what is kept survives a reload", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await app.pause();
  await placing(app, "dock");
  await app.drag([0.5, 0.5], [0.6, 0.5]);
  await placing(app, "furniture");
  await app.drag([0.45, 0.65], [0.6, 0.45]);
  await app.says(/^The dock at .* faces furniture/);
  assert.deepEqual(await names(page), ["Dock"]);
  const kept = JSON.parse(await saved(app)).objects;

  await app.linked("room", (room) => room === "own");
  // It is kept twice a second.
  await page.waitForFunction(() => Object.entries(localStorage).some(([key, text]) => key.startsWith("own-room-") && text.includes('"dock"')));
  await page.reload();
  await app.settled();
  assert.deepEqual(JSON.parse(await saved(app)).objects, kept);
});

test("a scenario that can't be is refused with path, line and reason, and the room stays", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=living&behaviour=bounce&speed=1" });
  await app.pause();
  const text = await saved(app);
  const [room, area] = [await app.room(), await app.reachableArea()];
  const cases = [
    ['"version": 2', '"version": 9', /line \d+, column \d+, version: this scenario has version 9/],
    ['"radius": 0.015', '"radius": -1', /objects\[\d+\]\.leg\.radius: -1 is out of range; use metres from 0\.005 to 5/],
    ['"radius": 0.015', '"radius": 1e999', /objects\[\d+\]\.leg\.radius: number out of range/],
    ['"dock": { "x": 0.0', '"dock": { "x": -3.0', /objects\[\d+\]\.dock: .* lies outside the room/],
    ['"name":', '"nam":', /nam: unknown field/],
  ];
  for (const [from, to, reason] of cases) {
    assert.ok(text.includes(from), from);
    await app.drop(anyFile("bad.json", text.replace(from, to)));
    await app.says(reason);
    assert.deepEqual([await app.room(), await app.reachableArea()], [room, area], to);
  }
  await app.drop(anyFile("good.json", text));
  assert.equal(await app.message(), "");
  assert.match(await app.room(), /^Living room with a cat/);
});

test("placing works by touch on a phone", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM, viewport: { width: 390, height: 844 }, hasTouch: true });
  await app.pause();
  await app.tool("place");
  await page.locator("#kinds [data-kind=table]").tap();
  await page.locator("#kinds [data-kind=table][aria-pressed=true]").waitFor();
  assert.equal(await page.locator("#selection").isVisible(), false, "over the floor only while something is selected");
  await page.touchscreen.tap(...(await app.spot(0.5, 0.55)));
  await app.settled();
  assert.deepEqual(await names(page), ["Leg 1", "Leg 2", "Leg 3", "Leg 4"]);
  for (const button of await page.locator("#selection button").all()) {
    const { width, height } = await button.boundingBox();
    assert.ok(width >= 40 && height >= 40, `${width} x ${height}`);
  }
  await page.locator("#selection").getByRole("button", { name: "Delete" }).tap();
  await app.settled();
  assert.equal((await names(page)).length, 3);
});

test("who is placed outside the room is told in plain words that nobody was", async (t) => {
  const { page, app } = await openApp(t, { address: ROOM });
  await app.pause();
  await placing(app, "person");
  await page.mouse.click(...(await app.spot(0.02, 0.5)));
  await app.says(/^Not placed: that is outside the room\. Click on free floor\.$/);
  assert.deepEqual(await names(page), []);
  // The room gives way to the message.
  await page.mouse.click(...(await app.spot(0.5, 0.7)));
  await app.settled();
  assert.deepEqual([await names(page), await app.message()], [["Person"], ""]);
});

test("the scale bar is there on every screen, beneath the robot", async (t) => {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1000, height: 640 }, { width: 844, height: 390 }, { width: 390, height: 844 }]) {
    const { page, app, screenshot } = await openApp(t, { address: ROOM, viewport });
    await app.pause();
    // The room is small then, and no line but the bar's is at the lower right.
    await page.locator("#floor").focus();
    for (let times = 0; times < 5; times += 1) await page.keyboard.press("-");
    const longest = () =>
      page.evaluate(() => {
        const floor = document.getElementById("floor");
        const copy = Object.assign(document.createElement("canvas"), { width: floor.width, height: floor.height });
        const context = copy.getContext("2d");
        context.drawImage(floor, 0, 0);
        const ratio = floor.width / floor.clientWidth;
        const [left, top] = [Math.round(floor.width / 3), Math.round(floor.height - 90 * ratio)];
        const { data, width, height } = context.getImageData(left, top, floor.width - left, floor.height - top);
        let longest = 0;
        for (let y = 0; y < height; y += 1) {
          let run = 0;
          for (let x = 0; x < width; x += 1) longest = Math.max(longest, (run = data[4 * (y * width + x)] < 130 ? run + 1 : 0));
        }
        return longest / ratio;
      });
    await app.poll(longest, (length) => length >= 40 && length <= 140);
    await screenshot(`scale-bar-${viewport.width}`);
  }
});
