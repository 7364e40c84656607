// The tab Robot, with the virtual robot: control, driving, rides, and the stop.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { Robot, openRobot } from "./connection.mjs";
import { messagesOf } from "./mcap.mjs";

test("is driven by keys, and space stops it wherever the focus is", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  // The focus is still on the button that took control.
  await page.keyboard.down("ArrowUp");
  await robot.drives(0.2);
  // It drove while the key is still down, so the page says so with its next frame.
  await page.waitForFunction(() => document.getElementById("connection-doing")?.innerText === "You drive");
  assert.equal(await page.locator("#connection-pad .way.used").count(), 1);
  await page.keyboard.up("ArrowUp");
  await robot.rests();
  assert.equal(await page.locator("#connection-pad .way.used").count(), 0, "no arrow stays lit");
  assert.match(await page.locator("#connection-doing").innerText(), /^Ready/);
  // On the button that would start a ride: it must not.
  await page.locator("#connection-go").focus();
  await page.keyboard.press("Space");
  await page.waitForTimeout(600);
  assert.equal(await page.locator("#connection-go").getAttribute("aria-disabled"), "false", "space didn't press it");
  await robot.rests();
});

test("is driven by the joystick on the screen", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  const box = await page.locator("#connection-pad").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + 4, { steps: 4 });
  await robot.drives(0.2);
  await page.mouse.up();
  await robot.rests();
});

test("lets a behaviour drive, and Stop ends it for good", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  await page.locator("#connection-go").click();
  await robot.drives(0.5);
  assert.notEqual(await page.locator("#connection-time").textContent(), "–");
  await page.locator("#connection-stop").click();
  await robot.rests();
  await page.locator("#connection-go").focus();
  await page.keyboard.press("Enter");
  assert.match(await page.locator("#connection-ask-title").innerText(), /isn't at the start/);
  await page.locator("#connection-ask-other").click();
  await robot.drives(await robot.distance());
  await page.keyboard.press("Escape");
  await robot.rests();
});

test("stops when one leaves the tab", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  await page.locator("#connection-go").click();
  await robot.drives(0.2);
  await page.locator("#tab-compare").click();
  await page.locator("body[data-tab=compare]").waitFor();
  await page.waitForTimeout(300);
  await page.locator("#tab-connection").click();
  await robot.rests();
});

test("drives a planned path", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  await page.locator("#connection-algorithm").selectOption("boustrophedon");
  await page.locator("#connection-go").click();
  await robot.drives(0.2);
  assert.ok(Number(await page.locator("#connection-swept").textContent()) > 0.1);
  await page.keyboard.press("Space");
  await robot.rests();
});

test("a lifted robot tells why it lost control, and gives it back", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  await page.locator("#hand-lift").click();
  await page.locator("#connection-drop").waitFor();
  assert.match(await page.locator("#connection-drop-text").innerText(), /wheel|lift/i);
  await page.locator("#hand-lift").click();
  await page.locator("#connection-rearm").click();
  await robot.mode("Safe");
  await page.locator("#connection-drop").waitFor({ state: "hidden" });
});

test("by keyboard alone", async (t) => {
  const { page, app } = await openRobot(t);
  const robot = new Robot(page, app);
  await page.locator("#tab-connection").focus();
  const reach = async (id) => {
    for (let presses = 0; presses < 60; presses += 1) {
      if ((await page.evaluate(() => document.activeElement?.id)) === id) return;
      await page.keyboard.press("Tab");
    }
    assert.fail(`#${id} is not reached`);
  };
  await reach("connection-virtual");
  await page.keyboard.press("Enter");
  await robot.mode("Passive");
  await page.locator("#tab-connection").focus();
  await reach("connection-arm");
  await page.keyboard.press("Enter");
  await robot.mode("Safe");
  await page.locator("#connection-pad").waitFor();
  await reach("connection-floor");
  await page.keyboard.down("ArrowUp");
  await robot.drives(0.1);
  await page.keyboard.press("Space");
  await page.keyboard.up("ArrowUp");
  await robot.rests();
  await reach("connection-tools-open");
  await page.keyboard.press("Enter");
  await page.locator("#console-lines li").first().waitFor();
});

test("after Disconnect the console is empty and the map has no robot, and a new connection has its own", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  await page.locator("#connection-go").click();
  await robot.drives(0.1);
  await page.locator("#connection-tools-open").click();
  const lines = page.locator("#console-lines li");
  await lines.filter({ hasText: "Safe" }).first().waitFor();
  await page.getByRole("button", { name: "Disconnect" }).click();
  await robot.phase("closed");
  await page.locator("#connection-tools-open").click();
  await page.locator("#console-lines").waitFor({ state: "attached" });
  await robot.app.frames(10);
  assert.equal(await lines.count(), 0);
  // Its last readings, which came after the end, brought it back.
  const described = () => page.locator("#connection-floor").getAttribute("aria-label");
  await robot.app.poll(described, (text) => text === "Live map of Empty room: no robot");
  await robot.connect();
  await lines.first().waitFor();
  assert.equal(await lines.filter({ hasText: "Safe" }).count(), 0);
});

test("an unknown room is paper that grows", async (t) => {
  const { page, robot } = await openRobot(t);
  await page.locator("#connection-room").selectOption("blank");
  await robot.connect();
  await robot.arm();
  await page.locator("#connection-go").click();
  await robot.drives(0.5);
  await page.keyboard.press("Space");
  await robot.rests();
  assert.equal(await page.locator("#connection-swept-unit").textContent(), "m²");
  assert.ok(Number(await page.locator("#connection-swept").textContent()) >= 0.1);
});

test("a session is recorded, and replayed", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  await page.locator("#connection-floor").focus();
  await page.keyboard.down("ArrowUp");
  await robot.drives(0.2);
  await page.keyboard.up("ArrowUp");
  await robot.rests();
  const driven = await robot.distance();
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#connection-save").click()]);
  const file = await download.path();
  assert.match(fs.readFileSync(file, "utf8"), /^robovac-oi-recording 1/);
  await page.locator("#connection-close").click();
  await page.locator("#connection-welcome").waitFor();
  await page.locator("#replay-file").setInputFiles(file);
  await page.locator("#replay-speed").selectOption("16");
  await page.waitForFunction((metres) => Math.abs(Number(document.getElementById("connection-distance").textContent) - metres) < 0.11, driven);
  // What happened leads to its moment, where it stands as it has ended.
  await page.locator("#replay-play", { hasText: "Play" }).waitFor();
  await page.locator("#replay-timeline button", { hasText: "Driven" }).click();
  await robot.app.poll(() => robot.distance(), (metres) => metres < 0.01);
  await robot.mode("Safe");
  assert.match(await page.locator("#connection-doing-note").textContent(), /^Safe: the page was in control/);
  assert.equal(await page.locator("#replay-timeline [aria-current=true]").count(), 1);
  assert.match(await page.locator("#replay-summary").textContent(), / m driven, 0 bumps, battery /);
  const [table] = await Promise.all([page.waitForEvent("download"), page.locator("#replay-csv").click()]);
  assert.match(table.suggestedFilename(), /\.csv$/);
  assert.match(fs.readFileSync(await table.path(), "utf8"), /^time \(s\),mode,pose_x \(m\),.*\n[\d.]+,Passive,/);
  const [bag] = await Promise.all([page.waitForEvent("download"), page.locator("#replay-bag").click()]);
  const messages = messagesOf(fs.readFileSync(await bag.path()));
  for (const topic of ["/odom", "/tf", "/cmd_vel", "/bumper", "/cliff", "/battery_state", "/mode", "/rosout"]) assert.ok(messages[topic], `${topic}: ${Object.keys(messages)}`);
  await page.locator("#connection-close").click();
  await page.locator("#connection-welcome").waitFor();
});
