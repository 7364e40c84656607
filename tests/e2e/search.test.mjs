// The planner's search, shown step by step.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };
const LAPTOP = { viewport: { width: 1440, height: 900 } };
const SNAKE = "#room=thesis8&robot=cell&planner=snake";

test("the snake's decisions follow steps and scrubs, in words and on the floor", async (t) => {
  const { page, app, screenshot } = await openApp(t, { ...LAPTOP, address: SNAKE });
  await app.pause();
  await app.press("Back to the start");
  await app.until("ready");
  const note = page.locator("#search-note");
  const picture = () => page.locator("#floor").screenshot().then((png) => png.toString("base64"));
  const without = await picture();
  assert.ok(await note.isHidden());

  const toggle = page.getByRole("checkbox", { name: "Show the search" });
  await toggle.focus();
  await page.keyboard.press("Space");
  await note.waitFor();
  assert.match(await note.textContent(), /straight on\.$/);
  assert.notEqual(await picture(), without, "it is drawn, too");
  assert.equal(await app.state(), "ready", "showing it plans nothing anew");

  const told = [];
  for (let i = 0; i < 60 && !told.some((text) => text.includes("cells to clean")); i++) {
    await app.press("One step");
    await app.frames(2);
    told.push(await note.textContent());
  }
  assert.match(told.at(-1), /^Left and right equal; cells to clean: \d+ (above|on the left), \d+ (below|on the right); (smaller block|nearer edge): /);
  // Also for those who can't see it.
  await app.poll(() => page.locator("#floor").getAttribute("aria-label"), (label) => label.includes(told.at(-1)));
  await screenshot("search-laptop-light");
  await page.emulateMedia({ colorScheme: "dark" });
  await app.frames(3);
  await screenshot("search-laptop-dark");

  await app.press("Back to the start");
  await app.until("ready");
  await app.poll(() => note.textContent(), (text) => /straight on\.$/.test(text));
  // Others tell what they weigh, too; a behaviour plans nothing.
  await app.choose("algorithm", "wavefront_distance");
  await app.poll(() => note.textContent(), (text) => /^Farthest from the goal: .*\.$/.test(text));
  await app.choose("algorithm", "random_walk");
  assert.ok((await toggle.isHidden()) && (await note.isHidden()), "a behaviour has no search");
});

test("a search in metres is a film, of a plan that was kept early, too", async (t) => {
  const { page, app, screenshot } = await openApp(t, { ...LAPTOP, address: "#room=bedroom&planner=lanes&p.effort=0.2&search=1&speed=0" });
  const note = page.locator("#search-note");
  await app.poll(() => note.textContent(), (text) => /^First path: Lanes in metres needs \d+:\d\d min/.test(text));
  const next = page.getByRole("button", { name: "Next frame" });
  for (let i = 0; i < 20 && !/(rejoined|every piece moved), .* saved; now \d+:\d\d min\.$/.test(await note.textContent()); i++) {
    await next.click();
    await app.frames(2);
  }
  await screenshot("search-in-metres");
  await page.evaluate(() => {
    const keep = document.getElementById("planning-keep");
    new MutationObserver(() => keep.hidden || keep.click()).observe(keep, { attributeFilter: ["hidden"] });
    location.hash = "room=bedroom&planner=lanes&p.effort=100&search=1&speed=0";
  });
  await app.poll(() => app.metric("Kept early"), ({ plan }) => /after/.test(plan));
  await app.poll(() => note.textContent(), (text) => /^First path: Lanes in metres/.test(text));
});

test("at the end of a run with a film the floor and what was reached are shown", async (t) => {
  const { page, app } = await openApp(t, { ...LAPTOP, address: "#room=lshape&planner=boustrophedon&search=1&speed=0" });
  await app.poll(() => page.locator("#stage").getAttribute("data-film"), (shown) => shown === "true");
  await app.press("Play");
  await app.until("finished");
  await page.locator("#ending", { hasText: /^Done: .*Try next/s }).waitFor();
  assert.equal(await page.locator("#stage").getAttribute("data-film"), "false");
});

test("the search fits a phone", async (t) => {
  const { page, app, screenshot } = await openApp(t, { ...PHONE, address: `${SNAKE}&speed=1` });
  await app.pause();
  await page.locator("button[data-sheet=setup]").tap();
  await page.getByRole("checkbox", { name: "Show the search" }).tap();
  // The sheet would hide it.
  await page.locator("#setup.open").waitFor({ state: "detached" });
  await page.locator("#search-note").waitFor();
  for (let i = 0; i < 60 && !(await app.text("#search-note")).includes("cells to clean"); i++) {
    await page.getByRole("button", { name: "One step" }).tap();
    await app.frames(2);
  }
  await screenshot("search-phone-light");
  await page.emulateMedia({ colorScheme: "dark" });
  await app.frames(3);
  await screenshot("search-phone-dark");
  const box = await page.locator("#search-box").boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 390, JSON.stringify(box));
  // The text hides nothing of the room.
  const behind = () =>
    page.locator("#floor").evaluate((canvas, bottom) => {
      const y = Math.floor((bottom - canvas.getBoundingClientRect().top - 1) * devicePixelRatio);
      const row = canvas.getContext("2d").getImageData(0, y, canvas.width, 1).data;
      return new Set(Array.from({ length: canvas.width }, (_, x) => row.slice(4 * x, 4 * x + 4).join(" "))).size;
    }, box.y + box.height);
  await app.poll(behind, (colours) => colours === 1);
});

test("a small room for the search opens at the first click of all, with the same cells", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=flat&planner=boustrophedon&cell=0.11" });
  const small = page.locator("#search-small");
  await small.waitFor();
  // Nothing before it: no pointer has moved.
  await small.evaluate((node) => node.click());
  await app.poll(() => page.evaluate(() => location.hash), (hash) => hash.includes("room=bedroom") && hash.includes("search=1"));
  assert.match(await page.evaluate(() => location.hash), /cell=0\.11/);
  await app.poll(() => app.text("#film-at"), (text) => Number(/of (\d+)/.exec(text)?.[1]) > 3);
});
