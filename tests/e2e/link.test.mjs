// Every view is a link.
import assert from "node:assert/strict";
import { test } from "node:test";
import { App, openApp } from "./app.mjs";
import { openPage } from "./harness.mjs";

const LINK = { room: "lshape", planner: "snake", robot: "cell", cell: "0.2", seed: "11", slip: "typical", odometry: "straight", start: "1.100,1.100,90.0", speed: "4" };
const address = `#${Object.entries(LINK).map((pair) => pair.join("=")).join("&")}`;

test("a link brings back room, algorithm, robot and settings, also below a folder", async (t) => {
  const { page, app } = await openApp(t, { address, mount: "/some/sub/path/" });
  assert.equal(await app.room(), "L-shaped room");
  const shown = (menu) => page.locator(`#${menu}`).inputValue();
  assert.deepEqual(await Promise.all(["algorithm", "robot", "cell-size", "seed", "slip", "odometry", "speed"].map(shown)), ["snake", "cell", "0.2", "11", "typical", "straight", "4"]);
  await app.linked("speed");
  assert.deepEqual(await app.link(), LINK);
  assert.ok(await page.locator("#undo").isDisabled(), "there is nothing to undo on a page just opened");
  // Reloading, and following another link, work alike.
  await page.reload();
  await app.until("playing");
  assert.deepEqual(await app.link(), LINK);
  await page.evaluate(() => (location.hash = "room=empty"));
  await page.waitForFunction(() => document.getElementById("room").value === "empty");
  assert.equal(await app.settled(), "playing");
});

test("the copied link opens the same room", async (t) => {
  const { page, app } = await openApp(t, { permissions: ["clipboard-read", "clipboard-write"] });
  await app.choose("room", "spiral");
  await page.getByRole("button", { name: "Copy link" }).click();
  const copied = await app.poll(() => page.evaluate(() => navigator.clipboard.readText()), (text) => /#room=spiral&/.test(text));
  await page.goto("about:blank");
  await page.goto(copied);
  await app.until("playing");
  assert.equal(await app.room(), "Spiral corridor");
});

test("the copied link opens at the moment that is shown, and says when it can't", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=lshape&behaviour=bounce&speed=16", permissions: ["clipboard-read", "clipboard-write"] });
  await app.numbersThat(({ time }) => time >= 60);
  await page.keyboard.press("Space");
  await app.until("paused");
  const shown = await app.numbers();
  const ways = page.locator("#ways");
  const copy = async () => {
    await page.getByRole("button", { name: "Copy link" }).click();
    await ways.waitFor();
    const said = await ways.innerText();
    await page.keyboard.press("Escape");
    return { said, link: await page.evaluate(() => navigator.clipboard.readText()) };
  };
  const { said, link } = await copy();
  assert.match(said, /It opens at \d+:\d\d, as here/);
  await page.goto("about:blank");
  await page.goto(link);
  await app.until("paused");
  assert.deepEqual(await app.numbers(), shown);
  // The address is that of the settings again.
  await app.poll(() => page.url(), (address) => !address.includes("moment"));
  // Whoever plays on and lifts the robot has a run of their own.
  await page.locator("#lift").click();
  await app.until("playing", "paused");
  const { said: lifted, link: plain } = await copy();
  assert.match(lifted, /The run starts again there/);
  assert.ok(!plain.includes("moment"), plain);
});

test("a drawn room survives a reload, and its link brings it elsewhere", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&speed=4", viewport: { width: 1366, height: 768 } });
  const before = await app.reachableArea();
  await app.tool("wall");
  // One stroke, which is kept twice before it ends.
  const kept = () => page.evaluate(() => Object.entries(localStorage).find(([key]) => /^own-room-\w+$/.test(key))?.[1] ?? "");
  await page.mouse.move(...(await app.spot(0.5, 0.1)));
  await page.mouse.down();
  for (const y of [0.3, 0.45]) {
    const last = await kept();
    await page.mouse.move(...(await app.spot(0.5, y)), { steps: 4 });
    await app.poll(kept, (now) => now !== last);
  }
  await page.mouse.move(...(await app.spot(0.5, 0.6)), { steps: 4 });
  await page.mouse.up();
  await app.settled();
  const drawn = await app.reachableArea();
  assert.ok(drawn < before, `${drawn} of ${before} m²`);
  assert.equal(await app.linked("room", (room) => room === "own"), "own");
  await app.linked("map");
  const address = page.url();
  await page.reload();
  await app.until("playing");
  assert.equal(await app.reachableArea(), drawn);
  // What was done before can still be undone, and done again.
  await page.locator("#undo:enabled").click();
  await app.poll(() => app.room(), (room) => room === "Empty room");
  assert.equal(await app.reachableArea(), before);
  await page.locator("#redo").click();
  await app.poll(() => app.reachableArea(), (area) => area === drawn);
  const elsewhere = await page.context().browser().newContext();
  const other = new App(await elsewhere.newPage());
  await other.page.goto(address);
  await other.linked("kept", (id) => id && !address.includes(id));
  await other.until("playing");
  assert.equal(await other.reachableArea(), drawn);
  // One that lacks the room, as older ones do, and one that was cut off, say so.
  await other.page.goto("about:blank");
  await other.page.goto(address.replace(/&(map|kept)=[^&]*/g, "").replace("room=own", "room=own&kept=gone"));
  await other.says(/drawn or loaded in another browser/);
  await other.page.goto("about:blank");
  await other.page.goto(address.replace(/(&map=[^&]{200})[^&]*/, "$1").replace(/&kept=[^&]*/, ""));
  await other.says(/damaged/);
  await elsewhere.close();
});

test("links with the tabs' older names open them", async (t) => {
  const { page } = await openPage(t, { address: "#room=empty&place=draft" });
  const app = new App(page);
  await page.locator("#panel-floor-plan").waitFor();
  assert.equal(await app.linked("tab", (tab) => tab === "floor-plan"), "floor-plan");
  await page.evaluate(() => (location.hash = "#room=empty&place=robot"));
  await page.locator("#panel-connection").waitFor();
  assert.equal(await app.linked("tab", (tab) => tab === "connection"), "connection");
});
