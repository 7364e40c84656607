// Rooms and paths saved as files for other programs, and read back.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { anyFile } from "./maps.mjs";
import { messagesOf, positions } from "./mcap.mjs";

const ROOM = "#room=lshape&planner=snake&robot=cell&cell=0.25";

/** The downloaded files, by name. */
async function files(downloads) {
  const entries = downloads.map(async (download) => [download.suggestedFilename(), fs.readFileSync(await download.path())]);
  return Object.fromEntries(await Promise.all(entries));
}

test("a room goes out as a ROS map and comes back the same", async (t) => {
  const { app, page } = await openApp(t, { address: ROOM });
  const area = await app.reachableArea();
  const saved = await files(
    await app.save("ros_png", 2, async () => {
      await page.locator("#save-mode").selectOption("scale");
      await page.locator("#save-negate").check();
    }),
  );
  assert.deepEqual(Object.keys(saved).sort(), ["l-shaped-room.png", "l-shaped-room.yaml"]);
  const yaml = saved["l-shaped-room.yaml"].toString();
  assert.match(yaml, /^image: "l-shaped-room.png"\nmode: scale\n/);
  assert.match(yaml, /negate: 1\n/);
  await app.choose("room", "flat");
  await app.drop(...Object.entries(saved).map(([name, bytes]) => anyFile(name, bytes)));
  assert.equal(await app.message(), "");
  assert.equal(await app.reachableArea(), area);
});

test("the dialog is left by Escape, remembers nothing, and its faults are told in it", async (t) => {
  const { app, page } = await openApp(t, { address: ROOM });
  await page.locator("#save").click();
  await page.locator("#save-as[open]").waitFor();
  assert.equal(await page.evaluate(() => document.activeElement?.id), "save-now");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("#save-as[open]").count(), 0);
  // Enter on a kind saves it.
  await page.locator("#save").click();
  await page.locator("#save-as input[value=svg]").check();
  const byKey = page.waitForEvent("download");
  await page.locator("#save-as input[value=svg]").press("Enter");
  assert.equal((await byKey).suggestedFilename(), "l-shaped-room.svg");
  await page.locator("#save-as").waitFor({ state: "hidden" });
  await page.locator("#save").click();
  await page.locator("#save-as").getByRole("button", { name: "Close" }).click();
  assert.equal(await page.locator("#save-as[open]").count(), 0);
  const [drawing] = await app.save("svg");
  assert.equal(drawing.suggestedFilename(), "l-shaped-room.svg");
  const svg = fs.readFileSync(await drawing.path(), "utf8");
  assert.match(svg, /<path id="walls"/);
  assert.match(svg, /<g id="path">/);
});

test("a behaviour has no path to save", async (t) => {
  const { page } = await openApp(t, { address: "#room=lshape&behaviour=random_walk" });
  await page.locator("#save").click();
  await page.locator("#save-as[open]").waitFor();
  assert.equal(await page.locator("#save-as input:disabled").count(), await page.locator("#save-as [data-path]").count());
});

test("the run that was shown goes out as a ROS 2 bag", async (t) => {
  const { app, page } = await openApp(t, { address: "#room=lshape&behaviour=bounce&speed=0&seed=5" });
  await app.numbersThat((now) => now.time > 20, undefined);
  await app.press("Pause");
  await app.until("paused");
  const shown = await app.numbers();
  // The run so far, though an earlier moment is shown.
  await app.scrub(0.5);
  const [download] = await app.save("run_mcap");
  assert.equal(download.suggestedFilename(), "l-shaped-room.run.mcap");
  const messages = messagesOf(fs.readFileSync(await download.path()));
  const truth = messages["/ground_truth/odom"];
  assert.ok(Math.abs(truth.at(-1)[0] - shown.time) < 1.1, `${truth.at(-1)[0]} s of ${shown.time} s`);
  const places = positions(truth, "map");
  const driven = places.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - places[i][0], y - places[i][1]), 0);
  assert.ok(Math.abs(driven - shown.distance) < 0.01 * shown.distance + 0.1, `${driven} m of ${shown.distance} m`);
  for (const topic of ["/map", "/odom", "/tf", "/cmd_vel", "/bumper", "/cliff", "/battery_state", "/rosout"]) assert.ok(messages[topic], `${topic}: ${Object.keys(messages)}`);
  assert.equal(await app.message(), "");
  await page.locator("#toast").getByText("Saved as l-shaped-room.run.mcap").waitFor({ state: "attached" });
});
