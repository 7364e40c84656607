// Planners and maps that take their time: the page says so, and lets go at once.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { pillars, textMap } from "./maps.mjs";

test("long planning is shown and cancelled at once", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&p.effort=10" });
  // With all its effort the planner works on the largest room for seconds.
  await page.locator("#room").selectOption("office");
  await app.until("planning");
  await page.locator("#planning").waitFor();
  const [progress, floor] = [await page.locator("#planning").boundingBox(), await page.locator("#stage").boundingBox()];
  assert.ok(progress.y >= floor.y + floor.height, "beside the room, not over it");
  await page.waitForFunction(() => Number(document.getElementById("planning-bar").getAttribute("value")) > 0);
  assert.match(await app.text("#planning-percent"), /^\d+ %$/);

  const [ms, frames] = await page.evaluate(
    () =>
      new Promise((done, fail) => {
        if (document.body.dataset.state !== "planning") fail(new Error("it was done before it could be cancelled"));
        const began = performance.now();
        let frames = 0;
        const count = () => requestAnimationFrame(count, (frames += 1));
        count();
        const look = () => document.body.dataset.state !== "planning" && done([performance.now() - began, frames]);
        new MutationObserver(look).observe(document.body, { attributeFilter: ["data-state"] });
        document.getElementById("planning-cancel").click();
      }),
  );
  t.diagnostic(`cancelling took ${ms.toFixed(0)} ms, ${frames} frames`);
  // On a machine that is busy besides, frames are late.
  assert.ok(ms < 100 || (frames <= 4 && ms < 1000), `cancelling took ${ms} ms, ${frames} frames`);
  assert.equal(await app.state(), "failed");
  await app.says(/cancelled/);
  assert.ok(await page.locator("#planning").isHidden());

  // The user has cancelled, so the next room waits for them.
  assert.equal(await app.choose("room", "empty"), "ready");
  assert.equal(await app.message(), "");
  await app.press("Play");
  await app.poll(() => app.numbers(), ({ distance }) => distance > 0);
});

test("escape cancels planning once nothing else is open", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&planner=near_optimal" });
  await app.pause();
  await page.locator("#room").selectOption("office");
  await page.locator("#planning-gap").waitFor();
  // An open element is closed first.
  await page.locator("#layers-open").click();
  await page.keyboard.press("Escape");
  assert.equal(await app.state(), "planning");
  await page.keyboard.press("Escape");
  await app.until("failed");
  await app.says(/cancelled/);
});

test("a map of a million cells is planned and driven", async (t) => {
  const { app } = await openApp(t, { address: "#room=thesis8" });
  await app.drop(textMap("large.txt", pillars(1000)));
  assert.equal(await app.message(), "");
  assert.equal(await app.room(), "large");
  const { plan } = await app.metric("Cells visited");
  assert.equal(plan.split(" of ")[0], plan.split(" of ")[1]);
  await app.poll(() => app.numbers(), ({ distance }) => distance > 0);
});
