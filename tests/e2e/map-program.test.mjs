// The tab Map with a user's program as method: what goes wrong is named, and what goes right can be passed on and kept.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { App, seconds, taken } from "./app.mjs";
import { openPage } from "./harness.mjs";
import { messagesOf } from "./mcap.mjs";

const MAP = "#room=room12ft&robot=roomba600&seed=3&tab=map&explorer=program&pace=0";
const BOUNCE = "turn_until = 0\n\ndef step(robot):\n    global turn_until\n    if robot.bump:\n        robot.go(-0.15)\n        turn_until = robot.time + 0.4 + robot.random()\n    elif robot.time < turn_until:\n        robot.go(0, 120)\n    else:\n        robot.go(0.3)\n";

/** Opens Map by a link that has the program in it. */
async function openMap(t, source, { language = "python", ...options } = {}) {
  const { page, server, context } = await openPage(t, options);
  const code = await page.evaluate(async (program) => {
    const { packProgram } = await import(new URL("www/program/link.js", document.baseURI).href);
    return packProgram(program);
  }, { name: "Mine", language, source });
  // A page that is left while it loads its program logs an error.
  await page.locator("#play:enabled").waitFor();
  await page.goto("about:blank");
  await page.goto(`${server.url}${MAP}&code=${code}`);
  await page.getByText("“Mine” drives.").waitFor();
  const app = new App(page);
  const phase = (...wanted) => app.poll(() => page.locator("#panel-map").getAttribute("data-phase"), (now) => wanted.includes(now));
  const time = async () => seconds(await page.locator("#map-n-time").textContent());
  return { page, app, context, phase, time };
}

const fault = (page) => page.locator("#map-program-fault");
const text = (page) => page.evaluate(() => [...document.querySelectorAll(".cm-line")].map(({ textContent }) => textContent).join("\n"));

test("a program that fails in Map is named with its line, and mended in the tab Program", async (t) => {
  const { page, phase, time } = await openMap(t, "def step(robot):\n    if robot.time > 3:\n        robot.go(sped)\n    robot.go(0.1)\n");
  await fault(page).filter({ hasText: /^The program failed in line 3: .*sped.* Mend it in the tab Program\.$/ }).waitFor();
  await page.locator("#map-play").click();
  await phase("finished");
  assert.equal(await time(), 3);
  await page.getByText("Stopped, as its program failed").waitFor();
  await page.locator("#map-program-open").click();
  await page.locator(".cm-line", { hasText: "sped" }).waitFor();
});

test("a program that plans is no method in Map, and the page says what is", async (t) => {
  const { page } = await openMap(t, "def plan(room):\n    return [room.start]\n");
  await page.getByText("plans but doesn't drive").first().waitFor();
});

// slow: a step has four seconds, and the run is followed line by line after that.
test("an endless loop in Map is ended, its line named, and its text untouched", async (t) => {
  const source = "let n = 0;\nfunction step(robot) {\n  robot.go(0.1);\n  if (robot.time > 3)\n    while (true) n += 1;\n}\n";
  const { page } = await openMap(t, source, { language: "javascript" });
  await fault(page).filter({ hasText: /^The program failed in line 5: .*never ends/ }).waitFor();
  await page.locator("#map-program-open").click();
  await page.locator(".cm-line", { hasText: "while (true)" }).waitFor();
  assert.equal(await text(page), source);
});

// slow: more than half an hour is driven, as a program is asked for no more at a time.
test("a program drives on after half an hour, its bag has all of it, and a copied link drives the same elsewhere", async (t) => {
  const { page, app, context, phase, time } = await openMap(t, BOUNCE);
  await page.locator("#map-play").click();
  await app.poll(time, (now) => now > 1860);
  await page.evaluate(() => document.getElementById("panel-map").dataset.phase === "playing" && document.getElementById("map-play").click());
  await phase("paused");
  const shown = await time();
  const [download] = await taken(page, 1, () => page.locator("#map-bag").click());
  const messages = messagesOf(fs.readFileSync(await download.path()));
  const last = messages["/ground_truth/odom"].at(-1)[0];
  assert.ok(Math.abs(last - shown) < 1.1, `${last} s of ${shown} s`);

  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.locator("#share").click();
  await page.getByRole("heading", { name: "Link copied" }).waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  // Nothing of it is known there.
  await page.evaluate(() => localStorage.clear());
  await page.goto("about:blank");
  await page.goto(link);
  await page.getByText("“Mine” drives.").waitFor();
  await page.locator("#map-play").click();
  await app.poll(time, (now) => now > 30);
  assert.equal(await page.locator("#map-program-missing").isVisible(), false);
});
