// A twin of a robot from a recording: made on the tab Robot, opened in Explore.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openRobot } from "./connection.mjs";

/** A robot in Safe mode that starts and stops, at 98 % of the commanded speed. @param {number} seconds */
function drive(seconds) {
  const hex = (bytes) => bytes.map((byte) => (byte & 255).toString(16).padStart(2, "0")).join(" ");
  const lines = ["robovac-oi-recording 1", "0.0 ! open", "0.5 > 80 8E 23", "0.52 < 01", "0.55 > 83"];
  let [speed, way] = [0, 0];
  for (let step = 0; step * 0.015 < seconds; step++) {
    const wanted = [0, 300, 0, -300][Math.floor(step / 100) % 4];
    const at = 0.6 + step * 0.015;
    if (step % 100 === 0) lines.push(`${at.toFixed(4)} > ${hex([145, wanted >> 8, wanted, wanted >> 8, wanted])}`);
    way += (0.98 * speed * 0.015) / 0.444565;
    speed += Math.max(-18, Math.min(18, wanted - speed));
    const count = Math.trunc(way);
    // Group 100: mode, requested speeds, counts.
    const frame = [19, 81, 100, ...new Array(80).fill(0)];
    const put = (at, ...bytes) => frame.splice(3 + at, bytes.length, ...bytes);
    put(40, 2);
    put(48, wanted >> 8, wanted, wanted >> 8, wanted, count >> 8, count, count >> 8, count);
    const sum = frame.reduce((sum, byte) => sum + (byte & 255), 0);
    lines.push(`${(at + 0.015).toFixed(4)} < ${hex([...frame, -sum])}`);
  }
  return Buffer.from(`${lines.join("\n")}\n`);
}

test("a recording becomes a twin, is checked with another and is the robot in Explore, also after a reload", async (t) => {
  const { page, screenshot } = await openRobot(t);
  const bring = (id, name, seconds) => page.locator(id).setInputFiles({ name, mimeType: "text/plain", buffer: drive(seconds) });
  await bring("#replay-file", "short.txt", 4);
  await page.locator("#replay-twin").click();
  await page.waitForFunction(() => /needs 10 s/.test(document.getElementById("twin-told").textContent));
  await bring("#replay-file", "drive.txt", 24);
  await page.locator("#replay-twin").click();
  await page.locator("#twin-explore").waitFor();
  const figures = await page.locator("#twin-figures").innerText();
  assert.match(figures, /Speed for a commanded speed\s+9(7\.9|8\.[01])\d ± 0\.\d+ %\s+model 100\.00/);
  assert.match(figures, /Wheel base\s+235\.0 mm\s+The model's: no full turn was seen/);
  await bring("#twin-second", "second.txt", 18);
  await page.locator("#twin-checks li + li").waitFor();
  assert.match(await page.locator("#twin-checks").innerText(), /Counts of a wheel after a second/);
  await page.locator("#twin-check").scrollIntoViewIfNeeded();
  await screenshot("robot-twin");
  await page.locator("#twin-explore").click();
  await page.waitForFunction(() => document.getElementById("robot").value === "twin");
  await screenshot("explore-twin");
  // The address leads back.
  await page.waitForFunction(() => location.hash.includes("twin="));
  await page.reload();
  await page.waitForFunction(() => document.getElementById("robot")?.value === "twin");
  await page.locator("#robot").selectOption("dvr1");
  await page.waitForFunction(() => document.getElementById("robot").value === "dvr1");
  await page.locator("#robot").selectOption("twin");
  await page.waitForFunction(() => document.getElementById("robot").value === "twin" && /fitted/.test(document.getElementById("robot-note").textContent));
});
