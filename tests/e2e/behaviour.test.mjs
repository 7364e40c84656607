// Robots that react to what they feel: chosen, watched, and found again.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp, seconds } from "./app.mjs";

const BOUNCE = "#room=thesis8&behaviour=bounce&speed=16";

const events = (page) => page.locator("#events li:not([hidden])").allInnerTexts();

test("a behaviour is chosen, runs without a plan, and says what it feels", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8" });
  assert.ok(await page.locator("#dashboard").isHidden(), "out of the way for planners");
  assert.equal(await app.choose("algorithm", "bounce"), "playing");
  assert.equal(await page.locator("#algorithm-kind").textContent(), "reactive behaviour");
  await app.poll(() => app.numbers(), ({ distance, coverage }) => distance > 0.5 && coverage > 0);

  // Nothing of a plan is left.
  for (const part of ["#metrics-plan", "#metrics th:text-is('Plan')", ".legend .line.plan", "#search-field"]) {
    assert.ok(await page.locator(part).isHidden(), part);
  }
  assert.match(await app.text("#timeline-plan"), /no plan/);

  const [first] = await app.poll(() => events(page), (lines) => lines.some((line) => /bump/.test(line)));
  assert.match(first, /^\d+:\d\d/);
  const bump = (await events(page)).find((line) => /bump/.test(line));
  assert.match(bump, /bump (left|right|in front), backing up/);
});

test("the dashboard shows what the sensors report, and changes", async (t) => {
  const { page, app } = await openApp(t, { address: BOUNCE });
  const portrait = page.locator("#dashboard svg.portrait");
  await portrait.waitFor();
  const counts = () => page.locator("#dashboard .reading", { hasText: "Wheel counts" }).locator(".value").innerText();
  const before = await counts();
  await app.poll(counts, (now) => now !== before);
  await app.poll(() => portrait.getAttribute("aria-label"), (text) => /Bumper pressed: (left|right)/.test(text));
  await app.poll(() => portrait.getAttribute("aria-label"), (text) => /Bumper pressed: nowhere/.test(text));

  // Only what the robot has.
  assert.equal(await portrait.locator(".track").count(), 6, "light bumper of the Roomba");
  await app.choose("robot", "cell");
  await app.poll(() => portrait.locator(".track").count(), (bars) => bars === 0);
  assert.equal(await page.locator("#dashboard .cliff").count(), 4);
});

test("an event leads back to its time", async (t) => {
  const { page, app } = await openApp(t, { address: BOUNCE });
  await app.poll(() => events(page), (lines) => lines.length >= 6);
  await app.pause();
  // What happened right before shows a few frames later, on top of the list.
  await app.still(() => events(page));
  const lines = await events(page);
  const [clock] = /^\d+:\d\d/.exec(lines[4]);
  await page.locator("#events li button").nth(4).click();
  await app.settled();
  await app.numbersThat(({ time }) => Math.abs(time - seconds(clock)) <= 1);
  assert.ok((await events(page)).length >= lines.length, "what comes after stays in the list");
  await app.poll(() => page.locator("#events li.ahead").count(), (ahead) => ahead >= 3);
});

test("the time line has an open end, and can be scrubbed", async (t) => {
  const { page, app } = await openApp(t, { address: BOUNCE });
  await app.numbersThat(({ time }) => time > 30);
  await app.pause();
  const end = await app.numbers();
  await app.scrub(0.2);
  const { time } = await app.numbersThat((now, then) => now.time < then.time, end);
  assert.ok(time > 0);
  // Rounded there, and down here.
  assert.ok([0, 1].includes(end.time - Number(await page.locator("#scrubber").getAttribute("aria-valuemax"))));
});

test("what is shown, noise and behaviour are in the link", async (t) => {
  const { page, app } = await openApp(t, { address: BOUNCE });
  await app.unfold();
  await app.choose("noise", "harsh");
  assert.equal(await app.linked("noise.cliff"), "harsh");
  await page.locator("#noises select").first().selectOption("off");
  await app.linked("noise.bumper", (level) => level === undefined);
  assert.equal(await page.locator("#noise").inputValue(), "mixed");
  await page.locator("#quantised").check();
  await page.getByRole("button", { name: "Layers", exact: true }).click();
  await page.locator("[data-layer=sensors]").check();
  await page.locator("[data-layer=coverage]").uncheck();
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#layers").isHidden());
  assert.equal(await app.linked("show", (text) => !/coverage/.test(text) && /sensors/.test(text)), "dirt,sensors");
  await app.linked("quantised");
  const charge = page.locator("#start-charge");
  await charge.fill("40");
  await charge.press("Enter");
  assert.equal(await app.linked("charge"), "40");
  await charge.fill("0");
  await charge.press("Enter");
  await app.says(/start charge can't be "0"; use a whole number from 1 to 100/);
  assert.equal(await charge.inputValue(), "40");

  await page.reload();
  await app.settled();
  assert.equal(await page.locator("#algorithm").inputValue(), "bounce");
  assert.equal(await page.locator("#noise").inputValue(), "mixed");
  assert.ok(await page.locator("#quantised").isChecked());
  assert.equal(await charge.inputValue(), "40");
  await page.getByRole("button", { name: "Layers", exact: true }).click();
  // The menu is filled when it has come.
  await app.poll(() => page.locator("[data-layer=coverage]").isChecked(), (isOn) => !isOn);
  await app.poll(() => page.locator("[data-layer=sensors]").isChecked(), (isOn) => isOn);
});

test("cells wider than the tool are warned of", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty" });
  await app.unfold();
  assert.ok(await page.locator("#cell-note").isHidden());
  await app.choose("cell-size", "0.25");
  assert.match(await app.text("#cell-note"), /Wider than the tool \(17 cm\)/);
});
