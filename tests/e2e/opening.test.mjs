// The first seconds: for newcomers, and for users who prefer reduced motion.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

test("opens on a robot that is already cleaning", async (t) => {
  // The page's text in the first frame that it draws with a plan.
  const init = () => {
    const look = () => {
      const state = document.body?.dataset.state;
      if (state === undefined || state === "planning") return requestAnimationFrame(look);
      const read = (id) => document.getElementById(id).textContent;
      window.first = { state, coverage: read("n-coverage"), time: read("n-time"), distance: read("n-distance") };
    };
    look();
  };
  const { page, app } = await openApp(t, { init });
  const first = await (await page.waitForFunction(() => window.first)).jsonValue();
  assert.equal(first.state, "playing");
  assert.ok(Number(first.coverage) > 0, `coverage ${first.coverage}`);
  assert.match(first.time, /^\d+:\d\d$/);
  assert.ok(Number(first.distance) > 0, `distance ${first.distance}`);

  const before = await app.numbers();
  const after = await app.numbersThat((now, then) => now.coverage > then.coverage && now.distance > then.distance && now.time > then.time, before);
  assert.ok(after.coverage < 100);
  assert.equal(await app.message(), "");
});

test("says for a while that the opening scene begins after ten minutes, and others don't", async (t) => {
  // What is due in more than ten seconds is due when the test says so.
  const init = () => {
    const { setTimeout } = window;
    window.due = [];
    window.setTimeout = (what, ms, ...more) => (ms > 10_000 ? window.due.push(what) : setTimeout(what, ms, ...more));
  };
  const { page } = await openApp(t, { init });
  const caption = (page) => page.locator(".timeline-caption > span").first().innerText();
  assert.equal(await caption(page), "Coverage over time: 10 minutes already done");
  await page.evaluate(() => window.due.forEach((what) => what()));
  await page.waitForFunction(() => document.getElementById("opening").textContent === "");
  const other = await openApp(t, { address: "#room=lshape" });
  assert.equal(await caption(other.page), "Coverage over time");
});

test("a definition stays while its term is clicked, and says what is counted", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&planner=near_optimal" });
  const own = page.getByRole("button", { name: "Optimality gap" });
  await own.click();
  await app.poll(() => page.locator("#tip").textContent(), (text) => /what this search minimises: its steps \+ [\d.]+ × its quarter turns \(the time that this robot takes/.test(text));
  // One that proves nothing has no gap of its own: its definition goes with it.
  await page.mouse.move(5, 5);
  await page.keyboard.press("Tab");
  await own.focus();
  await page.locator("#tip").waitFor();
  await page.evaluate(() => (location.hash = "room=thesis8&planner=snake"));
  await own.waitFor({ state: "hidden" });
  await page.locator("#tip").waitFor({ state: "hidden" });
  const term = page.getByRole("button", { name: "Above the minimum" });
  await page.mouse.move(5, 5);
  await term.hover();
  await term.click();
  await app.poll(() => page.locator("#tip").textContent(), (text) => /Excess of steps \+ 2 × quarter turns over a proven lower bound/.test(text));
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#tip").isHidden());
});

test("on laptop, tablet and phone one sentence says what the page is, and how good the plan is stands there at once", async (t) => {
  const { page, app } = await openApp(t);
  assert.match((await app.metric("Above the minimum")).plan, /^[\d.]+ %$/);
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    await page.setViewportSize(viewport);
    const sentence = page.getByText("Try floor-cleaning algorithms on simulated robots, compare them, run them on a real Roomba.").filter({ visible: true });
    assert.equal(await sentence.count(), 1);
    const { x, y, width, height } = await sentence.boundingBox();
    assert.ok(x >= 0 && x + width <= viewport.width && height < 60, JSON.stringify({ x, y, width, height }));
    assert.equal(await sentence.evaluate((node) => node.scrollWidth > node.clientWidth), false, "all of it is seen");
  }
});

test("has a title, and a text for those who can't see the floor", async (t) => {
  const { page, app } = await openApp(t);
  assert.equal(await page.title(), "Robovac Playground");
  const label = () => page.locator("#floor").getAttribute("aria-label");
  assert.match(await label(), /^Floor plan of .+ m by .+: the robot is cleaning, \d+\.\d % of the reachable floor is clean/);
  await app.choose("room", "thesis8");
  await page.waitForFunction(() => /Thesis preset/.test(document.getElementById("floor").getAttribute("aria-label")));
});

test("shows a number in every row once it runs", async (t) => {
  const { page } = await openApp(t);
  const texts = await page.locator("#metrics td, .numbers b").allTextContents();
  assert.ok(texts.length > 15, `${texts.length} cells`);
  assert.deepEqual(texts.filter((text) => /NaN|undefined|null|Infinity/.test(text)), []);
});

test("starts paused for those who asked for less motion", async (t) => {
  const { app } = await openApp(t, { reducedMotion: "reduce" });
  assert.equal(await app.state(), "paused");
  const before = await app.numbers();
  assert.ok(before.coverage > 0, "and yet there is something to see");
  await app.frames(20);
  assert.deepEqual(await app.numbers(), before);
  await app.press("Play");
  await app.numbersThat((now, then) => now.distance > then.distance, before);
});
