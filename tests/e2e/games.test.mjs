// What invites to try: the list beside the floor, and its games.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

const idea = (page, name) => page.locator("#try .idea", { hasText: name });

test("every idea of the list leads where it says", async (t) => {
  const { page, app, screenshot } = await openApp(t, { viewport: { width: 1440, height: 900 } });
  await page.mouse.move(300, 300);
  await idea(page, "A cat in the way").waitFor();
  await screenshot("try");
  await idea(page, "A cat in the way").click();
  await app.linked("room", (room) => room === "living");
  await app.linked("behaviour", (id) => id === "random_walk");
  await idea(page, "Kidnap the robot").click();
  await page.locator("#carry-note").waitFor();
  await page.keyboard.press("Escape");
  await idea(page, "Your own room").click();
  await page.locator("#rooms[open]").waitFor();
  await page.keyboard.press("Escape");
  await idea(page, "Random walk against lanes").click();
  await page.locator("#lanes figure").nth(1).waitFor();
  assert.equal(await page.locator("#lanes figure").count(), 2);
  await page.locator("#tab-explore").click();
  await idea(page, "A race of six").click();
  await page.locator("#lanes figure").nth(5).waitFor();
});

// slow: 6 s, of which five are the time to drive.
test("you drive against an algorithm for the same time, and challenge others by a link", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=empty&planner=boustrophedon", viewport: { width: 1440, height: 900 }, permissions: ["clipboard-read", "clipboard-write"] });
  await page.mouse.move(300, 300);
  await idea(page, "You against the algorithm").click();
  const game = page.locator("#game");
  await game.waitFor();
  assert.equal(await page.locator("#versus-rival").inputValue(), "boustrophedon");
  await screenshot("versus");
  // The shortest time is for links alone.
  await page.evaluate(() => (location.hash = "room=empty&start=2.5,2.0,0&versus=boustrophedon,5"));
  await game.getByText("You are challenged").waitFor();
  await page.keyboard.down("ArrowUp");
  await game.getByRole("button", { name: "Start" }).click();
  await page.locator("#game-title", { hasText: /^Your turn$/ }).waitFor();
  await app.linked("behaviour", (id) => id === "manual");
  assert.equal(await app.state(), "ready");
  assert.ok(await page.locator("#speed").isDisabled(), "a game lasts as long as it says");
  // Until somebody drives, nobody's time runs.
  await page.locator("#floor").focus();
  // Held since before the game began, a key that repeats drives, too.
  await page.keyboard.down("ArrowUp");
  await app.numbersThat(({ distance }) => distance > 0.3);
  await page.keyboard.up("ArrowUp");
  await screenshot("versus-drive");
  const theirs = await game.locator(".scores b").nth(2).innerText();
  assert.ok(parseFloat(theirs) > 0, theirs);
  await app.linked("versus", (value) => value === "boustrophedon,5");
  // The clock doesn't wait for who stands still.
  await game.getByRole("button", { name: "Challenge others" }).waitFor();
  const told = await game.innerText();
  await screenshot("versus-over");
  const [, yours, its] = /In 0:05 you swept ([\d.]+) %, .+? ([\d.]+) %\./.exec(told);
  assert.match(told, Number(its) > Number(yours) ? /Boustrophedon.* wins\./ : /You win\.|A draw\./);
  assert.equal(Number(yours), (await app.numbers()).coverage);
  await game.getByRole("button", { name: "Challenge others" }).click();
  const copied = await app.poll(() => page.evaluate(() => navigator.clipboard.readText()), (text) => /versus=/.test(text));
  assert.match(copied, new RegExp(`versus=boustrophedon,5,${yours}$`));

  const { page: other, app: theirApp } = await openApp(t, { address: new URL(copied).hash, permissions: ["clipboard-read", "clipboard-write"] });
  await other.locator("#game").getByText("You are challenged").waitFor();
  assert.match(await other.locator("#game").innerText(), new RegExp(`more than the ${yours} % of whoever sent this`));
  assert.equal((await theirApp.link()).room, "empty");
  await theirApp.linked("versus", (value) => value === `boustrophedon,5,${yours}`);
  await other.reload();
  await other.locator("#game").getByText("You are challenged").waitFor();
  // Another room is the end of it.
  await other.locator("#game").getByRole("button", { name: "Start" }).click();
  await other.locator("#game-title", { hasText: /^Your turn$/ }).waitFor();
  await theirApp.choose("room", "lshape");
  await other.locator("#game").waitFor({ state: "hidden" });
  await theirApp.poll(() => theirApp.link(), (link) => link.versus === undefined);
  assert.ok(await other.locator("#speed").isEnabled());
  await theirApp.choose("algorithm", "spiral");
  await theirApp.poll(() => other.locator("#speed").inputValue(), (now) => now === "16", "as before the game");
});

test("who draws the worst room for a planner is told how bad it is", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=flat&planner=spiral", viewport: { width: 1440, height: 900 } });
  await page.mouse.move(300, 300);
  await idea(page, "Break it").click();
  const game = page.locator("#game");
  await game.getByText(/^Break Growing spirals/).waitFor();
  await page.locator("#tools [data-tool=wall][aria-pressed=true]").waitFor();
  const excess = (which) => game.locator(".scores b").nth(which).innerText();
  const first = await app.poll(() => excess(0), (text) => /^[\d.]+ % above$/.test(text));
  assert.equal(first.replace(" above", ""), (await app.metric("Above the minimum")).plan.replace("proven optimal", "0.0 %"));
  await app.drag([0.5, 0.35], [0.5, 0.7]);
  await app.poll(() => excess(0), (text) => /^[\d.]+ % above$/.test(text) && text !== first);
  await screenshot("worst");
  const most = Math.max(parseFloat(first), parseFloat(await excess(0)));
  await app.poll(() => excess(1), (text) => parseFloat(text) >= most);
  await app.linked("worst", (value) => Number(value) >= most);
  // Whoever gets the link sees the same number, and has beaten nothing yet.
  await app.linked("map");
  const { hash } = new URL(page.url());
  const { page: other } = await openApp(t, { address: hash });
  await other.locator("#game", { hasText: `To beat: ${await excess(1)} the minimum, this link's record.` }).waitFor();
  await game.getByRole("button", { name: "End the game" }).click();
  await app.poll(() => app.link(), (link) => link.worst === undefined);

  // Another room ends it, by a link or from the menu.
  for (const leave of [() => page.evaluate(() => (location.hash = "room=lshape&planner=spiral")), () => app.choose("room", "bedroom")]) {
    await idea(page, "Break it").click();
    await game.getByText(/^Break Growing spirals/).waitFor();
    await app.linked("worst");
    await leave();
    await game.waitFor({ state: "hidden" });
    await app.poll(() => app.link(), (link) => link.worst === undefined);
  }
});
