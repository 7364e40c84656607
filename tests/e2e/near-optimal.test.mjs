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
  const { page, app } = await working(t);
  assert.match(await app.text("#planning-gap"), /^[\d.]+ % above the proven bound$/);
  const first = share(await app.text("#planning-gap"));
  await app.poll(() => app.text("#planning-gap"), (text) => share(text) < first);
  await page.locator("#planning-keep").click();
  await app.settled();
  assert.equal(await app.message(), "");
  assert.ok(await page.locator("#planning").isHidden());
  const { plan: cells } = await app.metric("Cells visited");
  assert.equal(cells.split(" of ")[0], cells.split(" of ")[1]);
  const { plan: above } = await app.metric("Above the bound");
  assert.ok(share(above) > 0 && share(above) <= first, `${above}, at first ${first} %`);
  await app.poll(() => app.numbers(), ({ distance }) => distance > 0);
});

test("other planners are measured by a bound once they are done, and can't be stopped half way", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&planner=snake" });
  await app.poll(() => app.metric("Above the bound"), ({ plan }) => /%|optimal/.test(plan));
  await app.choose("algorithm", "spiral");
  await app.poll(() => app.metric("Above the bound"), ({ plan }) => share(plan) > 0);
  assert.ok(await page.locator("#planning-keep").isHidden());
});

test("in a small room the search is shown, walk after walk", async (t) => {
  const { page, app, screenshot } = await openApp(t, { ...SIZES.laptop, address: "#room=thesis8&planner=near_optimal" });
  await app.pause();
  const floor = () => page.locator("#floor").screenshot().then((png) => png.toString("base64"));
  const plan = await floor();
  await page.getByRole("checkbox", { name: "Show the search" }).focus();
  await page.keyboard.press("Space");
  const note = page.locator("#search-note");
  await note.waitFor();
  assert.match(await note.textContent(), /^Walk 1 of \d+: /);
  assert.notEqual(await floor(), plan, "a former walk is drawn");
  await screenshot("near-optimal-film");
  await app.poll(() => note.textContent(), (text) => /^The search is over, the plan is (proven optimal|[\d.]+ % above the proven bound)\./.test(text));
});

for (const [name, size] of Object.entries(SIZES)) {
  for (const colorScheme of ["light", "dark"]) {
    test(`on a ${name}, ${colorScheme}, gap and buttons are within the floor`, async (t) => {
      const { page, screenshot } = await working(t, { ...size, colorScheme });
      await screenshot(`near-optimal-${name}-${colorScheme}`);
      const stage = await page.locator("#stage").boundingBox();
      for (const id of ["planning-gap", "planning-keep", "planning-cancel"]) {
        const box = await page.locator(`#${id}`).boundingBox();
        assert.ok(box && box.x >= stage.x && box.x + box.width <= stage.x + stage.width && box.height > 10, `${id} ${JSON.stringify(box)}`);
      }
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
    });
  }
}
