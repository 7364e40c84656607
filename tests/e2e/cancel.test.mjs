// A planner that has much to do: the page says so, and lets go at once.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { pillars, textMap } from "./maps.mjs";

test("planning a large map is shown and cancelled at once", async (t) => {
  const { page, app } = await openApp(t);
  const large = textMap("large.txt", pillars(1000));
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.locator("#load").click()]);
  await chooser.setFiles([{ name: large.name, mimeType: "text/plain", buffer: large.bytes }]);
  await app.until("planning");
  await page.locator("#planning").waitFor();
  // The bar moves while the planner is at work, and the page goes on drawing.
  await page.waitForFunction(() => Number(document.getElementById("planning-bar").getAttribute("value")) > 0);
  assert.match(await app.text("#planning-percent"), /^\d+ %$/);

  const taken = await page.evaluate(
    () =>
      new Promise((done) => {
        const began = performance.now();
        const look = () => document.body.dataset.state !== "planning" && done(performance.now() - began);
        new MutationObserver(look).observe(document.body, { attributeFilter: ["data-state"] });
        document.getElementById("planning-cancel").click();
      }),
  );
  t.diagnostic(`cancelling took ${taken.toFixed(0)} ms`);
  assert.ok(taken < 100, `cancelling took ${taken} ms`);
  assert.equal(await app.state(), "failed");
  assert.match(await app.message(), /cancelled/);
  assert.ok(await page.locator("#planning").isHidden());

  // Whoever cancels wanted it to stop, so the next room waits for them.
  assert.equal(await app.choose("room", "empty"), "ready");
  assert.equal(await app.message(), "");
  await app.press("Play");
  await app.poll(() => app.numbers(), ({ distance }) => distance > 0);
});
