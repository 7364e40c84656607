// A robot of one's own in Explore, and a sweep that is driven as it was planned.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

test("an own robot is built in a form that loses nothing, and survives a reload", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=empty&behaviour=bounce" });
  await page.locator("#robot").selectOption("own");
  await page.locator("#own-robot").waitFor();
  await page.locator("#own-shape").selectOption("polygon");
  await page.locator("#own-corners").fill("-0.2 -0.1; 0.2 0.1; 0.2 -0.1; -0.2 0.1");
  await page.locator("#own-speed").fill("0.25");
  await page.locator("#own-use").click();
  await page.getByText("Sides 1 and 3 of the outline cross; move a corner of either.").waitFor();
  assert.equal(await page.locator("#own-speed").inputValue(), "0.25");
  await page.locator("#own-corners").fill("0.2 -0.15; 0.2 0.15; -0.1 0.15; -0.2 0; -0.1");
  await page.locator("#own-use").click();
  await page.getByText('Corner 5, "-0.1", is not two numbers').waitFor();
  // A picture of nothing was drawn with NaN.
  await page.locator("#own-cleans").selectOption({ index: 1 });
  await page.locator("#own-corners").fill("1.84");
  await page.locator("#own-cleans").selectOption({ index: 0 });
  await page.locator("#own-corners").fill("0.2 -0.15; 0.2 0.15; -0.1 0.15; -0.2 0; -0.1 -0.15");
  await page.locator("#own-tool").fill("0.6");
  await page.locator("#own-use").click();
  await page.getByText("The tool (a disc) reaches 0.300 m from the robot's centre, but its body only 0.250 m").waitFor();
  // The message names the field, and leaves the button in sight on a low screen.
  assert.equal(await page.getByLabel("Tool width").inputValue(), "0.6");
  await page.setViewportSize({ width: 1000, height: 640 });
  const { y, height } = await page.locator("#own-use").boundingBox();
  assert.ok(y + height <= 640, `the button ends at ${y + height}`);
  await screenshot("own-robot-refused");
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.locator("#own-tool").fill("0.25");
  const [wide, high] = await page.locator(".own-tool").evaluate((node) => [node.getBBox().width, node.getBBox().height]);
  assert.ok(wide > 3 * high, `a strip: ${wide} x ${high}`);
  await screenshot("own-robot");
  await page.locator("#own-use").click();
  await page.locator("#own-robot").waitFor({ state: "hidden" });
  await page.waitForFunction(() => document.getElementById("robot").value === "own" && location.hash.includes("own=corners:"));
  assert.equal(await app.message(), "");
  await screenshot("explore-own-robot");
  await page.locator("#tab-map").click();
  await app.poll(() => app.text("#map-robot"), (name) => name === "Own robot");
  await page.locator("#tab-explore").click();
  await page.reload();
  await page.waitForFunction(() => document.getElementById("robot")?.value === "own");
  await page.locator("#robot-edit").click();
  assert.equal(await page.locator("#own-corners").inputValue(), "0.2 -0.15; 0.2 0.15; -0.1 0.15; -0.2 0; -0.1 -0.15");
  // The form says of a rectangle that it is one, though links and scenarios have its corners.
  await page.locator("#own-shape").selectOption("rectangle");
  await page.locator("#own-first").fill("0.3");
  await page.locator("#own-second").fill("0.32");
  await page.locator("#own-use").click();
  await page.waitForFunction(() => location.hash.includes("own=corners:0.16_-0.15_"));
  await page.locator("#robot-edit").click();
  assert.deepEqual(await Promise.all(["shape", "first", "second"].map((id) => page.locator(`#own-${id}`).inputValue())), ["rectangle", "0.3", "0.32"]);
  // Drawing a circle of negative width was an error in the console; it is told once it is to be used.
  await page.locator("#own-shape").selectOption("circle");
  await page.locator("#own-first").fill("-1");
  assert.equal(await page.locator(".own-body").getAttribute("d"), "");
  await page.locator("#own-use").click();
  await page.locator("#own-robot .fault").waitFor();
  await page.locator("#own-cancel").click();
  await page.locator("#robot").selectOption("dvr1");
  await page.waitForFunction(() => document.getElementById("robot").value === "dvr1" && document.getElementById("robot-edit").hidden);
});

test("a sweep is driven in Explore as it was planned, with its outline, also after a reload, and refused to a Roomba that is larger", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=empty" });
  await page.locator("#tab-floor-plan").click();
  await page.locator("#floor-plan-empty [data-floor-plan=explore]").click();
  await page.locator("#floor-plan-settings").waitFor();
  await page.locator("#floor-plan-first").fill("0.34");
  await page.keyboard.press("Tab");
  await page.locator("#floor-plan-play").click();
  await page.locator("#floor-plan-numbers").waitFor();
  const promised = parseFloat(await page.locator("#floor-plan-n-driven").innerText());
  await page.locator("#floor-plan-drive").click();
  await page.waitForFunction(() => document.getElementById("algorithm").value === "path" && document.getElementById("robot").value === "own");
  await page.locator("#speed").selectOption("0");
  await app.until("finished");
  const reached = parseFloat(await app.text("#n-coverage"));
  assert.ok(promised > 95 && Math.abs(reached - promised) < 1, `${reached} of ${promised}`);
  await screenshot("explore-driven-sweep");
  // All of it is in the address: the room ships.
  await page.waitForFunction(() => /room=empty.*own=corners:.*path=/.test(location.hash));
  await page.reload();
  await page.waitForFunction(() => document.getElementById("algorithm")?.value === "path" && document.getElementById("robot").value === "own");
  await page.locator("#tab-connection").click();
  await page.waitForFunction(() => /planned for an octagon, 0\.340 m wide, which a Roomba doesn't fit into/.test(document.getElementById("connection-ride-note")?.textContent ?? ""));
  await page.locator("#tab-explore").click();
  await page.locator("#algorithm").selectOption("boustrophedon");
  await page.waitForFunction(() => !location.hash.includes("path="));
});
