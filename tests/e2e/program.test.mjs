// The tab Program: writing, running and looking into a program of one's own.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };

/** Opens the tab; the first program runs by itself. */
async function openProgram(t, options = {}) {
  const opened = await openApp(t, { address: "#tab=program", viewport: { width: 1280, height: 800 }, ...options });
  await opened.page.locator("#program-run").waitFor();
  return opened;
}

const text = (page) => page.evaluate(() => [...document.querySelectorAll(".cm-line")].map(({ textContent }) => textContent).join("\n"));
/** Replaces the program. */
async function write(page, source) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.insertText(source);
}
const time = (page) => page.evaluate(() => document.getElementById("n-time").textContent);
const seconds = (clock) => clock.split(":").reduce((sum, part) => 60 * sum + Number(part), 0);
/** The program drives: the opening scene has run for longer. */
const driven = (page) => page.waitForFunction(() => /^0:/.test(document.getElementById("n-time").textContent) && Number(document.getElementById("n-distance").textContent) > 0.5);

test("it opens on a program that already cleans, and a changed number holds at once", async (t) => {
  const { page, screenshot } = await openProgram(t);
  await driven(page);
  await screenshot("program");
  assert.match(await text(page), /def step\(robot\)/);
  // What was changed becomes an own program; an example stays as it is.
  const source = (await text(page)).replace("robot.go(0.3)", "robot.go(0.05)");
  await write(page, source);
  await page.getByText("Changed: press Run").waitFor();
  await page.keyboard.press("Control+Enter");
  await page.waitForFunction(() => Number(document.getElementById("n-distance").textContent) < 0.5);
  await driven(page);
  assert.equal(await page.locator("#program-error").isVisible(), false);
  assert.match(await page.locator("#program-list option:checked").textContent(), /Turn when you bump\.py/);
  // What else there is, is in the page.
  await page.locator("#program-names summary").first().click();
  await page.locator("#program-names-search").fill("wall sensor");
  await page.locator("#program-names-list").getByText("robot.wall_signal", { exact: true }).waitFor();
  assert.equal(await page.locator("#program-names-list").getByText("robot.go(", { exact: false }).first().isVisible(), false);
  await page.reload();
  await page.waitForFunction(() => document.querySelector(".cm-content")?.textContent.includes("robot.go(0.05)"));
});

test("an error is underlined in its line and said in words", async (t) => {
  const { page } = await openProgram(t);
  await write(page, "speed = 0.2\n\ndef step(robot):\n    robot.go(sped)\n");
  await page.keyboard.press("Control+Enter");
  await page.getByRole("alert").filter({ hasText: "sped" }).waitFor();
  await page.locator(".cm-line:nth-child(4) .cm-lintRange-error").waitFor();
  await page.getByRole("button", { name: "Line 4" }).click();
});

test("what a call takes is told while it is written, and a double click takes a whole number", async (t) => {
  const { page } = await openProgram(t);
  await write(page, "def step(robot):\n    ");
  await page.keyboard.type("robot.g");
  await page.locator(".cm-tooltip-autocomplete li", { hasText: /^go/ }).click();
  const told = page.locator(".cm-about").filter({ hasText: /robot\.go\(speed, turn_rate=0\).*left\.$/ });
  await told.waitFor();
  await page.keyboard.type("0.21, 15");
  assert.match(await text(page), /robot\.go\(0\.21, 15\)$/);
  await page.keyboard.press("End");
  await told.waitFor({ state: "detached" });
  await page.locator(".cm-line span", { hasText: /^0\.21$/ }).dblclick();
  await page.keyboard.type("0.4");
  assert.match(await text(page), /robot\.go\(0\.4, 15\)$/);
  // What doesn't start leaves the floor at rest.
  await write(page, "def step(robot)\n");
  await page.keyboard.press("Control+Enter");
  await page.getByText("Not started").waitFor();
  await page.getByRole("button", { name: "Play", exact: true }).waitFor();
  // Another program may have come before the editor hears that the focus has left it.
  await page.evaluate(() => {
    document.querySelector(".cm-content")?.focus();
    document.activeElement?.blur();
    document.getElementById("program-new")?.click();
  });
  await page.waitForFunction(() => document.querySelector(".cm-content")?.textContent !== "def step(robot)");
});

test("an endless loop is ended, its line named, and the text is untouched", async (t) => {
  const { page, app } = await openProgram(t);
  const source = "let n = 0;\nfunction step(robot) {\n  robot.go(0.2);\n  if (robot.time > 1)\n    while (true) n += 1;\n}\n";
  await page.locator("#program-list").selectOption("turn_when_you_bump.javascript");
  await page.locator(".cm-content", { hasText: "function step" }).waitFor();
  await driven(page);
  await write(page, source);
  await page.keyboard.press("Control+Enter");
  await page.getByRole("alert").filter({ hasText: "never ends" }).waitFor();
  await page.getByRole("button", { name: "Line 5" }).waitFor();
  assert.equal(await text(page), source);
  // Nor does the run go on.
  await app.until("paused", "ready");
  // The next run is as any.
  await write(page, source.replace("true", "false"));
  await page.keyboard.press("Control+Enter");
  await driven(page);
  assert.equal(await page.locator("#program-error").isVisible(), false);
});

// slow: the sandbox is held for more than a second, which is what a slow machine looks like.
test("a program that a slow machine holds up is no endless loop", async (t) => {
  const { page, app } = await openProgram(t, { allFrames: true });
  await page.evaluate(() => {
    const error = document.getElementById("program-error");
    new MutationObserver(() => (window.wasDoubted ||= error.textContent.includes("Looking for"))).observe(error, { childList: true });
  });
  // It has enough to do meanwhile.
  await write(page, "def step(robot):\n    sum(range(2000))\n    robot.go(0.21)\n");
  await page.keyboard.press("Control+Enter");
  const hold = () => {
    for (const end = new Date().getTime() + 2500; new Date().getTime() < end; );
  };
  // Which worker it is, and when it drives, can't be seen from here.
  const holdAll = () => Promise.all(page.workers().map((worker) => worker.url().startsWith("blob:") && worker.evaluate(hold).catch(() => {})));
  let rounds = 0;
  const isDoubted = async () => {
    // Now and then Playwright doesn't know of the worker: of another one it does.
    if (++rounds % 6 === 0) await page.keyboard.press("Control+Enter");
    await holdAll();
    return page.evaluate(() => window.wasDoubted);
  };
  await app.poll(isDoubted, Boolean, "a worker that is silent");
  await page.waitForFunction(() => window.wasDoubted && document.getElementById("program-error").hidden);
  await page.getByText("Change a number").waitFor();
  await page.waitForFunction(() => Number(document.getElementById("n-distance").textContent) > 0.5);
});

test("scrubbing back shows variables, prints and the line of that time", async (t) => {
  const { page, app } = await openProgram(t);
  await write(page, "ticks = 0\n\ndef step(robot):\n    global ticks\n    ticks += 1\n    if ticks % 100 == 0:\n        print('tick', ticks)\n    robot.go(0.1)\n");
  await page.keyboard.press("Control+Enter");
  await page.locator("#program-watch summary").click();
  await page.waitForFunction(() => document.getElementById("events").textContent.includes("tick 200"));
  await page.locator("#program-printed").filter({ hasText: /^Printed: tick \d+00$/ }).waitFor();
  await page.getByRole("button", { name: "Pause" }).click();
  const ticks = () => page.locator("#program-variables tr", { hasText: "ticks" }).locator("td").textContent();
  const step = async () => Number((await page.locator("#program-moment").textContent()).replace(/.*step |,/g, ""));
  await app.poll(async () => [Number(await ticks()), await step()], ([ticks, step]) => ticks === step && step >= 200, "the variables of this time");
  // The list follows a little later, and moves its lines when it does.
  await app.still(() => page.locator("#events").textContent());
  await page.getByRole("button", { name: /tick 100$/ }).click();
  await app.poll(ticks, (value) => Number(value) <= 101, "the variables of an earlier time");
  await page.locator(".cm-running").waitFor();
});

test("a breakpoint pauses the run at its line", async (t) => {
  const { page, app } = await openProgram(t);
  await write(page, "def step(robot):\n    robot.go(0.2)\n    if robot.time > 2:\n        robot.stop()\n");
  await page.locator(".cm-line:nth-child(4)").click();
  await page.keyboard.press("F9");
  await page.keyboard.press("Control+Enter");
  await page.getByRole("button", { name: "Play", exact: true }).waitFor();
  assert.equal(seconds(await time(page)), 2);
  await page.locator(".cm-line:nth-child(4).cm-running").waitFor();
  await page.getByText("Stopped at the breakpoint in line 4").waitFor();
  // Its condition takes the Enter that ends it, and the run comes back to the same time.
  const before = await text(page);
  await page.keyboard.press("Shift+F9");
  await page.keyboard.type("robot.time > 3");
  await page.keyboard.press("Enter");
  await page.getByText("Change a number").waitFor();
  await page.waitForFunction((seen) => document.getElementById("n-time").textContent === seen, "0:02");
  assert.equal(await text(page), before);
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.waitForFunction(() => document.getElementById("n-time").textContent === "0:03");
  await page.getByText("Stopped at the breakpoint in line 4").waitFor();
  // Line numbers take breakpoints away and set them.
  await page.locator(".cm-lineNumbers .cm-gutterElement", { hasText: /^4$/ }).click();
  await page.waitForFunction(() => !document.querySelector(".cm-points .cm-gutterElement:not([style*=hidden]) .cm-point"));
  // One step of the play bar is a step of the program.
  await page.locator("#program-watch summary").click();
  const step = async () => Number((await page.locator("#program-moment").textContent()).replace(/.*step |,/g, ""));
  await app.poll(step, (now) => now > 0);
  const at = await step();
  await page.getByRole("button", { name: "One step" }).click();
  await app.poll(step, (now) => now === at + 1);
  assert.match(await page.locator("#program-digest").textContent(), /^Digest [0-9a-f]{16}$/);
});

test("Tab passes through the editor, and indents once something is typed", async (t) => {
  const { page } = await openProgram(t);
  await driven(page);
  const before = await text(page);
  await page.locator("#program-more").focus();
  await page.keyboard.press("Tab");
  await page.locator(".program-editor.by-tab .cm-content:focus").waitFor();
  await page.keyboard.press("Tab");
  await page.locator("#program-run:focus").waitFor();
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Shift+Tab");
  await page.locator("#program-more:focus").waitFor();
  assert.equal(await text(page), before);
  await page.keyboard.press("Tab");
  await page.keyboard.type("#");
  await page.keyboard.press("Tab");
  await page.locator(".cm-content:focus").waitFor();
  assert.notEqual(await text(page), before);
});

test("on a phone a program of a link is there to be read, and gives way once it runs", async (t) => {
  const { page } = await openApp(t, { ...PHONE, address: "#room=empty" });
  const code = await page.evaluate(async () => {
    const { packProgram } = await import(new URL("www/program/link.js", document.baseURI).href);
    return packProgram({ name: "Theirs", language: "python", source: "def step(robot):\n    robot.go(0.1, 30)\n" });
  });
  await page.evaluate((code) => (location.hash = `room=empty&tab=program&code=${code}`), code);
  await page.getByText("This program came from a link").waitFor();
  await page.locator("#program.open").waitFor();
  await page.locator("#program .sheet-close").tap();
  // It doesn't play unread.
  await page.getByRole("button", { name: "Play", exact: true }).tap();
  await page.locator("body[data-state=paused], body[data-state=ready]").waitFor();
  await page.locator("button[data-sheet=program]").tap();
  await page.locator("#program-run").tap();
  await driven(page);
  assert.equal(await page.locator("#program.open").count(), 0);
});

test("a link opens the program elsewhere, where it waits to be read", async (t) => {
  const { page, context } = await openProgram(t);
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await write(page, "# mine\ndef step(robot):\n    robot.go(0.21)\n");
  await page.locator("#share").click();
  await page.getByRole("heading", { name: "Link copied" }).waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(link, /code=/);
  await page.evaluate(() => localStorage.clear());
  await page.goto("about:blank");
  await page.goto(link);
  await page.getByText("This program came from a link").waitFor();
  assert.match(await text(page), /# mine/);
  assert.equal(await page.locator("#program-status").textContent(), "Not run yet: read it first");
  await page.locator("#program-run").click();
  await driven(page);
});

test("a program that was stopped runs on when the run is played, and can be stopped again", async (t) => {
  const { page, app } = await openProgram(t);
  await app.linked("behaviour", (value) => value === "program");
  await driven(page);
  const stop = page.locator("#program-stop");
  await stop.click();
  await app.until("paused");
  await page.locator("#program-status").filter({ hasText: "Stopped" }).waitFor();
  assert.equal(await stop.isDisabled(), true);
  const before = seconds(await time(page));
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.locator("#program-stop:enabled").waitFor();
  await app.poll(() => time(page), (now) => seconds(now) > before);
  await stop.click();
  await app.until("paused");
});

test("a planner in Python plans, and a wrong one is told what is wrong", async (t) => {
  const { page, app } = await openProgram(t);
  await page.locator("#program-list").selectOption("plan_in_rows.python");
  await page.locator(".cm-content", { hasText: "def plan" }).waitFor();
  await driven(page);
  // Explore rounds its corners as those of other plans: that saves time.
  const planned = async () => seconds((await app.metric("Time")).plan);
  await page.locator("#tab-explore").click();
  await page.locator("#algorithm option:checked", { hasText: "A planner: rows" }).waitFor({ state: "attached" });
  // Three quarters of an hour, and no time of the program before.
  const stopping = await app.poll(planned, (time) => time > 2700, "the plan");
  await page.locator("#smooth").check();
  await app.poll(planned, (smooth) => smooth < 0.9 * stopping, "the plan with rounded corners");
  await page.locator("#smooth").uncheck();
  await app.poll(planned, (again) => again === stopping, "the plan without");
  await page.locator("#tab-program").click();
  await write(page, "def plan(room):\n    return [room.start, (0, 0)]\n");
  await page.keyboard.press("Control+Enter");
  await page.getByText("The program's plan can't be driven").waitFor();
  await write(page, "def plan(room):\n    x, y = room.start\n    while True:\n        yield x, y\n        x -= 1\n        if x < -1: return\n");
  await page.keyboard.press("Control+Enter");
  await page.getByText(/can't be driven: step \d+ enters \(\d+, \d+\), which isn't free; ask room.is_free/).waitFor();
  // It drives all the same.
  await write(page, "def plan(room):\n    yield room.start\n");
  await page.keyboard.press("Control+Enter");
  await page.getByText(/The walk misses \d+ cells, the first at/).waitFor();
});

test("Explore names the program, and it takes part in the race and in many runs", async (t) => {
  const { page } = await openProgram(t);
  await page.getByText("Change a number").waitFor();
  await page.locator("#tab-explore").click();
  await page.locator("#algorithm option:checked", { hasText: "Your program: Turn when you bump" }).waitFor({ state: "attached" });
  await page.locator("#tab-compare").click();
  await page.locator("#entrants li", { hasText: "Your program" }).locator("input[type=checkbox]").first().check();
  await page.locator("#lanes figure", { hasText: "Your program" }).waitFor();
  await page.locator("#race-play").click();
  await page.waitForFunction(() => [...document.querySelectorAll("#lanes figure")].some((lane) => lane.textContent.includes("Your program") && Number.parseFloat(lane.querySelector("output").textContent) > 0.5));
  await page.locator("#view-runs").click();
  await page.locator("#runs-behaviours li", { hasText: "Your program" }).locator("input").check();
  const others = page.locator("#runs-behaviours li", { hasNotText: "Your program" }).locator("input:checked");
  while ((await others.count()) > 0) await others.first().uncheck();
  await page.locator("#runs-seeds").selectOption({ index: 0 });
  await page.locator("#runs-minutes").selectOption({ index: 0 });
  await page.locator("#runs-go").click();
  await page.locator("#runs-behaviours li", { hasText: "Your program" }).getByText("✓").waitFor();
  // A program that fails says where, in its lane and in the table; the others go on.
  await page.locator("#tab-program").click();
  await write(page, "def step(robot):\n    robot.go(0.2)\n    if robot.time > 5:\n        robot.go(spead)\n");
  await page.keyboard.press("Control+Enter");
  await page.getByRole("alert").filter({ hasText: "spead" }).waitFor();
  await page.locator("#tab-compare").click();
  await page.locator("#runs-go").click();
  const status = page.locator("#runs-behaviours li", { hasText: "Your program: Turn when you bump" }).locator(".status", { hasText: "failed" });
  await status.waitFor();
  assert.match(await status.getAttribute("data-tip"), /failed in line 4: .*spead/);
  await page.locator("#view-race").click();
  await page.locator("#race-reset").click();
  const fault = page.locator("#lanes figure", { hasText: "Your program: Turn when you bump" }).locator(".fault");
  await fault.filter({ hasText: /^The program failed in line 4: .*spead.* Mend it in the tab Program\.$/ }).waitFor();
  await page.locator("#race-play").click();
  await page.waitForFunction(() => [...document.querySelectorAll("#lanes figure:not(:has(.fault:not([hidden]))) output")].some((other) => Number.parseFloat(other.textContent) > 3));
  assert.ok(await fault.isVisible(), "it stays");
});

test("Map takes the program as method: it maps, is carried, goes back, and comes back after a reload", async (t) => {
  const { page, app } = await openProgram(t);
  await driven(page);
  const phase = (...wanted) => app.poll(() => page.locator("#panel-map").getAttribute("data-phase"), (now) => wanted.includes(now));
  const number = (name) => page.evaluate((id) => document.getElementById(id).textContent, `map-n-${name}`);
  await page.locator("#tab-map").click();
  await page.locator("#map-explorer").selectOption("program");
  await page.getByText("“Turn when you bump” drives.").waitFor();
  await phase("ready");
  await app.linked("program", (mark) => /^[0-9a-f]{16}\.Turn/.test(mark ?? ""));
  await page.locator("#map-play").click();
  await app.poll(() => number("boundary"), (mapped) => Number(mapped) > 10);
  await page.locator("#map-play").click();
  await phase("paused");
  // Carried elsewhere, the program runs again from there.
  const at = seconds(await number("time"));
  await page.locator("#map-floor").focus();
  await page.keyboard.press("p");
  await phase("held");
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await phase("paused");
  await page.locator("#map-play").click();
  await app.poll(() => number("time"), (now) => seconds(now) > at + 20);
  await page.locator("#map-play").click();
  await phase("paused");
  // Back, and forward again: the same moment has the same figures.
  const [time, error] = [await number("time"), await number("error")];
  await page.locator("#map-scrubber").focus();
  await page.keyboard.press("Home");
  await app.poll(() => number("time"), (now) => seconds(now) === 0);
  await page.keyboard.press("End");
  await app.poll(() => number("time"), (now) => now === time);
  await phase("paused");
  assert.equal(await number("error"), error);
  // The stored run is repeated by the program.
  await page.reload();
  await phase("paused");
  assert.deepEqual([await number("time"), await number("error")], [time, error]);
  assert.equal(await page.locator("#map-aside").isVisible(), false);
  assert.equal(await page.locator("#map-program-missing").isVisible(), false);
});
