// A program drives the virtual robot, and a real one: here the emulator behind a bridge.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { Robot as VirtualRobot } from "./connection.mjs";
import { openPage } from "./harness.mjs";
import { startBus } from "./serial/bus.mjs";
import { Robot, moves } from "./serial/robot.mjs";

const skip = process.platform === "win32" ? "pseudo-terminals are needed" : false;
const SOURCE = "# from somebody else\ndef step(robot):\n    robot.go(0.1, 30)\n";

const openProgram = async (t, address) => {
  const opened = await openApp(t, { address, viewport: { width: 1000, height: 640 } });
  await opened.page.locator("#program-run").waitFor();
  return opened;
};

test("a program that came by a link drives a real robot only after its text was shown", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bus = await startBus(t, [robot]);
  const { page, server } = await openPage(t, { allow: [/WebSocket/] });
  const code = await page.evaluate(async (source) => {
    localStorage.setItem("connection-safety", "read");
    const { packProgram } = await import(new URL("www/program/link.js", document.baseURI).href);
    return packProgram({ name: "Theirs", language: "python", source });
  }, SOURCE);
  await page.goto("about:blank");
  await page.goto(`${server.url}#room=empty&robot=roomba600&tab=program&code=${code}`);
  await page.getByText("This program came from a link").waitFor();
  // Simulated, it runs as soon as it is wanted.
  await page.locator("#program-run").click();
  await page.locator("#program-status").filter({ hasText: "Change a number" }).waitFor();

  await page.locator("#tab-connection").click();
  await page.locator("#connection-bridge summary").click();
  await page.locator("#connection-url").fill(`${bus.url}/0`);
  await page.locator("#connection-socket button").click();
  await page.locator("#connection-setup[data-phase=connected]").waitFor({ state: "attached" });
  await page.locator("#connection-arm").click();
  await page.locator("#connection-modes .in[data-mode=Safe]").waitFor({ state: "attached" });
  await page.locator("#connection-algorithm").selectOption("program");
  await page.locator("#connection-go").click();
  const dialog = page.getByRole("dialog", { name: "Let “Theirs” drive the robot?" });
  assert.equal(await dialog.locator("pre").textContent(), SOURCE);
  await dialog.getByRole("button", { name: "Cancel" }).click();
  await dialog.waitFor({ state: "detached" });
  assert.ok(!robot.heard().some(moves), "it moved before it was allowed to");
  await page.locator("#connection-go").click();
  await dialog.getByRole("button", { name: "Let it drive the robot" }).click();
  await robot.drives();
  await page.locator("#connection-stop").click();
  await robot.rests();
});

test("the virtual Roomba is driven by the program, and stops for good when answers fail to come", async (t) => {
  const { page, app } = await openProgram(t, "#room=empty&robot=roomba600&tab=program");
  const robot = new VirtualRobot(page, app);
  await page.locator(".cm-content").click();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.insertText("def step(robot):\n    if robot.distance > 0.15:\n        while True: pass\n    robot.go(0.2)\n");
  await page.keyboard.press("Control+Enter");
  await page.locator("#program-error").filter({ hasText: "never ends" }).waitFor();
  await page.locator("#tab-connection").click();
  await robot.connect();
  await robot.arm();
  await page.locator("#connection-algorithm").selectOption("program");
  await page.locator("#connection-go").click();
  await robot.drives(0.05);
  await page.getByText("didn't answer").or(page.getByText("took too long")).first().waitFor();
  await robot.rests();
  assert.ok((await robot.distance()) < 0.6, "it drove on");
  // The loop, once the same readings were gone through again.
  await page.getByText(/The program failed in line 3: .*never ends/).waitFor();
});

test("the virtual Roomba drives what a program has planned", async (t) => {
  const { page, app } = await openProgram(t, "#room=empty&robot=roomba600&tab=program&script=plan_in_rows.python");
  const robot = new VirtualRobot(page, app);
  await page.getByText("Change a number").waitFor();
  await page.locator("#tab-connection").click();
  await robot.connect();
  await robot.arm();
  assert.equal(await page.locator("#connection-algorithm").inputValue(), "program_planner");
  await page.locator("#connection-go").click();
  await robot.drives(0.3);
  await page.locator("#connection-end").click();
  await robot.rests();
});
