// The robot picked up and put down elsewhere while it runs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

/** A room whose middle is the middle of the floor, and a robot that waits there for a person to drive it. */
const ROOM = "#room=empty&behaviour=manual&start=2.5,2.0,0";
const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };

/** Opens the room; without the joystick, beside which it would not be in the middle. */
async function openWaiting(t, options = {}) {
  const opened = await openApp(t, { address: ROOM, ...options });
  await opened.page.addStyleTag({ content: "#manual { display: none !important; }" });
  await opened.app.frames(3);
  return opened;
}

const events = async (page) => (await page.locator("#events li:not([hidden])").allInnerTexts()).join("\n");
const error = async (app) => {
  const { soFar } = await app.metric("Position error");
  return Number.parseFloat(soFar) * (/ cm$/.test(soFar) ? 0.01 : 1);
};

test("a running robot is dragged elsewhere: its wheels drop meanwhile, and it no longer knows where it is", async (t) => {
  const { page, app } = await openWaiting(t);
  await app.numbersThat(({ time }) => time > 0);
  const start = (await app.link()).start;
  const { mouse } = page;
  await mouse.move(...(await app.spot(0.5, 0.5)));
  await mouse.down();
  await mouse.move(...(await app.spot(0.4, 0.35)), { steps: 6 });
  await page.locator("#dashboard .wheel.on").first().waitFor({ state: "attached" });
  assert.equal(await app.text("#activity"), "In your hand");
  await mouse.up();
  await app.poll(() => events(page), (text) => /lifted/.test(text) && /put down/.test(text) && /wheel drop/.test(text));
  assert.ok((await error(app)) > 0.4, "its estimate stays where it was lifted");
  assert.equal((await app.link()).start, start, "the start stays");
  await app.poll(() => page.locator("#dashboard .wheel").first().getAttribute("class"), (name) => name !== "wheel on");
});

test("a click on the robot does nothing to it", async (t) => {
  const { page, app } = await openWaiting(t);
  await app.numbersThat(({ time }) => time > 0);
  await page.mouse.click(...(await app.spot(0.5, 0.5)));
  await app.frames(20);
  assert.doesNotMatch(await events(page), /lifted/);
});

test("the robot is picked up and carried by keys, and escape puts it back", async (t) => {
  const { page, app } = await openWaiting(t);
  await app.numbersThat(({ time }) => time > 0);
  await app.press("Lift robot");
  await page.locator("#carry-note").waitFor();
  for (let i = 0; i < 8; i += 1) await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("Enter");
  await page.locator("#carry-note").waitFor({ state: "hidden" });
  await app.poll(() => error(app), (metres) => metres > 0.5);

  const before = await error(app);
  await page.keyboard.press("p");
  await page.locator("#carry-note").waitFor();
  for (let i = 0; i < 8; i += 1) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Escape");
  await page.locator("#carry-note").waitFor({ state: "hidden" });
  await app.frames(5);
  assert.ok(Math.abs((await error(app)) - before) < 0.3, "it stands where it stood");
});

for (const isPaused of [false, true]) {
  test(`a click puts the held robot down, ${isPaused ? "while time stands still" : "while it runs"}`, async (t) => {
    const { page, app } = await openWaiting(t, { viewport: { width: 1366, height: 768 } });
    await app.numbersThat(({ time }) => time > 0);
    if (isPaused) await app.pause();
    await app.press("Lift robot");
    await page.locator("#carry-note").waitFor();
    await page.mouse.click(...(await app.spot(0.62, 0.4)));
    await page.locator("#carry-note").waitFor({ state: "hidden" });
    await page.getByRole("button", { name: "Lift robot" }).waitFor();
    if (isPaused) {
      // Its readings are as old as the last step, and so is its estimate; but it was put down.
      await app.poll(() => page.locator("#activity").textContent(), (text) => !/wait|hand/i.test(text));
      await app.press("Play");
    }
    await app.poll(() => error(app), (metres) => metres > 0.5);
  });
}

test("a robot with a plan is carried at the pointer, and the page says that it searches for its dock", async (t) => {
  const { page, app, screenshot } = await openApp(t, { viewport: { width: 1440, height: 900 } });
  await app.press("Lift robot");
  assert.equal(await page.locator("#tools [aria-pressed=true]").count(), 1, "one thing at a time is chosen");
  await page.locator("#carry-note").waitFor();
  await app.frames(3);
  // The whole room gives way to the note; a part of it can't, so the note makes way for the robot.
  const beside = () =>
    page.evaluate(() => {
      const [note, floor] = ["carry-note", "floor"].map((id) => document.getElementById(id).getBoundingClientRect());
      const canvas = document.getElementById("floor");
      const scale = canvas.width / floor.width;
      const [x, y, width, height] = [note.left - floor.left, note.top - floor.top, note.width, note.height].map((side) => Math.round(side * scale));
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
      copy.drawImage(canvas, 0, 0);
      const { data } = copy.getImageData(x, y, width, height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
  await screenshot("carry-note");
  await app.poll(beside, (colours) => colours === 1, "nothing but the ground under the note");
  await app.press("Zoom in");
  await page.locator("#floor").focus();
  const tops = [];
  for (const share of [0.8, 0.2]) {
    const [x, y] = await app.spot(0.3, share);
    await page.mouse.move(x, y, { steps: 3 });
    await app.frames(3);
    const note = await page.locator("#carry-note").boundingBox();
    assert.ok(y < note.y || y > note.y + note.height, `the note hides the robot at ${y}: ${JSON.stringify(note)}`);
    tops.push(note.y);
  }
  assert.ok(tops[0] < tops[1], "it steps aside");
  // On this spot, and not where it stood.
  await page.mouse.down();
  await page.mouse.up();
  await page.locator("#carry-note").waitFor({ state: "hidden" });
  await app.poll(() => error(app), (metres) => metres > 0.5);
  await app.says(/senses that it was lifted, but not where it is\. It searches for its dock/);
  await page.locator("#senses-fold summary").click();
  await app.poll(() => events(page), (text) => /put down, .*dock/.test(text));
  // In another tab it would mean nothing.
  await page.locator("#tab-compare").click();
  await page.locator("#message").waitFor({ state: "hidden" });
  await page.locator("#tab-explore").click();
  await app.says(/It searches for its dock/);
});

test("before the run begins, dragging the robot moves the start", async (t) => {
  const { app } = await openWaiting(t);
  await app.press("Back to the start");
  await app.until("ready");
  await app.drag([0.5, 0.5], [0.6, 0.4]);
  await app.linked("start", (text) => Number(text.split(",")[0]) > 2.6);
});

test("a finger picks the robot up, too", async (t) => {
  const { page, app } = await openWaiting(t, PHONE);
  await app.numbersThat(({ time }) => time > 0);
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await touch("touchStart", await app.spot(0.5, 0.5));
  for (const share of [0.45, 0.4, 0.35]) await touch("touchMove", await app.spot(share, 0.5));
  await touch("touchEnd");
  await app.poll(() => error(app), (metres) => metres > 0.3);
});
