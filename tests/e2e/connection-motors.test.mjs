// The tab Robot: brushes and vacuum of a robot that cleans, and what is shown of motors, lights and schedule.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openRobot } from "./connection.mjs";

/** A room with dirt in front of the robot. */
const DIRTY = "room=stairs&start=0.8,3.4,90&behaviour=bounce";

/** Waits for the share of the dirt that is left to be as wanted, per cent. */
const dirt = async ({ page, app }, fits) => app.poll(async () => Number(/Dirt left: (\d+) %/.exec(await page.locator("#hand-note").textContent())?.[1]), fits);
const tool = async (page, name) => {
  if (!(await page.locator("#connection-drawer").isVisible())) await page.locator("#connection-tools-open").click();
  await page.locator(`[data-panel=${name}]`).click();
};
const pressed = (page, panel) => page.locator(`#connection-${panel} .toggle[aria-pressed=true]`).allTextContents();
/** Waits for these toggles to be on, and no others. */
const on = ({ page, app }, panel, wanted) => app.poll(() => pressed(page, panel), (names) => names.join() === wanted.join());

// slow: two rides in real time
test("the virtual robot's dirt is gone after a ride, and stays if brushes are off", async (t) => {
  const opened = await openRobot(t, { link: DIRTY });
  const { page, robot } = opened;
  const box = page.locator("#connection-cleans");
  await robot.connect();
  await robot.arm();
  await tool(page, "motors");
  assert.equal(await box.isChecked(), true, "by default it cleans");
  // What only docks does not, whatever was chosen.
  await page.locator("#connection-algorithm").selectOption("dock");
  await page.locator("#connection-cleans:disabled:not(:checked)").waitFor();
  await page.locator("#connection-algorithm").selectOption("bounce");
  await page.locator("#connection-cleans:enabled:checked").waitFor();
  await box.uncheck();
  await page.locator("#connection-go").click();
  // Over the middle of the dirt.
  await robot.drives(0.6);
  await page.locator("#connection-stop").click();
  await robot.rests();
  await dirt(opened, (left) => left === 100);
  assert.match(await page.locator("#connection-swept").textContent(), /^0\.0$/, "nothing was swept");

  await box.check();
  await page.locator("#connection-to-start").click();
  await page.locator("#connection-to-start").waitFor({ state: "hidden" });
  const before = await robot.distance();
  await page.locator("#connection-go").click();
  await on(opened, "motors", ["Side brush", "Vacuum", "Main brush"]);
  assert.match(await page.locator("#connection-doing-note").textContent(), /brushes and vacuum on$/);
  await robot.drives(before + 0.6);
  await dirt(opened, (left) => left < 90);
  assert.ok(Number(await page.locator("#connection-swept").textContent()) > 0.1);
  await page.locator("#connection-stop").click();
  await on(opened, "motors", []);
  await robot.mode("Safe");
  await robot.rests();
});

test("brushes stay as they were chosen", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await page.locator("#connection-cleans").uncheck();
  await page.reload();
  await page.locator("body[data-tab=connection][data-boot=ready]").waitFor();
  await robot.connect();
  await page.locator("#connection-cleans:not(:checked)").waitFor();
});

test("toggles of motors and lights show what is on", async (t) => {
  const opened = await openRobot(t);
  const { page, robot } = opened;
  await robot.connect();
  await robot.arm();
  await tool(page, "motors");
  const press = (name) => page.locator(`.connection-panel .toggle`, { hasText: new RegExp(`^${name}$`) }).click();
  // The second click comes before the first is answered.
  await press("Side brush");
  await press("Vacuum");
  await on(opened, "motors", ["Side brush", "Vacuum"]);
  await page.locator("#connection-stop").click();
  await on(opened, "motors", []);
  await robot.mode("Safe");
  await page.getByLabel("Vacuum", { exact: true }).fill("60");
  await on(opened, "motors", ["Vacuum"]);
  await tool(page, "lights");
  await press("Dirt");
  await press("Mon");
  await on(opened, "lights", ["Dirt", "Mon"]);
  await page.waitForFunction(() => /Lamps: Dirt, Monday\./.test(document.querySelector("#connection-face svg").getAttribute("aria-label")));
  await page.locator("#hand-lift").click();
  await on(opened, "lights", []);
  await on(opened, "motors", []);
});

test("wheels turn by power while the button is held", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await robot.arm();
  await tool(page, "motors");
  await page.getByLabel("Left wheel: backward to forward").fill("120");
  await page.getByLabel("Right wheel: backward to forward").fill("120");
  await page.locator("#wheels-hold").focus();
  await page.keyboard.down("Enter");
  await robot.drives(0.1);
  // Stop is stronger than the key that is still held.
  await page.keyboard.press("Escape");
  await robot.rests();
  await page.keyboard.up("Enter");
});

test("clock and schedule are set, after asking", async (t) => {
  const { page, robot } = await openRobot(t);
  await robot.connect();
  await tool(page, "schedule");
  await page.locator("#schedule-clock").click();
  await page.waitForFunction(() => /^The clock was set to \w+day, \d\d:\d\d\.$/.test(document.getElementById("schedule-told").textContent));
  await page.getByLabel("Monday", { exact: true }).check();
  await page.getByLabel("Time on Monday").fill("09:30");
  await page.locator("#schedule-set").click();
  assert.match(await page.locator("#connection-ask-text").innerText(), /by itself/);
  await page.locator("#connection-ask-yes").click();
  await page.waitForFunction(() => /: Monday 09:30\.$/.test(document.getElementById("schedule-told").textContent));
  await tool(page, "console");
  await page.locator("#console-lines .line-sent", { hasText: "Schedule: Monday 9:30" }).waitFor();
  await page.locator("#console-lines .line-sent", { hasText: "Set Day/Time: " }).waitFor();
});
