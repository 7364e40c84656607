// The tab Map: a robot explores a room that it has never seen.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { App, seconds, taken } from "./app.mjs";
import { openPage } from "./harness.mjs";
import { anyFile } from "./maps.mjs";
import { messagesOf } from "./mcap.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
/** A small room, mapped fast. */
const SMALL = "#room=room12ft&robot=roomba600&seed=3&tab=map&explorer=bounce&pace=256";

/** Opens the tab Map in a small room. */
async function openMap(t, { link = SMALL, ...options } = {}) {
  const opened = await openPage(t, { address: link, ...options });
  const app = new App(opened.page);
  await opened.page.locator("#map-play").waitFor();
  await phase(app, "ready");
  return { ...opened, app, phase: (...wanted) => phase(app, ...wanted) };
}

/** Waits for one of these phases. */
function phase(app, ...wanted) {
  return app.poll(() => app.page.locator("#panel-map").getAttribute("data-phase"), (now) => wanted.includes(now));
}

/** The figures, as they are read. */
async function figures(app) {
  const [mapped, time, error] = await app.page.evaluate(() => ["boundary", "time", "error"].map((name) => document.getElementById(`map-n-${name}`)?.textContent ?? ""));
  return { mapped: Number(mapped), time: seconds(time), error };
}

/** Lets the robot explore until so many seconds are on its clock, then stops it. */
async function explore(app, until) {
  await app.page.locator("#map-play").click();
  await app.poll(() => figures(app), ({ time }) => time >= until);
  // It may be done with the room at that very moment.
  await app.page.evaluate(() => document.getElementById("panel-map").dataset.phase === "playing" && document.getElementById("map-play").click());
  await phase(app, "paused", "finished");
  return figures(app);
}

/** A hash of the canvas' content. */
const picture = (page) =>
  page.locator("#map-floor").evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let sum = 7;
    for (let i = 0; i < data.length; i += 4) sum = (Math.imul(sum, 31) + data[i] * 65536 + data[i + 1] * 256 + data[i + 2]) | 0;
    return sum;
  });

test("it opens empty, explores, and its figures grow", async (t) => {
  const { page, app } = await openMap(t);
  assert.ok(await page.locator("#map-hint").isVisible());
  assert.match(await page.locator("#map-floor").getAttribute("aria-label"), /has not mapped anything yet/);
  assert.ok(await page.locator("#map-export").isDisabled(), "there is nothing to export");
  const early = await explore(app, 30);
  const late = await explore(app, 240);
  assert.ok(late.mapped > early.mapped && late.time > early.time, JSON.stringify([early, late]));
  assert.ok(await page.locator("#map-hint").isHidden());
  await app.poll(() => page.locator("#map-floor").getAttribute("aria-label"), (words) => /% of the boundary mapped.*by odometry alone/.test(words));
  const cells = await page.locator("#map-figures td").allTextContents();
  assert.ok(cells.length === 10 && cells.every((text) => /\d/.test(text)), cells.join());
  assert.match(await page.locator("#map-curve").getAttribute("d"), /L.*L.*L/);
});

test("every behaviour of the menu maps, whatever its parameters are called", async (t) => {
  const { page, app, phase } = await openMap(t);
  const behaviours = await page.locator("#map-explorer option").evaluateAll((options) => options.map(({ value }) => value));
  assert.ok(behaviours.length > 5);
  for (const behaviour of behaviours) {
    const [menu, note] = [page.locator("#map-explorer"), page.locator("#map-explorer-note")];
    const [chosen, said] = [await menu.inputValue(), await note.innerText()];
    await menu.selectOption(behaviour);
    // What the panel says of a method comes with the next picture.
    if (behaviour !== chosen) await app.poll(() => note.innerText(), (now) => now !== said, behaviour);
    await phase("ready", "paused", "finished");
    // The speed of "edge" took the identifier of the play bar's speed.
    const twice = await page.evaluate(() => [...document.querySelectorAll("[id]")].map(({ id }) => id).filter((id, index, all) => all.indexOf(id) !== index));
    assert.deepEqual(twice, [], behaviour);
    // A Roomba has no laser scanner.
    if ((await page.locator("#map-expected").innerText()).includes("needs a laser scanner")) {
      assert.ok(await page.locator("#map-play[aria-disabled=true]").count());
      continue;
    }
    await explore(app, 1);
  }
});

test("layers are shown and hidden, by buttons, list, keys and links", async (t) => {
  const { page, app } = await openMap(t);
  await explore(app, 60);
  const seen = new Set([await picture(page)]);
  for (const key of ["t", "d", "o"]) {
    await page.keyboard.press(key);
    seen.add(await app.poll(() => picture(page), (now) => !seen.has(now), `another picture after "${key}"`));
  }
  assert.equal(await page.locator("#map-tools [data-layer=truth]").getAttribute("aria-pressed"), "false");
  await page.keyboard.press("l");
  await page.getByLabel("Particles", { exact: true }).check();
  await page.getByLabel("Cleaned floor", { exact: true }).uncheck();
  await page.keyboard.press("Escape");
  assert.ok(await page.locator("#map-layers").isHidden());
  const layers = (await app.linked("layers", (text) => text?.includes("particles") && !text.includes("cleaned"))).split(",");
  assert.ok(layers.includes("difference") && !layers.includes("truth"), layers.join());
});

test("everything works by keyboard, the robot in the hand included", async (t) => {
  const { page, app, phase } = await openMap(t);
  await page.locator("#map-floor").focus();
  await page.keyboard.press(" ");
  await phase("playing");
  await app.poll(() => figures(app), ({ time }) => time > 20);
  await page.keyboard.press(" ");
  await phase("paused");
  const { time } = await figures(app);
  await page.keyboard.press(".");
  await app.poll(() => figures(app), (now) => now.time >= time + 4);
  await page.keyboard.press("p");
  await phase("held");
  assert.ok(await page.locator("#map-held").isVisible());
  await app.frames(3);
  const { x: left, y: top, width: wide, height: high } = await page.locator("#map-held").boundingBox();
  const under = await page.evaluate(([left, top, wide, high]) => {
    const canvas = document.getElementById("map-floor");
    const [floor, copy] = [canvas.getBoundingClientRect(), new OffscreenCanvas(canvas.width, canvas.height).getContext("2d")];
    const scale = canvas.width / floor.width;
    copy.drawImage(canvas, 0, 0);
    const { data } = copy.getImageData(...[left - floor.left, top - floor.top, wide, high].map((side) => Math.round(side * scale)));
    return new Set(new Uint32Array(data.buffer)).size;
  }, [left, top, wide, high]);
  assert.ok(under <= 3, `nothing but the ground and its grid is under the note: ${under} colours`);
  const before = (await figures(app)).error;
  for (const key of ["ArrowRight", "ArrowUp", "Shift+ArrowLeft"]) await page.keyboard.press(key);
  for (let i = 0; i < 6; i++) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await phase("paused");
  await app.poll(() => figures(app), ({ error }) => error !== before);
  // By hand: a tap puts it down there, a drag of the floor doesn't.
  await page.keyboard.press("p");
  await phase("held");
  const { x, y, width, height } = await page.locator("#map-floor").boundingBox();
  const middle = [x + width / 2, y + height / 2];
  await page.mouse.move(...middle);
  await page.mouse.down();
  await page.mouse.move(middle[0] + 30, middle[1] + 10, { steps: 3 });
  await page.mouse.up();
  await app.frames(2);
  await phase("held");
  await page.mouse.click(...middle);
  await phase("paused");
  await page.keyboard.press("r");
  await app.poll(() => figures(app), ({ time }) => time === 0);
  await page.locator("#map-scrubber").focus();
  await page.keyboard.press("End");
  await app.poll(() => figures(app), (now) => now.time >= time);
});

test("a reload goes on where it was", async (t) => {
  const { page, app, phase } = await openMap(t);
  const before = await explore(app, 90);
  await kept(app);
  await page.reload();
  await page.locator("#map-play").waitFor();
  await phase("paused");
  const after = await figures(app);
  assert.deepEqual(after, before);
  assert.equal(await app.message(), "");
  // And on.
  const late = await explore(app, before.time + 20);
  assert.ok(late.mapped >= before.mapped);
  await kept(app);
  // By way of another tab too.
  await page.locator("#tab-explore").click();
  await app.linked("tab", (tab) => tab === undefined);
  await page.reload();
  await page.locator("#tab-map").click();
  await phase("paused");
  assert.equal((await figures(app)).time, late.time);
  await app.linked("tab", (tab) => tab === "map");
  // On paper is where it is from, and nothing to press.
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  const shown = await page.locator("#panel-map").innerText();
  assert.match(shown, /https?:\/\/\S+tab=map/);
  assert.doesNotMatch(shown, /Start mapping|Forget the map|^Method$/m);
  await page.emulateMedia({ media: null });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  // Forget the map asks first.
  await page.locator("#map-forget").click();
  assert.equal((await figures(app)).time, late.time);
  await page.getByRole("button", { name: "Forget it for good" }).click();
  await app.poll(() => stored(page), (ends) => ends.length === 0);
  await page.reload();
  await phase("ready");
});

/** Lets it drive, reloads the page meanwhile, and says what was on the clock when the page was left, s. */
async function reloadOnTheWay(page, app, until) {
  await page.locator("#map-play").click();
  await app.poll(() => figures(app), ({ time }) => time >= until);
  await page.evaluate(() => addEventListener("pagehide", () => sessionStorage.setItem("left", document.getElementById("map-n-time").textContent)));
  await page.reload();
  await page.locator("#map-play").waitFor();
  await phase(app, "paused");
  return seconds(await page.evaluate(() => sessionStorage.getItem("left")));
}

test("a reload while it drives takes nothing back", async (t) => {
  const { page, app } = await openMap(t, { link: SMALL.replace("256", "64") });
  // Before the database has anything, and with something in it.
  for (const until of [5, 60]) {
    const left = await reloadOnTheWay(page, app, until);
    assert.equal((await figures(app)).time, left);
    assert.equal(await app.message(), "");
  }
  await app.poll(() => page.evaluate(() => localStorage.getItem("map-last")), (last) => last === null);
});

test("where there is no room to keep the last moments, it says how much is missing", async (t) => {
  const { page, app } = await openMap(t, { link: SMALL.replace("256", "64") });
  const { time } = await explore(app, 30);
  await kept(app);
  await page.evaluate(() => {
    const full = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
    const set = Storage.prototype.setItem;
    Storage.prototype.setItem = function (key, value) {
      return value.length > 1000 ? full() : set.call(this, key, value);
    };
    IDBObjectStore.prototype.put = full;
  });
  const left = await reloadOnTheWay(page, app, time + 20);
  assert.equal((await figures(app)).time, time);
  const missing = Number(/resumes ([\d.]+) s before where you left it/.exec(await app.message())?.[1]);
  assert.ok(Math.abs(missing - (left - time)) <= 1, `${missing} of ${left - time} s`);
});

test("getting lost says that clock and figures restart, and leads back", async (t) => {
  const { page, app, phase } = await openMap(t);
  const before = await explore(app, 150);
  // Its clock goes on at once, so both are read at one moment.
  const began = page.waitForFunction(() => !document.getElementById("map-began").hidden && document.getElementById("map-n-time").textContent);
  await page.locator("#map-lose").click();
  assert.ok(seconds(await (await began).jsonValue()) < before.time);
  assert.match(await page.locator("#map-began-text").textContent(), /restart.*\d:\d\d min, \d+\.\d % mapped\) is kept/);
  // What counts now is where it is, not what is mapped.
  await app.poll(() => page.locator("#map-curve-name").textContent(), (text) => /^Position error over time/.test(text));
  assert.match(await page.locator("#map-curve-top").textContent(), /^\d+ c?m$/);
  await page.locator("#map-began-close").click();
  // It drives on, to find out.
  await app.poll(() => page.locator("#map-scrubber").getAttribute("aria-valuemax"), (end) => Number(end) > 10);
  await page.locator("#map-play").click();
  await phase("paused");
  assert.ok((await page.locator("#map-astray").getAttribute("d")).length > 0, "the time when it was lost isn't shaded");
  // However much it says of what it does, how sure it is stands below.
  const [doing, sure] = await page.locator(".map-states p").evaluateAll((pills) => {
    const boxes = pills.map((pill, i) => {
      pill.hidden = false;
      pill.textContent = ["Following the wall on the right, until only one position on the map matches what it senses.", "Relocalising"][i];
      return pill;
    });
    return boxes.map((pill) => pill.getBoundingClientRect().toJSON());
  });
  assert.ok(doing.height > 40 && doing.bottom <= sure.top, JSON.stringify([doing, sure]));
  await page.locator("#map-known").getByRole("button").first().click();
  await phase("paused");
  await app.poll(() => page.locator("#map-curve-name").textContent(), (text) => text === "Boundary mapped over time");
  await app.poll(() => figures(app), ({ time }) => time === before.time);
  assert.deepEqual(await figures(app), before);
  assert.ok(await page.locator("#map-began").isHidden() && await page.locator("#map-known").isHidden());
});

test("frontiers and the way to one are in the legend while they are drawn, and in words", async (t) => {
  const { page, app } = await openMap(t, { link: SMALL.replace("bounce", "explore_frontier").replace("256", "16") });
  const [frontier, way] = [page.locator(".map-legend .on-frontiers"), page.locator(".map-legend .on-route")];
  assert.ok(await frontier.isHidden() && await way.isHidden());
  await page.locator("#map-play").click();
  await app.poll(() => page.locator("#panel-map").getAttribute("data-drawn"), (goals) => goals === "frontiers route");
  await page.locator("#map-play").click();
  assert.ok(await frontier.isVisible() && await way.isVisible());
  await app.poll(() => page.locator("#map-floor").getAttribute("aria-label"), (words) => /driving to its goal; (one frontier is|\d+ frontiers are) left\./.test(words));
  await page.keyboard.press("l");
  await page.getByLabel("Goals, frontiers").uncheck();
  await frontier.waitFor({ state: "hidden" });
  assert.ok(await way.isHidden());
});

test("other choices have mapping runs of their own, and what was mapped comes back with them", async (t) => {
  const { page, app, phase } = await openMap(t);
  const first = await explore(app, 60);
  await page.locator("#map-track").selectOption("odometry");
  await phase("ready");
  assert.equal((await figures(app)).time, 0);
  await page.getByText("To return to the last one, choose the previous settings again").waitFor();
  await page.locator("#map-track").selectOption("corrected");
  await phase("paused");
  assert.deepEqual(await figures(app), first);
});

test("what another version has stored is explained and kept aside", async (t) => {
  const { page, app, phase } = await openMap(t);
  await explore(app, 40);
  await kept(app);
  await edit(page, (text) => text.replace(/"version":\d+/, '"version":99'));
  await page.reload();
  await phase("ready");
  await app.says(/another version/);
  assert.ok(await page.locator("#map-aside").isVisible());
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#map-aside-save").click()]);
  assert.match(fs.readFileSync(await download.path(), "utf8"), /robovac-survey/);
  // The page goes on.
  await explore(app, 20);
});

test("a mapping run goes out as a ROS 2 bag", async (t) => {
  const { page, app } = await openMap(t);
  assert.ok(await page.locator("#map-bag").isDisabled(), "there is no run yet");
  const { time } = await explore(app, 60);
  const [download] = await taken(page, 1, () => page.locator("#map-bag").click());
  const messages = messagesOf(fs.readFileSync(await download.path()));
  const maps = messages["/map"];
  assert.ok(maps.length > 5 && maps.at(-1)[1].length > maps[0][1].length, `${maps.length} maps`);
  assert.ok(Math.abs(maps.at(-1)[0] - time) < 1.1, `${maps.at(-1)[0]} s of ${time} s`);
  assert.equal(messages["/ground_truth/map"].length, 1);
});

test("the map is exported as a ROS map that comes back, and becomes a room", async (t) => {
  const { page, app, phase } = await openMap(t);
  await explore(app, 200);
  const files = await exported(page);
  const yaml = files.find(({ name }) => name.endsWith(".yaml")).bytes.toString();
  const pgm = files.find(({ name }) => name.endsWith(".pgm")).bytes;
  assert.match(yaml, /image: "?[\w-]+\.pgm"?\nmode: trinary\nresolution: 0\.05\norigin: \[-?[\d.]+, -?[\d.]+, 0\]/);
  const [, width, height] = /^P5\n(\d+) (\d+) 255\n/.exec(pgm.toString("latin1")).map(Number);
  assert.ok(width > 40 && height > 40 && pgm.length >= width * height);
  const shades = new Set(pgm.subarray(pgm.length - width * height));
  assert.deepEqual([...shades].sort((a, b) => a - b), [0, 205, 254]);

  // It is the robot's map now: the robot is lost on it.
  await give(page, app, files);
  await phase("ready");
  assert.equal((await figures(app)).error, "–");
  assert.ok(await page.locator("#map-known").isVisible());
  await page.locator("#map-close").click();
  await phase("paused");
  await page.locator("#map-room-use").click();
  await app.settled();
  assert.equal(await app.page.locator("#tab-explore").getAttribute("aria-current"), "page");
  assert.match(await app.room(), /as mapped/);
});

test("the thesis' grid of the same run is shown, and exported in its own cells", async (t) => {
  const { page, app } = await openMap(t);
  const own = await explore(app, 120);
  const before = await picture(page);
  await page.locator("#map-grid").selectOption("thesis");
  await page.locator("#map-here").getByText("Thesis").waitFor();
  await app.poll(() => picture(page), (now) => now !== before);
  const thesis = await figures(app);
  assert.ok(thesis.time === own.time && thesis.mapped !== own.mapped, JSON.stringify([own, thesis]));
  await app.poll(() => page.url(), (url) => url.includes("grid=thesis"));
  const files = await exported(page);
  assert.match(files.find(({ name }) => name.endsWith(".yaml")).bytes.toString(), /resolution: 0\.1\n/);
  assert.match(files.find(({ name }) => name.endsWith(".pgm")).bytes.toString("latin1"), /^P5\n100 100 255\n/);
});

test("maps that can't be opened are explained, and the current one stays", async (t) => {
  const { page, app } = await openMap(t);
  const before = await explore(app, 40);
  const yaml = (name, more) => anyFile(`${name}.yaml`, `image: ${name}.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n${more}`);
  const cases = [
    // Fewer pixels than it says.
    [[yaml("short", ""), anyFile("short.pgm", "P5\n9 9 255\nabc")], /short\.pgm/],
    // Thresholds that are none.
    [[anyFile("odd.yaml", "image: odd.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: high\nfree_thresh: 0.196\n"), anyFile("odd.pgm", "P2\n2 1\n255\n0 254\n")], /occupied_thresh/],
    // Another kind of file.
    [[anyFile("photo.pgm", "GIF89a....")], /GIF/],
    [[yaml("alone", "")], /alone\.pgm/],
  ];
  for (const [files, pattern] of cases) {
    await give(page, app, files);
    await app.says(pattern);
    assert.deepEqual(await figures(app), before);
    assert.ok(await page.locator("#map-known").isHidden());
  }
});

test("it cleans by its own map, which time can be gone back over and a reload brings back", async (t) => {
  const { page, app, phase } = await openMap(t);
  assert.ok(await page.locator("#map-clean").isDisabled(), "there is no map");
  await page.locator("#map-planner").selectOption("boustrophedon");
  assert.equal(await app.linked("clean", (id) => id !== undefined), "boustrophedon");
  const { time } = await explore(app, 200);
  // Not so fast, so that there is something left to be stopped.
  await page.locator("#map-speed").selectOption("16");
  await page.locator("#map-clean").click();
  await phase("playing");
  await app.poll(() => figures(app), (now) => now.time >= time + 20);
  await page.locator("#map-play").click();
  await phase("paused");
  assert.match(await page.locator("#map-activity").textContent(), /clean|floor|map|backing|turning/i);
  const numbers = () => page.locator("#map-more").textContent();
  assert.match(await numbers(), /Cleaned by its map[\d.]+ %, [\d.]+ m² left/);
  const end = (await figures(app)).time;
  assert.equal(seconds(await page.locator("#map-drift-end").textContent()), end, "the axis of errors ends where the clock is");
  const before = [await figures(app), await numbers()];
  await kept(app);
  await page.reload();
  await page.locator("#map-play").waitFor();
  await phase("paused");
  assert.deepEqual([await figures(app), await numbers()], before);
  assert.equal(await page.locator("#panel-map").getAttribute("data-cleaning"), "true");
  // Before it began to clean.
  await page.keyboard.press("r");
  await app.poll(() => page.locator("#panel-map").getAttribute("data-cleaning"), (is) => is === "false");
  assert.match(await numbers(), /Cleaned by its map–/);
});

test("kidnapped while it cleans, it relocalises on its map and continues", async (t) => {
  const { page, app, phase } = await openMap(t, { link: SMALL.replace("bounce", "explore_frontier") });
  const { time } = await explore(app, 200);
  await page.locator("#map-speed").selectOption("16");
  await page.locator("#map-clean").click();
  await phase("playing");
  await app.poll(() => figures(app), (now) => now.time >= time + 5);
  await page.keyboard.press("p");
  await phase("held");
  await page.locator("#map-floor").focus();
  for (let i = 0; i < 8; i++) await page.keyboard.press("ArrowRight");
  for (let i = 0; i < 3; i++) await page.keyboard.press("Shift+ArrowLeft");
  await page.keyboard.press("Enter");
  await phase("playing", "paused");
  if ((await page.locator("#panel-map").getAttribute("data-phase")) === "paused") await page.locator("#map-play").click();
  await app.poll(() => page.locator("#map-activity").textContent(), (text) => /relocalising/i.test(text));
  await page.locator(".on-particles").waitFor();
  assert.ok(await page.locator("#map-sure").isVisible());
  const badges = await page.locator(".map-states p:visible").allInnerTexts();
  assert.ok(badges.filter((text) => /^relocalising/i.test(text)).length < 2, badges.join(", "));
  await page.locator("#map-speed").selectOption("256");
  await app.poll(() => page.locator("#map-activity").textContent(), (text) => /cleaning by its map|done/i.test(text));
  assert.ok(await page.locator("#map-sure").isHidden());
});

test("a search on a map that was given goes on after a reload, until the map is given back", async (t) => {
  const { page, app, phase } = await openMap(t);
  await explore(app, 150);
  await give(page, app, await exported(page));
  await phase("ready");
  const before = await explore(app, 30);
  await kept(app, 3);
  await page.reload();
  await page.locator("#map-play").waitFor();
  await phase("paused");
  assert.ok(await page.locator("#map-known").isVisible());
  assert.deepEqual(await figures(app), before);
  await page.locator("#map-close").click();
  await app.poll(() => figures(app), ({ time }) => time >= 150);
  await phase("paused");
  await page.reload();
  await page.locator("#map-play").waitFor();
  await phase("paused");
  assert.ok(await page.locator("#map-known").isHidden());
});

test("on a phone it fits, and its panels are sheets", async (t) => {
  const { page, app } = await openMap(t, PHONE);
  const hint = await page.locator("#map-hint").boundingBox();
  for (const over of ["#map-stage .legend", "#map-stage .zoom"]) {
    const box = await page.locator(over).boundingBox();
    assert.ok(!box || box.y >= hint.y + hint.height, `${over} covers the hint: ${JSON.stringify([box, hint])}`);
  }
  await explore(app, 30);
  const overflow = () => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.equal(await overflow(), 0);
  for (const name of ["Setup", "Numbers", "Exploration"]) {
    await page.locator("#panel-map .sheet-bar").getByRole("button", { name }).click();
    const id = { Setup: "map-setup", Numbers: "map-facts", Exploration: "map-explainer" }[name];
    await app.poll(() => page.locator(`#${id}`).boundingBox(), (box) => box && box.x >= 0 && box.x + box.width <= 390 && box.height > 100, name);
    assert.equal(await overflow(), 0, name);
  }
  for (const tab of await page.locator("[id^=tab-]").all()) {
    const box = await tab.boundingBox();
    assert.ok(box && box.x >= 0 && box.x + box.width <= 390, await tab.innerText());
  }
  const help = await page.locator("#help-open").boundingBox();
  assert.ok(help && help.x + help.width <= 390, "help is within reach");
});

/** Of all mapping runs that are kept in this browser, how far each has come, s. */
const stored = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) => {
        const request = indexedDB.open("robovac-maps");
        request.onsuccess = () => {
          const all = request.result.transaction("surveys").objectStore("surveys").getAll();
          all.onsuccess = () => {
            request.result.close();
            resolve(all.result.map(({ end }) => end));
          };
        };
      }),
  );

/** Waits until what is shown is kept as far as it has come, as one of so many entries. */
const kept = (app, entries = 1) =>
  app.poll(
    async () => [await stored(app.page), Number(await app.page.locator("#map-scrubber").getAttribute("aria-valuemax"))],
    ([ends, end]) => ends.length === entries && ends.some((at) => Math.abs(at - end) < 1),
  );

/** Changes what is stored. */
const edit = (page, change) =>
  page.evaluate(
    (source) =>
      new Promise((resolve, reject) => {
        const change = new Function(`return ${source}`)();
        const request = indexedDB.open("robovac-maps");
        request.onsuccess = () => {
          const store = request.result.transaction("surveys", "readwrite").objectStore("surveys");
          const all = store.getAll();
          all.onsuccess = () => {
            for (const kept of all.result) store.put({ ...kept, text: change(kept.text) });
          };
          store.transaction.oncomplete = () => {
            request.result.close();
            resolve(undefined);
          };
          store.transaction.onerror = () => reject(store.transaction.error);
        };
      }),
    change.toString(),
  );

/** The two files of an exported map. */
async function exported(page) {
  const downloads = await taken(page, 2, () => page.locator("#map-export").click());
  return Promise.all(downloads.map(async (download) => ({ name: download.suggestedFilename(), bytes: fs.readFileSync(await download.path()) })));
}

/** Gives the robot a map, and waits for what comes of it. */
async function give(page, app, files) {
  const before = await page.locator("#panel-map").getAttribute("data-opened");
  await page.locator("#map-files").setInputFiles(files.map(({ name, bytes }) => ({ name, mimeType: "application/octet-stream", buffer: bytes })));
  await app.poll(() => page.locator("#panel-map").getAttribute("data-opened"), (now) => now !== before);
  await app.frames(3);
}
