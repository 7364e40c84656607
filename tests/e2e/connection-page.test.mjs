// The tab Robot, with the virtual robot: connecting, tools, what it says and how it looks. Nothing moves here.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openRobot } from "./connection.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };
const LAPTOP = { viewport: { width: 1440, height: 900 } };

test("says what it is for, and connects to the virtual robot", async (t) => {
  const { page, robot } = await openRobot(t);
  assert.match(await page.locator("#connection-welcome h2").innerText(), /Drive a Roomba/);
  assert.equal(await page.locator("#connection-stop").isVisible(), false, "nothing to stop");
  assert.match(await page.locator("#connection-floor").getAttribute("aria-label"), /no robot/i);
  await robot.connect();
  assert.equal(await page.locator("#connection-welcome").isVisible(), false);
  assert.equal(await page.locator("#connection-stop").isVisible(), true);
  await page.waitForFunction(() => /estimated position/.test(document.getElementById("connection-floor").getAttribute("aria-label")));
  assert.equal(await page.locator("#connection-go").getAttribute("aria-disabled"), "true", "not in control yet");
  assert.equal(await robot.distance(), 0, "connecting doesn't move it");
  await page.locator("#connection-close").click();
  await page.locator("#connection-welcome").waitFor();
  assert.equal(await page.locator("#connection-stop").isVisible(), false);
});

test("Explore's keys rest while one is here", async (t) => {
  const { page, app, robot } = await openRobot(t);
  const keys = ["Space", ".", "r", "w", "Control+z"];
  await page.locator("#tab-explore").click();
  await app.until("playing", "paused");
  if ((await app.state()) === "playing") await page.getByRole("button", { name: "Pause" }).click();
  await app.until("paused");
  const { time } = await app.numbers();
  await page.locator("#tab-connection").click();
  for (const key of keys) await page.keyboard.press(key);
  await robot.connect();
  for (const key of keys) await page.keyboard.press(key);
  await page.locator("#tab-explore").click();
  await app.frames(3);
  assert.equal(await app.state(), "paused");
  assert.equal((await app.numbers()).time, time);
  assert.equal(await page.locator("#tools [data-tool=view]").getAttribute("aria-pressed"), "true");
  await page.locator("#tab-connection").click();
  await robot.phase("connected");
});

test("the console shows what is said, and asks before bytes that move the robot", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await page.locator("#connection-tools-open").click();
  await page.locator("#console-lines .line-sent").first().waitFor();
  const field = page.locator("#console-bytes");
  const told = page.locator("#console-parsed");
  await field.fill("142 300");
  assert.match(await told.innerText(), /Byte 2 \("300".*too large/);
  await field.fill("142, zz");
  assert.match(await told.innerText(), /Byte 2 \("zz", at character 6\).*a number/);
  await field.fill("8e");
  assert.match(await told.innerText(), /0x8e/);
  await page.locator("#console-send").click();
  assert.equal(await page.locator("#connection-ask").isVisible(), false);
  await field.fill("0x89 0 100");
  assert.match(await told.innerText(), /Drive \(137\).*lacks 2 bytes/);
  await page.keyboard.press("Enter");
  assert.equal(await page.locator("#connection-ask").isVisible(), false, "what is incomplete isn't sent");
  await field.fill("129 7");
  assert.match(await told.innerText(), /Baud \(129\) isn't sent/);
  await field.fill("0x89 0 100 128 0");
  await page.keyboard.press("Enter");
  await page.locator("#connection-ask").waitFor();
  await page.locator("#connection-ask-no").click();
  await field.fill("142 35");
  await page.keyboard.press("Enter");
  await page.locator("#console-kind").selectOption("sent");
  await page.waitForFunction(() => [...document.querySelectorAll("#console-lines code")].some((code) => /^8e 23/i.test(code.textContent)));
});

test("songs are read, and unclear notes are named", async (t) => {
  const { page } = await openRobot(t);
  await page.locator("#connection-tools-open").click();
  await page.locator("[data-panel=songs]").click();
  const text = page.getByLabel("Notes", { exact: true });
  await text.fill("C5:16 H3:2");
  assert.match(await page.locator("#song-told").innerText(), /Note 2 \("H3:2"\)/);
  await text.fill("");
  await page.getByRole("button", { name: "C4", exact: true }).click();
  assert.equal(await text.inputValue(), "C4:16");
});

test("Full is asked for, and files that are no recording are refused", async (t) => {
  const { page, robot } = await openRobot(t);
  await page.locator("#replay-file").setInputFiles({ name: "notes.txt", mimeType: "text/plain", buffer: Buffer.from("hello\n") });
  await page.waitForFunction(() => /not a recording/i.test(document.getElementById("message-text").textContent));
  await robot.connect();
  await page.locator("#connection-full").click();
  assert.match(await page.locator("#connection-ask-text").innerText(), /stairs/);
  await page.locator("#connection-ask-yes").click();
  await robot.mode("Full");
});

test("before the first real robot, it says what can happen", async (t) => {
  const { page } = await openRobot(t);
  await page.locator("#connection-serial").click();
  assert.match(await page.locator("#connection-ask-text").innerText(), /pulled cable/);
  assert.equal(await page.evaluate(() => document.activeElement?.id), "connection-ask-no", "the harmless answer is at hand");
  await page.keyboard.press("Escape");
  await page.locator("#connection-ask").waitFor({ state: "hidden" });
  assert.equal(await page.locator("#connection-welcome").isVisible(), true);
});

test("a browser without serial ports says what works instead", async (t) => {
  const init = () => ["serial", "usb"].forEach((name) => Object.defineProperty(Navigator.prototype, name, { get: () => undefined }));
  const { page, robot } = await openRobot(t, { init });
  assert.match(await page.locator("#connection-unsupported").innerText(), /virtual robot/);
  await page.locator("#connection-serial").click({ force: true });
  await page.locator("#message").waitFor();
  assert.match(await page.locator("#message-text").innerText(), /Web Serial/);
  await robot.connect();
});

test("on a phone, the page says which cables it can use, and asks WebUSB for them", async (t) => {
  const init = () => {
    window.asked = [];
    const asks = (way) => ({ get: () => Object.assign(new EventTarget(), { [way]: async (what) => (window.asked.push([way, what?.filters?.length]), Promise.reject(new DOMException("", "NotFoundError"))) }) });
    Object.defineProperty(Navigator.prototype, "usb", asks("requestDevice"));
    Object.defineProperty(Navigator.prototype, "serial", asks("requestPort"));
  };
  const userAgent = "Mozilla/5.0 (Linux; Android 10; K) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/150.0.0.0 Mobile Safari/537.36";
  const { page, screenshot } = await openRobot(t, { init, userAgent, ...PHONE });
  assert.match(await page.locator("#connection-usb").innerText(), /FTDI, CP210x, CH340 or PL2303/);
  await page.locator("#connection-serial").scrollIntoViewIfNeeded();
  await screenshot("robot-usb");
  await page.locator("#connection-serial").click();
  await page.locator("#connection-ask-yes").click();
  await page.waitForFunction(() => window.asked.length === 1);
  await page.locator("#connection-ports summary").click();
  await page.locator("#connection-other").click();
  await page.waitForFunction(() => window.asked.length === 2);
  const [[usb, filters], [serial]] = await page.evaluate(() => window.asked);
  assert.deepEqual([usb, serial], ["requestDevice", "requestPort"]);
  assert.ok(filters > 10);
});

test("a sleeping robot is told apart from a dead cable, and woken", async (t) => {
  const { page, robot } = await openRobot(t);
  await page.locator("#connection-personality").selectOption("no_brc");
  await page.locator("#connection-virtual").click();
  await robot.phase("waiting");
  assert.match(await page.locator("#connection-remedy").innerText(), /CLEAN/);
  assert.ok((await page.locator("#connection-tried li").count()) >= 4);
  await page.locator("#connection-picture[data-picture=asleep] svg").waitFor();
  await page.locator("#hand-clean").click();
  await robot.phase("connected");
});

/** Visible controls that are too small for a finger. */
const small = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("#panel-connection :is(button:not(.term), select, input, summary)")]
      .filter((node) => node.checkVisibility({ visibilityProperty: true }) && !node.closest(".piano"))
      .map((node) => ({ name: node.id || node.textContent, ...(({ width, height, x, y }) => ({ width, height, x, y }))((node.matches("[type=checkbox]") ? node.closest("label") : node).getBoundingClientRect().toJSON()) }))
      .filter(({ width, height }) => width > 0 && (height < 40 || width < 32)),
  );
const overflow = (page) => page.evaluate(() => [document.documentElement.scrollWidth - innerWidth, document.documentElement.scrollHeight - innerHeight]);

test("fits a phone, where the stop is over everything", async (t) => {
  const { page, robot, screenshot } = await openRobot(t, PHONE);
  assert.deepEqual(await overflow(page), [0, 0]);
  assert.deepEqual(await small(page), []);
  await robot.connect();
  await screenshot("phone-robot");
  for (const sheet of ["connection-setup", "connection-senses", "connection-virtual-panel", "connection-drawer"]) {
    await page.locator(`[data-sheet=${sheet}]`).tap();
    await page.locator(`#${sheet}.open`).waitFor();
    await screenshot(`phone-robot-${sheet}`);
    assert.deepEqual(await overflow(page), [0, 0], sheet);
    assert.deepEqual(await small(page), [], sheet);
    const isOnTop = await page.evaluate(() => {
      const stop = document.getElementById("connection-stop");
      const { x, y, width, height } = stop.getBoundingClientRect();
      return height >= 48 && stop.contains(document.elementFromPoint(x + width / 2, y + height / 2));
    });
    assert.ok(isOnTop, `the stop is hidden by ${sheet}`);
    await page.locator(`#${sheet} .sheet-close`).tap();
  }
});

test("fits a laptop without scrolling, in light and dark", async (t) => {
  const { page, robot, screenshot } = await openRobot(t, LAPTOP);
  await robot.connect();
  await page.locator("#connection-tools-open").click();
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    assert.deepEqual(await overflow(page), [0, 0]);
    await screenshot(`laptop-robot-${colorScheme}`);
  }
});

test("put at its start the robot believes to be there, and what calibrating asks for is measured on the virtual floor", async (t) => {
  const { page, robot } = await openRobot(t, { link: "room=empty&behaviour=bounce&start=1.5,2,0&slip=harsh&seed=6" });
  await robot.connect();
  await robot.arm();
  const toStart = page.locator("#connection-to-start");
  await toStart.waitFor({ state: "hidden" });
  await page.locator("#connection-floor").focus();
  await page.keyboard.press("ArrowLeft", { delay: 300 });
  await robot.rests();
  // A turn on the spot is not at the start, either.
  await toStart.click();
  await toStart.waitFor({ state: "hidden" });
  await page.waitForFunction(() => /estimated position 1\.50 m, 2\.00 m, heading 0 degrees/.test(document.getElementById("connection-floor").getAttribute("aria-label")));
  if (!(await page.locator("#connection-drawer").isVisible())) await page.locator("#connection-tools-open").click();
  await page.locator("#connection-tabs [data-panel=calibrate]").click();
  await page.locator("#connection-calibrate li[data-what=nudge] button").click();
  await page.locator("#calibrate-measured", { hasText: /^Measured on the virtual floor: turned \d+\.\d°\.$/ }).waitFor();
  const [question, panel] = [await page.locator("#calibrate-told").boundingBox(), await page.locator("#connection-calibrate").boundingBox()];
  assert.ok(question.y >= panel.y - 1 && question.y + question.height <= panel.y + panel.height + 1, "the question is out of view");
});
