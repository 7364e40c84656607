// What new users stumbled on.
import assert from "node:assert/strict";
import { test } from "node:test";
import { App, openApp } from "./app.mjs";
import { openPage } from "./harness.mjs";

/** Coverage and time, once the run is this far. */
const cleaned = (app, least) => app.numbersThat(({ coverage }) => coverage >= least);

test("the end of a run is told, with what to try next", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=empty&planner=snake&speed=0", viewport: { width: 1440, height: 900 } });
  await app.until("finished");
  const told = await app.poll(() => page.locator("#ending").innerText(), (text) => /above the minimum|proven optimal/.test(text));
  const { coverage } = await app.numbers();
  assert.match(told, new RegExp(`^Done: ${coverage.toFixed(1)} % of the reachable floor swept in \\d+:\\d\\d, driving [\\d.,]+ m\\.`));
  await screenshot("ending-light");
  // The room gives way, and what is told lets clicks through.
  const [x, y] = await page.locator("#ending p").first().evaluate((p) => {
    const { left, top, width, height } = p.getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  });
  assert.equal(await page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.id, [x, y]), "floor");
  await page.locator("#ending").getByRole("button", { name: /slip/ }).click();
  await app.settled();
  assert.equal(await app.linked("slip"), "typical");
  await app.until("finished");
  await page.locator("#ending .sheet-close, #ending button[aria-label=Dismiss]").click();
  // The bound, once it was proven, brought it back.
  await page.locator("#metrics-plan tr", { hasText: "Above the minimum" }).filter({ hasText: /\d|proven/ }).waitFor();
  await page.locator("#ending").waitFor({ state: "hidden" });
  await app.choose("algorithm", "random_walk");
  assert.ok(await page.locator("#ending").isHidden(), "another run");
});

test("less coverage than planned is explained at the end of a run", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=lshape&planner=snake&speed=0" });
  await app.until("finished");
  await app.unfold();
  const told = () => page.locator("#ending p").first().textContent();
  assert.doesNotMatch(await told(), /Planned:/, "a walk that stops at corners sweeps all that was planned");
  await app.choose("slip", "typical");
  await app.until("finished");
  const [{ coverage }, { plan }] = [await app.numbers(), await app.metric("Coverage")];
  assert.ok(parseFloat(plan) - coverage > 0.15, `${plan} planned, ${coverage} swept`);
  await app.poll(told, (text) => text.includes(`Planned: ${plan} (wheels slip).`));
});

test("drawing keeps what is clean, and back to the start begins anew", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&speed=64" });
  await cleaned(app, 30);
  await app.pause();
  const before = await app.numbers();
  await app.tool("wall");
  await app.drag([0.45, 0.5], [0.5, 0.5]);
  const after = await app.numbersThat(({ time }) => time < before.time);
  assert.ok(Math.abs(after.coverage - before.coverage) < 5, `${after.coverage} % after ${before.coverage} %`);
  assert.match(await page.locator("#opening").textContent(), /^\d+\.\d % from before the change$/);
  await app.choose("speed", "0");
  await app.press("Play");
  await app.until("finished");
  await app.poll(() => page.locator("#ending").innerText(), (text) => /% of the reachable floor swept \(\d+\.\d % before the room changed\); the run since then took \d/.test(text));
  await app.press("Undo");
  await app.settled();
  assert.ok((await app.numbers()).coverage > before.coverage - 5);
  await app.press("Back to the start");
  await app.numbersThat(({ coverage }) => coverage < 5);
  assert.equal(await page.locator("#opening").textContent(), "");
});

test("after choosing to drive by hand the keys drive, and don't go on in the menu", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&start=2.5,2.0,0" });
  await page.locator("#algorithm").focus();
  await app.choose("algorithm", "manual");
  await page.locator("#manual").waitFor();
  await page.keyboard.down("ArrowUp");
  await app.numbersThat(({ distance }) => distance > 0.2);
  await page.keyboard.up("ArrowUp");
  assert.equal(await page.locator("#algorithm").inputValue(), "manual");
  // All letters of its name go to the menu: none of them is a shortcut.
  await app.choose("algorithm", "bounce");
  await page.locator("#algorithm").focus();
  await page.keyboard.type("Manual");
  await page.locator("#manual").waitFor();
  assert.ok(await page.locator("#layers").isHidden());
  assert.equal(await page.locator("#tools [data-tool=view]").getAttribute("aria-pressed"), "true");
  await page.keyboard.press("ArrowUp");
  assert.equal(await page.evaluate(() => document.activeElement?.id), "floor");
  assert.equal(await page.locator("#algorithm").inputValue(), "manual");
});

test("a person fits beside a wall", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&behaviour=random_walk" });
  await app.pause();
  await app.tool("place");
  await page.locator('#kinds [data-kind="person"]').click();
  const at = await page.evaluate(() => {
    const { left, top, height } = document.getElementById("floor").getBoundingClientRect();
    return [left, top + height / 2];
  });
  // The first click inside the room, from its left.
  for (let dx = 4; dx < 400 && (await page.locator("#selected option").count()) < 2; dx += 12) {
    await page.mouse.click(at[0] + dx, at[1]);
    await app.settled();
  }
  assert.equal(await app.message(), "");
  assert.match((await page.locator("#selected option").allTextContents()).join(), /Person/);
});

test("own rooms are a list: new by size, renamed, duplicated, deleted and brought back", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=lshape" });
  await page.locator("#rooms-open").click();
  await page.locator("#new-room-name").fill("Attic");
  await page.locator("#new-room-width").fill("6");
  await page.locator("#new-room-depth").fill("2.5");
  await screenshot("rooms");
  await page.locator("#rooms").getByRole("button", { name: "Create" }).click();
  await page.locator("#rooms").waitFor({ state: "hidden" });
  assert.equal(await app.settled(), "playing");
  assert.equal(await app.room(), "Attic");
  const area = await app.reachableArea();
  assert.ok(area > 12 && area <= 15, `${area} m² of 15 m²`);

  await page.locator("#rooms-open").click();
  const row = (name) => page.locator("#own-rooms li").filter({ has: page.getByRole("button", { name, exact: true }) });
  await row("Attic").getByRole("button", { name: /^Rename/ }).click();
  await page.locator("#own-rooms input").fill("Loft");
  await page.locator("#own-rooms input").press("Enter");
  await row("Loft").getByRole("button", { name: /^Duplicate/ }).click();
  await row("Loft copy").waitFor();
  await row("Loft").getByRole("button", { name: /^Delete/ }).click();
  await row("Loft").waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Bring back Loft", exact: true }).click();
  await row("Loft").waitFor();
  await page.locator("#rooms").getByRole("button", { name: "Close" }).click();

  // In the menu, after another room and a reload.
  await app.choose("room", "empty");
  await page.reload();
  await app.settled();
  await page.mouse.move(5, 5);
  await page.locator("#room optgroup[label='Your rooms'] option", { hasText: "Loft copy" }).waitFor({ state: "attached" });
  await app.choose("algorithm", "contour");
  await page.locator("#room").selectOption({ label: "Loft copy" });
  await app.poll(() => app.room(), (name) => name === "Loft copy");
  await app.poll(() => app.reachableArea(), (now) => now === area);
  assert.equal(await page.locator("#algorithm").inputValue(), "contour", "as with a room that ships, the algorithm stays");

  // The way back to a room that has got another name meanwhile is to that room.
  await app.linked("map");
  await app.choose("room", "empty");
  await app.linked("room", (room) => room === "empty");
  await page.locator("#rooms-open").click();
  await row("Loft copy").getByRole("button", { name: /^Rename/ }).click();
  await page.locator("#own-rooms input").fill("Cellar");
  await page.locator("#own-rooms input").press("Enter");
  await row("Cellar").waitFor();
  await page.locator("#rooms").getByRole("button", { name: "Close" }).click();
  await page.goBack();
  await app.poll(() => app.room(), (name) => name === "Cellar");
  await page.locator("#rooms-open").click();
  assert.deepEqual((await page.locator("#own-rooms li").allTextContents()).map((text) => /Loft|Cellar/.exec(text)?.[0]), ["Loft", "Cellar"]);
  await page.locator("#rooms").getByRole("button", { name: "Close" }).click();

  // Two rooms made of the same one have two names, in the list and where they are shown.
  for (const name of ["Empty room (changed)", "Empty room (changed) 2"]) {
    await app.choose("room", "empty");
    await app.linked("room", (room) => room === "empty");
    await app.tool("wall");
    await app.drag([0.4, 0.3], [0.4, 0.6]);
    await app.linked("kept");
    await app.poll(() => app.room(), (shown) => shown === name);
  }
});

test("undo in an own room to which one comes back takes its last wall away", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&speed=1" });
  await app.pause();
  const whole = await app.reachableArea();
  await app.tool("wall");
  await app.drag([0.4, 0.3], [0.4, 0.6]);
  await app.settled();
  const one = await app.reachableArea();
  await app.drag([0.6, 0.3], [0.6, 0.6]);
  await app.settled();
  const two = await app.reachableArea();
  assert.ok(two < one && one < whole, `${two} < ${one} < ${whole}`);
  await app.linked("map");
  const own = await app.room();
  await app.choose("room", "maze");
  await app.linked("room", (room) => room === "maze");
  const name = await page.locator("#room optgroup[label='Your rooms'] option").first().textContent();
  await page.locator("#room").selectOption({ label: name });
  await app.poll(() => app.reachableArea(), (area) => area === two);
  await app.press("Undo");
  await app.poll(() => app.reachableArea(), (area) => area === one);
  assert.notEqual(await app.room(), "Maze", own);
  await app.press("Undo");
  await app.poll(() => app.reachableArea(), (area) => area === whole);
  await app.press("Redo");
  await app.poll(() => app.reachableArea(), (area) => area === one);
});

test("back to an own room that was changed since leads to the room as it is now, not to a copy", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&speed=1" });
  await app.tool("wall");
  await app.drag([0.4, 0.3], [0.4, 0.6]);
  await app.settled();
  const first = await app.linked("map");
  await app.choose("room", "maze");
  await app.linked("room", (room) => room === "maze");
  const name = await page.locator("#room optgroup[label='Your rooms'] option").first().textContent();
  await page.locator("#room").selectOption({ label: name });
  await app.linked("kept");
  await app.drag([0.6, 0.3], [0.6, 0.6]);
  await app.settled();
  const [area, map] = [await app.reachableArea(), await app.linked("map", (now) => now && now !== first)];
  await page.goBack();
  await app.poll(() => app.room(), (shown) => shown === "Maze");
  await page.goBack();
  await app.poll(() => app.reachableArea(), (now) => now === area);
  await app.linked("map", (now) => now === map);
  assert.deepEqual(await page.evaluate(() => JSON.parse(localStorage.getItem("own-rooms") ?? "").map(({ name }) => name)), [name]);
});

test("undo in an own room takes its last change back at once after a reload and a way through another room", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&speed=1" });
  const whole = await app.reachableArea();
  await app.tool("wall");
  await app.drag([0.4, 0.3], [0.4, 0.6]);
  await app.settled();
  const one = await app.reachableArea();
  await app.linked("map");
  await app.choose("room", "maze");
  await app.linked("room", (room) => room === "maze");
  const name = await page.locator("#room optgroup[label='Your rooms'] option").first().textContent();
  await page.locator("#room").selectOption({ label: name });
  await app.poll(() => app.reachableArea(), (area) => area === one);
  await app.linked("map");
  await page.reload();
  // The room is left as soon as it is there, whatever of its past is.
  await app.poll(() => app.reachableArea(), (area) => area === one);
  await page.goBack();
  await app.poll(() => app.room(), (shown) => shown === "Maze");
  await page.goBack();
  await app.poll(() => app.reachableArea(), (area) => area === one);
  await page.locator("#undo:enabled").click();
  await app.poll(() => app.reachableArea(), (area) => area === whole);
  await app.press("Redo");
  await app.poll(() => app.reachableArea(), (area) => area === one);
});

test("a wall that a finger draws is one change, after a reload, too", async (t) => {
  const { page, app } = await openApp(t, { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, address: "#room=empty&speed=1" });
  const whole = await app.reachableArea();
  await page.locator("#tools [data-tool=wall]").tap();
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await touch("touchStart", await app.spot(0.5, 0.3));
  await touch("touchMove", await app.spot(0.5, 0.5));
  // The room is kept while the finger still draws.
  const half = await app.linked("map");
  await touch("touchMove", await app.spot(0.5, 0.7));
  await touch("touchEnd");
  await app.settled();
  const one = await app.reachableArea();
  await app.linked("map", (map) => map && map !== half);
  await page.reload();
  await app.poll(() => app.reachableArea(), (area) => area === one);
  await page.locator("#undo:enabled").click();
  await app.poll(() => app.reachableArea(), (area) => area === whole);
});

test("back and forward go through tabs and rooms, and the run goes on", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty" });
  await app.linked("planner");
  await app.choose("room", "lshape");
  await app.linked("room", (room) => room === "lshape");
  await app.numbersThat(({ distance }) => distance > 1);
  await page.locator("#tab-map").click();
  await app.linked("tab", (tab) => tab === "map");
  await page.goBack();
  await page.locator("#panel-explore").waitFor();
  assert.ok((await app.numbers()).distance > 1, "the run goes on");
  await page.goBack();
  await app.poll(() => app.room(), (name) => name === "Empty room");
  await app.settled();
  await page.goForward();
  await app.poll(() => app.room(), (name) => name === "L-shaped room");
  await page.goForward();
  await page.locator("#panel-map").waitFor();
});

test("a new flat is a number in the link, and an own room once it is changed", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=own&flat=7~area:25..45" });
  const area = await app.reachableArea();
  assert.deepEqual([await app.room(), await page.locator("#flat-seed").inputValue(), await page.locator("#flat-area").inputValue()], ["Flat 7", "7", "~area:25..45"]);
  await page.locator("#flat-other").click();
  const flat = await app.linked("flat", (name) => name && name !== "7~area:25..45");
  assert.match(flat, /^\d+~area:25\.\.45$/);
  await page.locator("#flat-seed").fill("7");
  await page.locator("#flat-seed").press("Enter");
  await app.linked("flat", (name) => name === "7~area:25..45");
  await app.settled();
  assert.equal(await app.reachableArea(), area);
  await app.choose("room", "new-flat");
  await app.linked("flat", (name) => name !== "7~area:25..45");
  await page.goBack();
  await app.poll(() => app.room(), (name) => name === "Flat 7");
  await app.settled();
  await app.tool("wall");
  await app.drag([0.45, 0.45], [0.55, 0.45]);
  await app.linked("map");
  assert.equal((await app.link()).flat, undefined);
});

test("back right after a tab was opened leads to the room that was shown", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&speed=1" });
  await app.choose("room", "lshape");
  await app.linked("room", (room) => room === "lshape");
  await page.evaluate(
    () =>
      new Promise((done) => {
        const back = () => {
          addEventListener("hashchange", done, { once: true });
          history.back();
        };
        document.addEventListener("tab", () => setTimeout(back, 10), { once: true });
        document.getElementById("tab-map")?.click();
      }),
  );
  await page.locator("body[data-tab=explore]").waitFor();
  await app.linked("room", (room) => room === "lshape");
});

test("a link copied from an own room carries it, and what is shown of it", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&planner=near_optimal&p.effort=0&search=1&speed=4", viewport: { width: 1366, height: 768 }, permissions: ["clipboard-read", "clipboard-write"] });
  await app.settled();
  await app.tool("wall");
  await app.drag([0.5, 0.1], [0.5, 0.6]);
  const area = await app.reachableArea();
  await page.getByRole("button", { name: "Copy link" }).click();
  const copied = await app.poll(() => page.evaluate(() => navigator.clipboard.readText()), (text) => /map=/.test(text));
  assert.ok(copied.length < 4000, `${copied.length} characters`);
  const elsewhere = await page.context().browser().newContext();
  const other = new App(await elsewhere.newPage());
  await other.page.goto(copied);
  await other.linked("kept");
  await other.settled();
  assert.equal(await other.reachableArea(), area);
  assert.ok(await other.page.locator("#show-search").isChecked());
  // The room is there once, however often its link is opened, and a frame adds none.
  const rooms = () => other.page.evaluate(() => JSON.parse(localStorage.getItem("own-rooms") ?? "[]").length);
  const again = copied.replace(/&?kept=\w+/, "");
  for (const address of [`${again}&seed=3`, again.replace("#", "?embed#")]) {
    await other.page.goto("about:blank");
    await other.page.goto(address);
    await other.linked("map");
    await other.settled();
    assert.equal(await other.reachableArea(), area);
    assert.equal(await rooms(), 1, address);
  }
  await elsewhere.close();
});

test("behaviours race, a planner races against its copy, and the user chooses the nine", async (t) => {
  const { page, screenshot } = await openPage(t, { address: "#room=thesis8&robot=cell&cell=0.2&tab=compare&vs=snake,spiral&behaviours=random_walk", viewport: { width: 1440, height: 900 } });
  const app = new App(page);
  const lanes = (count) => app.poll(() => page.locator("#lanes figure").count(), (now) => now === count, `${count} lanes`);
  await lanes(3);
  await page.locator("#entrants li[data-id=snake] summary").click();
  await page.locator("#entrants li[data-id=snake]").getByRole("button", { name: "Add a copy" }).click();
  await lanes(4);
  await page.locator("#in-snake-2-param-patience").fill("0");
  await page.locator("#in-snake-2-param-patience").press("Enter");
  await app.linked("vs", (vs) => vs === "snake,spiral,snake~patience:0");
  await lanes(4);
  await page.locator("#race-speed").selectOption("0");
  await page.locator("#race-play").click();
  await app.poll(() => page.locator("#lanes output").allTextContents(), (texts) => texts.filter((text) => / in \d/.test(text)).length >= 3);
  assert.deepEqual((await page.locator("#lanes .rank").allTextContents()).filter((rank) => !/^#[1-4]$/.test(rank)), []);
  assert.ok((await page.locator("#race-ticks span").count()) > 2, "the time has an axis");
  await screenshot("race-light");
  await page.locator("#lanes").getByRole("button", { name: "Take Random walk out of the race" }).click();
  await lanes(3);
  await page.locator("#bench").getByRole("button", { name: "Random walk" }).click();
  await lanes(4);
  await page.locator("#entrants li[data-id=snake-2]").getByRole("button", { name: "Remove this copy" }).click();
  await lanes(3);
});

for (const [name, viewport] of Object.entries({ "200 %": { width: 720, height: 450 }, "a small window at 200 %": { width: 500, height: 320 }, "a phone on its side": { width: 844, height: 390 } })) {
  test(`room and names fit at ${name}`, async (t) => {
    const { page, screenshot } = await openApp(t, { viewport, address: "#room=empty" });
    await screenshot(`small-${viewport.width}`);
    const { sideways, stage, names, now } = await page.evaluate(() => ({
      sideways: document.documentElement.scrollWidth - innerWidth,
      stage: document.getElementById("stage").getBoundingClientRect(),
      names: [...document.querySelectorAll("#tools button span")].filter((span) => span.checkVisibility() && span.getBoundingClientRect().width > 10).length,
      now: document.getElementById("now").checkVisibility() && document.getElementById("now").textContent,
    }));
    assert.ok(sideways <= 0, `${sideways} px too wide`);
    assert.ok(stage.width >= 400 && stage.height >= 170, `${stage.width} × ${stage.height}`);
    assert.equal(names, 6, "all tools have names");
    assert.match(now || "", /.+, .+/, "algorithm and robot have names");
  });
}

for (const [width, height] of [[844, 390], [610, 343]]) {
  test(`in a window of ${width} x ${height} px, the end and messages lie beside the floor`, async (t) => {
    const { page, app } = await openApp(t, { viewport: { width, height }, address: "#room=empty&planner=snake&speed=0" });
    await app.until("finished");
    const told = await app.poll(() => page.locator("#ending").innerText(), (text) => /above the minimum/.test(text));
    assert.match(told, /^Done: .* floor swept in \d+:\d\d\. .*Try next: \S/s);
    const [card, curve] = await page.evaluate(() => [document.getElementById("ending").getBoundingClientRect().bottom, document.getElementById("scrubber").getBoundingClientRect().top]);
    assert.ok(card < curve - 5, `the card ends at ${card}, the curve begins at ${curve} px`);
    const marks = await page.locator("#ticks span").evaluateAll((ticks) => ticks.map((tick) => tick.getBoundingClientRect()).map(({ left, right }) => [left, right]));
    assert.ok(marks.length > 1 && marks.slice(1).every(([left], i) => left > marks[i][1]), `marks of the time axis: ${marks}`);
    await page.evaluate(() => (location.hash = "planner=no_such"));
    await app.says(/There is no algorithm "no_such/);
    const { stage, over, cut, sideways } = await page.evaluate(() => {
      const [stage, ...over] = ["stage", "message", "ending"].map((id) => document.getElementById(id));
      const cut = over.filter((one) => [one, ...one.querySelectorAll("*")].some((part) => part.scrollWidth > part.clientWidth + 1 && part.clientWidth > 0));
      return { stage: stage.getBoundingClientRect().right, over: over.map((one) => one.getBoundingClientRect().left), cut: cut.map(({ id }) => id), sideways: document.documentElement.scrollWidth - innerWidth };
    });
    assert.ok(over.every((left) => left >= stage), `${over} px, and the floor ends at ${stage}`);
    assert.deepEqual([cut, sideways], [[], 0]);
  });
}

test("a sheet closes when it is swiped down", async (t) => {
  const { page } = await openApp(t, { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, address: "#room=empty" });
  // The first touch is for what is there, and changes nothing of the bar.
  await page.locator("button[data-sheet=try]").tap();
  await page.locator("#try .idea").first().waitFor();
  await page.locator("button[data-sheet=setup]").tap();
  const head = page.locator("#setup .sheet-head h2");
  await head.waitFor();
  const box = await head.boundingBox();
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
  await touch("touchStart", { x: box.x + 20, y: box.y + 5 });
  for (const dy of [20, 50, 90]) await touch("touchMove", { x: box.x + 20, y: box.y + dy });
  await touch("touchEnd");
  await page.locator("#setup.open").waitFor({ state: "detached" });
  assert.equal(await page.locator("button[data-sheet=setup]").getAttribute("aria-expanded"), "false");
});
