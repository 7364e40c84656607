// Paths in metres: the best so far kept, driven and compared; and planning cells chosen for a coverage.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

test("lanes in metres are kept early, told above the least, and driven", async (t) => {
  // A large room, in which it would search for minutes.
  const { page, app } = await openApp(t, { address: "#room=office&planner=snake" });
  await page.evaluate(() => {
    const menu = document.getElementById("algorithm");
    menu.value = "lanes";
    menu.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await page.locator("#planning-keep").waitFor();
  await page.locator("#planning-keep").click();
  await app.settled();
  assert.equal(await app.message(), "");
  await app.poll(() => app.metric("Excess distance"), ({ plan }) => /^[\d.]+ % over [\d.,]+ m$/.test(plan));
  const { plan: time } = await app.metric("Excess time");
  assert.match(time, /^[\d.]+ % over [\d:]+$/);
  assert.ok(await page.getByRole("rowheader", { name: "Cells visited" }).isHidden(), "there are no cells");
  assert.match((await app.metric("Planned in")).plan, /s$/);
  await app.poll(() => app.numbers(), ({ distance }) => distance > 0);
});

test("a curve tells the time for other coverages, and the page what can't be swept", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=room12ft&planner=lanes&p.effort=0.1&p.coverage=99.5" });
  await app.poll(() => page.locator("#coverage-missed").textContent(), (text) => /^No path was found that sweeps 99\.5 %: this one sweeps 9\d\.\d %\.$/.test(text ?? ""));
  await app.pause();
  const fold = page.locator("#trade-off");
  await fold.getByText("Time for other coverages").click();
  const minutes = async () => [...((await fold.getByRole("img").getAttribute("aria-label")) ?? "").matchAll(/([\d.]+) %: (\d+):(\d\d)/g)].map(([, share, m, s]) => ({ share: Number(share), seconds: 60 * Number(m) + Number(s) }));
  // The last shares take longest to find, and can't be.
  const points = await app.poll(minutes, (all) => all.length > 10, "the whole curve");
  const [least, most] = [points[0], points.at(-1)];
  assert.ok(least.share < 82 && most.share > 97 && most.share < 99.5, JSON.stringify(points));
  assert.ok(least.seconds < 0.8 * most.seconds, "less floor takes less time");
  await fold.getByText("No path was found that sweeps more than").waitFor();
  const box = page.getByRole("spinbutton", { name: "Coverage" });
  await box.evaluate((input) => {
    input.value = "90";
    input.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await fold.getByText(/^90\.0 % of the floor: about \d:\d\d, [\d.]+ m, \d:\d\d less than for 9\d\.\d %\. No path/).waitFor();
  // Another coverage is another plan, with a curve of its own and nothing missing.
  const before = JSON.stringify(points);
  await box.evaluate((input) => input.dispatchEvent(new Event("change", { bubbles: true })));
  await app.poll(() => page.locator("#coverage-missed").isHidden(), Boolean, "what was missing to be gone");
  const others = await app.poll(minutes, (all) => all.length > 10 && JSON.stringify(all) !== before, "another curve");
  assert.ok(others.some(({ share }) => share === 90), "the plan's own");
  // What is left half done is done when one comes back.
  await app.choose("algorithm", "boustrophedon");
  assert.ok(await fold.isHidden());
  await app.choose("algorithm", "lanes");
  await app.poll(minutes, (all) => all.length > 10, "the curve of lanes again");
  await app.linked("p.coverage", (value) => value === "90");
});

test("planning cells are chosen for a coverage", async (t) => {
  const { app, page } = await openApp(t, { address: "#room=bedroom&planner=boustrophedon&cell=0.2" });
  const swept = async () => Number(/[\d.]+/.exec((await app.metric("Coverage")).plan)?.[0]);
  await app.poll(swept, (coverage) => coverage < 97);
  await app.unfold();
  await app.choose("cell-size", "98");
  await app.poll(swept, (coverage) => coverage >= 98);
  assert.match(await app.text("#cell-fit"), /^9[89]\.\d % swept, in [\d:]+\./);
  assert.equal(await app.message(), "");
  await app.choose("cell-size", "0.2");
  await page.locator("#cell-fit").waitFor({ state: "hidden" });
  // A centimetre off walls and furniture, 99 % can't be swept there.
  await app.choose("room", "room12ft");
  await app.choose("cell-size", "99");
  await app.poll(() => app.text("#cell-fit"), (text) => /^None of the cells tried reaches 99 %: 9[67]\.\d % is the most, in [\d:]+\./.test(text));
});
