// The planner that proves how good it is: the gap while it works, the best so far kept, and what is proven afterwards.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

const SIZES = { laptop: { viewport: { width: 1440, height: 900 } }, phone: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true } };

/** A percentage as the page writes it. */
const share = (text) => Number(/([\d.]+) %/.exec(text ?? "")?.[1]);

/** Lets it work in a large room, until it has proven something. */
async function working(t, options = {}) {
  const opened = await openApp(t, { address: "#room=office&planner=snake", ...options });
  await opened.page.evaluate(() => {
    const menu = document.getElementById("algorithm");
    menu.value = "near_optimal";
    menu.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await opened.page.locator("#planning-gap").waitFor();
  return opened;
}

test("the gap is told while it works, and the best plan so far is driven when somebody is content", async (t) => {
  const opened = await working(t, SIZES.laptop);
  const { page, app } = opened;
  await fits(opened, "laptop");
  assert.match(await app.text("#planning-gap"), /^Optimality gap [\d.]+ %$/);
  const first = share(await app.text("#planning-gap"));
  await app.poll(() => app.text("#planning-gap"), (text) => share(text) < first);
  await page.locator("#planning-keep").click();
  await app.settled();
  assert.equal(await app.message(), "");
  assert.ok(await page.locator("#planning").isHidden());
  const { plan: cells } = await app.metric("Cells visited");
  assert.equal(cells.split(" of ")[0], cells.split(" of ")[1]);
  const { plan: gap } = await app.metric("Optimality gap");
  assert.ok(share(gap) > 0 && share(gap) <= first, `${gap}, at first ${first} %`);
  // What all plans are compared by is proven, too, of a plan that was kept early.
  await app.poll(() => app.metric("Above the minimum"), ({ plan }) => share(plan) > 0);
  await app.poll(() => app.numbers(), ({ distance }) => distance > 0);
});

test("other planners are measured by a bound once they are done, and can't be stopped half way", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&planner=snake" });
  await app.poll(() => app.metric("Above the minimum"), ({ plan }) => /%|optimal/.test(plan));
  await app.choose("algorithm", "spiral");
  await app.poll(() => app.metric("Above the minimum"), ({ plan }) => share(plan) > 0);
  assert.ok(await page.locator("#planning-keep").isHidden());
});

/** Gap and buttons are within the floor. */
async function fits({ page, screenshot }, name) {
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await screenshot(`near-optimal-${name}-${colorScheme}`);
    const stage = await page.locator("#stage").boundingBox();
    for (const id of ["planning-gap", "planning-keep", "planning-cancel"]) {
      const box = await page.locator(`#${id}`).boundingBox();
      assert.ok(box && box.x >= stage.x && box.x + box.width <= stage.x + stage.width && box.height > 10, `${id} ${JSON.stringify(box)}`);
    }
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
  }
}

test("on a phone, light and dark, gap and buttons are within the floor", async (t) => fits(await working(t, SIZES.phone), "phone"));

/** Asks for the film of the search, with the keyboard. */
async function film(page) {
  await page.getByRole("checkbox", { name: "Show the search" }).focus();
  await page.keyboard.press("Space");
  await page.locator("#search-note").waitFor();
}

test("in a small room the search is a film: construction, and what every improvement changes", async (t) => {
  const { page, app, screenshot } = await openApp(t, { ...SIZES.laptop, address: "#room=thesis226&planner=near_optimal" });
  assert.equal(await app.state(), "playing");
  const floor = () => page.locator("#floor").evaluate((canvas) => canvas.toDataURL());
  await film(page);
  assert.equal(await app.until("ready", "paused"), await app.state(), "the robot waits for the film");
  const note = () => page.locator("#search-note").textContent();
  assert.ok(await page.locator("#tip").isHidden());
  // Only what is seen has a key.
  const keys = () => page.locator("#legend > div:visible").allInnerTexts().then((all) => all.map((text) => text.trim()));
  assert.deepEqual(await app.poll(keys, (names) => names[0] === "Path"), ["Path", "About to change", "Parts kept", "New", "Out of reach"]);
  assert.match(await note(), /^Construction, 1 of 3: Boustrophedon .* needs \d+ steps and \d+ turns\./);
  // Once a picture was turned by hand, no other comes by itself.
  const told = [];
  const seen = new Set();
  const next = page.getByRole("button", { name: "Next frame" });
  for (let i = 0; i < 40 && !/^Search finished/.test(told.at(-1) ?? ""); i++) {
    await next.click();
    await app.frames(2);
    told.push(await note());
    seen.add(await floor());
    if (/is cut where it changes/.test(told.at(-1)) && !told.slice(0, -1).some((text) => /is cut where it changes/.test(text))) await screenshot("near-optimal-film");
  }
  assert.ok(told.some((text) => /^Improvement.* of \d+: the tinted cells will change\.$/.test(text)), told.join("\n"));
  assert.ok(told.some((text) => /is cut where it changes; \d+ parts? remains?\.$/.test(text)));
  assert.ok(told.some((text) => /rejoined, .* (fewer|more|saved) \(.* % of the bound\); now (proven optimal|at most [\d.]+ % above the minimum)/.test(text)));
  assert.match(told.at(-1), /^Search finished: a plan (proven optimal|at most [\d.]+ % above the minimum)(, by the planner's own turn cost)?\.$/);
  assert.ok(seen.size > told.length / 2, "every picture is another");
  await page.getByRole("button", { name: "Play again" }).click();
  await app.poll(note, (text) => /^Construction, 1 of 3/.test(text));
  await app.poll(note, (text) => /^Construction, 2 of 3/.test(text));

  await app.press("Play");
  await app.poll(note, (text) => /is hidden while the robot drives/.test(text));
  assert.deepEqual((await keys())[0].split("\n")[0], "Passes");
});

test("with reduced motion the film stands still until somebody turns it", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&planner=near_optimal", reducedMotion: "reduce" });
  await film(page);
  // A picture of the film stays for two seconds otherwise.
  await page.waitForTimeout(2200);
  assert.match(await page.locator("#search-note").textContent(), /^Construction, 1 of 3/);
  await page.getByRole("button", { name: "Next frame" }).click();
  await app.poll(() => page.locator("#search-note").textContent(), (text) => /^Construction, 2 of 3/.test(text));
});

test("a plan that was kept early says so and has a film; a room that is too large has none and says so", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis226&planner=snake" });
  await page.evaluate(() => {
    const keep = document.getElementById("planning-keep");
    new MutationObserver(() => keep.hidden || keep.click()).observe(keep, { attributeFilter: ["hidden"] });
    location.hash = "room=thesis226&planner=near_optimal&p.effort=100";
  });
  const { plan: early } = await app.poll(() => app.metric("Kept early"), ({ plan }) => /after/.test(plan));
  assert.match(early, /^after [\d.]+ m?s, \d+ % of the search$/);
  await film(page);
  assert.match(await page.locator("#search-note").textContent(), /^Construction, 1 of 3/);
  const refusal = page.locator("#search-refusal");
  const box = page.locator("#show-search");
  assert.ok((await box.isChecked()) && (await refusal.isHidden()));

  await app.choose("room", "office");
  assert.match(await refusal.textContent(), /^The search is filmed only in rooms of up to 2,000 planning cells; this one has [\d,]+\.$/);
  assert.ok((await refusal.isVisible()) && !(await box.isChecked()) && (await box.isDisabled()));
});
