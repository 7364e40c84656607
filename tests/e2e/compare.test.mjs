// The tab Compare: algorithms compared in a race and by numbers.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { App, openApp, seconds } from "./app.mjs";
import { openPage } from "./harness.mjs";

const FOUR = "boustrophedon,snake,spiral_stc,wavefront_path";
const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };

/** Opens a comparison by its link, without waiting for plans. */
async function openCompare(t, { link = `vs=${FOUR}`, room = "room=empty", view = "race", ...options } = {}) {
  const opened = await openPage(t, { address: `#${room}&tab=compare&view=${view}&${link}`, ...options });
  const app = new App(opened.page);
  await opened.page.locator("body[data-tab=compare][data-boot=ready]").waitFor();
  return { ...opened, app };
}

/** Waits until all plans are made, or have failed, without a limit for slow computers. */
const tried = (page, count) =>
  page.waitForFunction((n) => document.getElementById("trying").textContent.startsWith(`${n} plan`), count, { timeout: 240_000 });

const lanes = (page, count) => page.waitForFunction((n) => document.querySelectorAll("#lanes figure").length === n, count, { timeout: 60_000 });

/** The seconds on the clock, and those in every lane's description. */
async function clocks(page) {
  const [clock, words] = await page.evaluate(() => [
    document.getElementById("race-time").textContent,
    [...document.querySelectorAll("#lanes canvas")].map((canvas) => canvas.getAttribute("aria-label") ?? ""),
  ]);
  return { clock: seconds(clock), lanes: words.map((text) => seconds(/clean after ([\d:]+) and/.exec(text)?.[1] ?? "NaN")) };
}

/** Waits until the clock fits, and checks that no lane has another one. */
async function clockThat(app, fits) {
  const { clock, lanes } = await app.poll(() => clocks(app.page), ({ clock, lanes }) => fits(clock) && lanes.every((lane) => lane === clock));
  assert.ok(lanes.length > 0);
  return clock;
}

/** For each canvas: number of different colours among some of its pixels, and a number that tells pictures apart. */
const pictures = (page, selector) =>
  page.evaluate(
    (which) =>
      [...document.querySelectorAll(which)].map((canvas) => {
        const copy = new OffscreenCanvas(canvas.width, canvas.height);
        const context = copy.getContext("2d");
        context.drawImage(canvas, 0, 0);
        const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
        let sum = 0;
        for (const pixel of pixels) sum = (Math.imul(sum, 31) + pixel) | 0;
        return { colours: new Set(pixels).size, sum };
      }),
    selector,
  );

/** The table as it stands: names of columns and rows, texts of cells without ranges, which are the best. */
const table = (page) =>
  page.evaluate(() => {
    const of = (root, selector) => [...root.querySelectorAll(selector)];
    return {
      columns: of(document, "#compared thead th").map((th) => th.querySelector("button")?.textContent ?? th.textContent),
      sorts: of(document, "#compared thead th").map((th) => th.getAttribute("aria-sort")),
      rows: of(document, "#compared tbody tr").map((tr) => ({
        name: tr.querySelector("th button").textContent,
        cells: of(tr, "td").map((td) => td.firstChild?.nodeType === Node.TEXT_NODE ? td.firstChild.data : td.textContent),
        ranges: of(tr, "td").map((td) => td.querySelector("small")?.textContent ?? ""),
        best: of(tr, "td").map((td) => td.classList.contains("best")),
      })),
    };
  });

/** A cell as a number: "1:02:03" in seconds, "1,234.5" without its comma. */
const value = (text) => (text.includes(":") ? seconds(text) : Number(text.replace(/,/g, "")));

/** The values of a column, from top to bottom. */
const column = ({ columns, rows }, name) => rows.map(({ cells }) => value(cells[columns.indexOf(name) - 1]));

/** The file saved by a click on an export button. */
async function saved(page, kind) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-export=${kind}]`).click()]);
  assert.match(download.suggestedFilename(), new RegExp(`^comparison-.*\\.${kind}$`));
  return fs.readFileSync(await download.path());
}

/** Lines of a CSV file, by the names of its head. */
function parseCsv(text) {
  const lines = text.trimEnd().split("\n").map((line) => [...line.matchAll(/("(?:[^"]|"")*"|[^,]*)(?:,|$)/g)].map(([, field]) => field.replace(/^"|"$/g, "").replace(/""/g, '"')));
  const [head, ...rows] = lines;
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i]])));
}

test("one goes to Compare and back by tabs, and both tabs stay as they were", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=lshape&planner=spiral_stc&speed=4" });
  await app.pause();
  const { time } = await app.numbers();
  await page.locator("#tab-compare").click();
  await page.locator("#panel-compare").waitFor();
  assert.equal(await page.locator("#tab-compare").getAttribute("aria-current"), "page");
  assert.ok(await page.locator("#panel-explore").isHidden());
  assert.equal(await app.text("#compare-room"), "L-shaped room");
  await lanes(page, 4);
  await page.locator("#view-numbers").click();
  assert.equal(await app.linked("tab"), "compare");
  await app.linked("view", (view) => view === "numbers");
  await page.locator("#to-explore").click();
  await page.locator("#panel-explore").waitFor();
  assert.equal(await page.locator("#algorithm").inputValue(), "spiral_stc");
  assert.equal((await app.numbers()).time, time, "Explore stood still meanwhile");
  assert.equal(await app.linked("tab", (tab) => tab === undefined), undefined);
  await page.locator("#tab-compare").click();
  assert.equal(await page.locator("#view-numbers").getAttribute("aria-pressed"), "true");
  await tried(page, 4);
});

test("the copied link brings room, algorithms, parameters, seeds and view to another page", async (t) => {
  const { page, app, context } = await openCompare(t, { room: "room=thesis8&robot=cell&seed=5", permissions: ["clipboard-read", "clipboard-write"] });
  await page.locator("#compare-seeds").selectOption("3");
  await page.locator("#compare-rooms").selectOption("shapes");
  for (const id of ["boustrophedon", "wavefront_path"]) await page.locator(`#in-${id}`).uncheck();
  await page.locator("#entrants li[data-id=snake] summary").click();
  const patience = page.locator("#in-snake-param-patience");
  await patience.fill("5");
  await page.keyboard.press("Tab");
  await page.locator("#view-numbers").click();
  await app.linked("vs", (vs) => vs === "snake~patience:5,spiral_stc");
  // The order of the rows and the room of the table, too: twice the same column is the worst first.
  const sort = page.locator("#compared thead button", { hasText: /^Distance$/ });
  for (let i = 0; i < 2; i += 1) await sort.click();
  await page.locator("#table-room").selectOption("2");
  await app.linked("sort", (metric) => metric?.endsWith("-"));
  await app.linked("of", (room) => room === "2");
  await page.getByRole("button", { name: "Copy link" }).click();
  const copied = await app.poll(() => page.evaluate(() => navigator.clipboard.readText()), (text) => text.includes("tab=compare"));

  const other = await context.newPage();
  await other.goto(copied);
  await other.locator("#panel-compare").waitFor();
  const chosen = await other.locator("#entrants li:has(> input:checked)").evaluateAll((items) => items.map((item) => item.dataset.id));
  assert.deepEqual(chosen, ["spiral_stc", "snake"]);
  assert.equal(await other.locator("#in-snake-param-patience").inputValue(), "5");
  assert.equal(await other.locator("#compare-seeds").inputValue(), "3");
  assert.equal(await other.locator("#compare-rooms").inputValue(), "shapes");
  assert.equal(await other.locator("#view-numbers").getAttribute("aria-pressed"), "true");
  await other.locator("#compared thead [aria-sort=descending]", { hasText: "Distance" }).waitFor();
  assert.equal(await other.locator("#table-room").inputValue(), "2");
  assert.match(await other.locator("#compare-robot").innerText(), /seed 5/);
  assert.equal(await other.locator("#compare-room").innerText(), await page.locator("#compare-room").innerText());
  await new App(other).linked("vs", (vs) => vs === "snake~patience:5,spiral_stc");
  assert.deepEqual(await new App(other).link(), await app.link());
});

test("algorithms are chosen by keyboard, and all robots have one clock", async (t) => {
  const { page, app } = await openCompare(t, { link: "vs=snake" });
  await lanes(page, 1);
  await page.locator("#in-snake").focus();
  await page.keyboard.press("Space");
  await page.locator("#race-hint", { hasText: "Choose at least two algorithms." }).waitFor();
  await page.keyboard.press("Space");
  for (const id of ["spiral_stc", "wavefront_path"]) {
    await page.locator(`#in-${id}`).focus();
    await page.keyboard.press("Space");
  }
  await lanes(page, 3);
  await tried(page, 3);

  assert.equal(await clockThat(app, (clock) => clock === 0), 0);
  await page.locator("#race-speed").selectOption("16");
  await page.locator("#view-race").focus();
  await page.keyboard.press(".");
  await page.getByRole("button", { name: "Forward 5 seconds" }).click();
  const stepped = await clockThat(app, (clock) => clock >= 9);

  await page.getByRole("button", { name: "Start the race" }).click();
  await app.poll(() => clocks(page), ({ clock }) => clock > 30);
  await page.getByRole("button", { name: "Pause" }).click();
  const paused = await clockThat(app, (clock) => clock > 30);
  await app.frames(10);
  assert.equal(await clockThat(app, () => true), paused, "time stands still");
  const shown = await pictures(page, "#lanes canvas");
  assert.ok(shown.every(({ colours }) => colours > 5), JSON.stringify(shown));
  assert.equal(new Set(shown.map(({ sum }) => sum)).size, 3, "every lane has a picture of its own");
  const leaders = await page.locator("#lanes figure[data-leads=true]").count();
  assert.equal(leaders, 1);

  // Back by the time line.
  const scrub = page.locator("#race-scrub");
  await scrub.evaluate((range, to) => {
    range.focus();
    range.value = String(to);
    range.dispatchEvent(new Event("input", { bubbles: true }));
  }, stepped + 5);
  assert.equal(await clockThat(app, (clock) => Math.abs(clock - stepped - 5) <= 1) > 0, true);
  const back = await pictures(page, "#lanes canvas");
  assert.ok(back.every(({ sum }, lane) => sum !== shown[lane].sum), "pictures of earlier");
  await page.keyboard.press("End");
  // The time line reaches beyond what was driven; robots that have arrived by then stand still.
  const { clock: end } = await app.poll(() => clocks(page), ({ clock }) => clock > paused + 60);
  await app.poll(async () => Number(await scrub.inputValue()), (at) => Math.abs(at - end) <= 1);
  await page.keyboard.press("r");
  assert.equal(await clockThat(app, (clock) => clock === 0), 0);
  await app.poll(async () => Number(await scrub.inputValue()), (at) => at === 0);
  await page.locator("#view-race").focus();
  await page.locator("body").evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Space");
  await page.getByRole("button", { name: "Pause" }).waitFor();
  await page.locator("#race-speed").selectOption("0");
  await page.waitForFunction(() => [...document.querySelectorAll("#lanes output")].every((output) => / in \d/.test(output.textContent)), undefined, { timeout: 120_000 });
  await page.locator("#trying").getByText(/^The race is over\. First: .+, \d+\.\d % in [\d:]+\./).waitFor({ state: "attached" });
  const words = await page.locator("#lanes canvas").evaluateAll((all) => all.map((canvas) => canvas.getAttribute("aria-label")));
  for (const text of words) assert.match(text, /^[A-Z].*: \d+\.\d % of the reachable floor is clean after [\d:]+ and [\d.,]+ m, done; place \d\.$/);
});

test("all algorithms have all numbers; they can be sorted, explained and shown", async (t) => {
  const { page, app } = await openCompare(t, { room: "room=bedroom", view: "numbers" });
  await page.locator("#choose-all").click();
  // Without steps and turns, and a search of minutes.
  await page.locator("#entrants li[data-id=lanes] > input").uncheck();
  const planners = (await page.locator("#entrants li").count()) - 1;
  assert.ok(planners >= 14);
  await tried(page, planners);
  const first = await app.poll(() => table(page), ({ rows }) => rows.length === planners);
  assert.match(await app.text("#trying"), /^\d+ plans made$/);
  // So small a room may be planned in no time.
  for (const { name, cells } of first.rows) assert.ok(cells.every((cell) => Number.isFinite(value(cell.replace(/^< /, "")))), `${name}: ${cells}`);
  assert.ok(column(first, "Coverage").every((share) => share > 95 && share <= 100));
  assert.ok(column(first, "Above the minimum").every((percent) => percent >= 0));

  for (const [name, lower] of [["Distance", true], ["Time", true], ["Quarter turns", true], ["Coverage", false]]) {
    const at = first.columns.indexOf(name);
    const heading = page.locator("#compared thead button", { hasText: new RegExp(`^${name}$`) });
    await heading.focus();
    const directions = lower ? ["ascending", "descending"] : ["descending", "ascending"];
    for (const direction of directions) {
      await page.keyboard.press("Enter");
      const now = await table(page);
      assert.deepEqual(now.sorts.filter((sort) => sort && sort !== "none"), [direction], name);
      assert.equal(now.sorts[at], direction, name);
      const values = column(now, name);
      const sorted = [...values].sort((a, b) => (direction === "ascending" ? a - b : b - a));
      assert.deepEqual(values, sorted, `${name} ${direction}`);
      assert.equal(await heading.evaluate((node) => node === document.activeElement), true, "the focus stays");
      const best = lower ? Math.min(...values) : Math.max(...values);
      for (const { name: who, best: marks, cells } of now.rows) assert.equal(marks[at - 1], value(cells[at - 1]) === best, `${who}, ${name}`);
    }
    await page.keyboard.press("Enter");
    assert.deepEqual((await table(page)).rows.map((row) => row.name), first.rows.map((row) => row.name), "as before");
  }

  // By name, as by a number.
  await page.locator("#compared thead button", { hasText: /^Algorithm$/ }).click();
  const names = (await table(page)).rows.map((row) => row.name);
  assert.deepEqual(names, [...names].sort((a, b) => a.localeCompare(b, "en")));
  assert.notDeepEqual(names, first.rows.map((row) => row.name));
  await app.linked("sort", (sort) => sort === "name");
  for (let i = 0; i < 2; i += 1) await page.locator("#compared thead button", { hasText: /^Algorithm$/ }).click();

  // How far behind, in words.
  const lengths = column(first, "Distance");
  const least = Math.min(...lengths);
  const worst = lengths.indexOf(Math.max(...lengths));
  const cell = page.locator("#compared tbody tr").nth(worst).locator("td").nth(first.columns.indexOf("Distance") - 1);
  await cell.hover();
  const percent = Math.round((100 * (lengths[worst] - least)) / least);
  const tip = await app.text("#tip");
  assert.match(tip, /^Distance: (\d+) % more than the best \(/);
  assert.ok(Math.abs(Number(/(\d+) %/.exec(tip)[1]) - percent) <= 1, tip);
  assert.ok(tip.includes(first.rows[lengths.indexOf(least)].name), tip);

  const charts = page.locator("#charts svg[role=img]");
  assert.ok((await charts.count()) >= 4);
  for (const label of await charts.evaluateAll((all) => all.map((svg) => svg.getAttribute("aria-label")))) assert.ok(label.length > 20);

  // A row shows the path, also of an algorithm for which the race has no lane, and leads to Explore.
  await page.locator("#compared tbody tr").last().locator("td").first().click();
  await page.locator("#about[open]").waitFor();
  assert.ok(await page.locator("#about-none").isHidden());
  assert.ok((await pictures(page, "#about-path"))[0].colours > 5);
  await page.keyboard.press("Escape");
  const growing = page.locator("#compared tbody tr", { hasText: "Growing spirals" });
  await growing.locator("td").first().click();
  await page.locator("#about[open]").waitFor();
  assert.equal(await app.text("#about-title"), "Growing spirals");
  const [path] = await pictures(page, "#about-path");
  assert.ok(path.colours > 5, `${path.colours} colours`);
  assert.match(await page.locator("#about-path").getAttribute("aria-label"), /^Path of Growing spirals in Bedroom$/);
  await page.locator("#about .claims li").first().hover();
  assert.match(await app.text("#about #tip"), /every reachable cell/, "before the dialog, not behind it");
  await page.getByRole("button", { name: "Open in Explore" }).click();
  await page.locator("#panel-explore").waitFor();
  await app.poll(() => page.locator("#algorithm").inputValue(), (id) => id === "spiral");
  await app.until("playing", "ready", "paused", "finished");
  // What has one name is one number.
  const { cells } = first.rows.find(({ name }) => name === "Growing spirals");
  await app.poll(() => app.metric("Above the minimum"), ({ plan }) => /%/.test(plan));
  for (const [there, here] of [["Coverage"], ["Above the minimum"], ["Distance"], ["Time"], ["Turned in all"], ["Steps"], ["Revisits"], ["Swept again"]]) {
    const { plan } = await app.metric(here ?? there);
    assert.equal(plan.replace(/ ?(%|m|turns)$/, ""), cells[first.columns.indexOf(there) - 1], there);
  }
});

test("it is said why the path of an algorithm can't be shown yet", async (t) => {
  const { page, app } = await openCompare(t, { room: "room=empty", view: "numbers", link: "vs=snake,spiral" });
  await tried(page, 2);
  await page.getByRole("button", { name: "About S-shaped pathway" }).click();
  await page.locator("#about[open]").waitFor();
  assert.match(await app.text("#about-none"), /once it has been planned/);
  assert.ok(await page.locator("#about-path").isHidden());
});

test("numbers of several rooms are summed up", async (t) => {
  const { page, app } = await openCompare(t, { view: "numbers", link: "vs=boustrophedon,snake&rooms=shapes&seeds=1" });
  const menu = page.locator("#table-room");
  const rooms = (await menu.locator("option").count()) - 1;
  assert.ok(rooms >= 2, `${rooms} rooms`);
  await tried(page, 2 * rooms);
  assert.equal(await menu.inputValue(), "all");
  const together = await table(page);
  assert.match(await app.text("#table-note"), /Sums over the rooms; percentages are means/);
  // The one room of Explore isn't where that was measured.
  assert.match(await app.text("#compare-room"), new RegExp(`^\\D+ \\(${rooms}\\)$`));
  assert.match(await app.text("#compare-robot"), /^Roomba .*cells of .* seed/);
  const sums = { Steps: [0, 0], Coverage: [0, 0] };
  for (let room = 0; room < rooms; room += 1) {
    await menu.selectOption(String(room));
    const alone = await app.poll(() => table(page), ({ rows }) => rows.length === 2);
    await app.frames(2);
    for (const name of Object.keys(sums)) column(await table(page), name).forEach((number, row) => (sums[name][row] += number));
    assert.equal(alone.rows.length, 2);
  }
  assert.deepEqual(column(together, "Steps"), sums.Steps);
  column(together, "Coverage").forEach((mean, row) => assert.ok(Math.abs(mean - sums.Coverage[row] / rooms) < 0.11));
});

test("an algorithm that uses chance has a range over its seeds, one that doesn't has none", async (t) => {
  const { page, app } = await openCompare(t, { view: "numbers", link: "vs=snake,genetic&seeds=3", room: "room=thesis8&robot=cell" });
  await tried(page, 4);
  const { rows } = await app.poll(() => table(page), (shown) => shown.rows.length === 2);
  const [chance, certain] = ["Genetic algorithm", "Improved snake"].map((name) => rows.find((row) => row.name === name));
  assert.ok(chance.ranges.some((range) => range.includes("–")), JSON.stringify(chance));
  assert.ok(certain.ranges.every((range) => range === ""), JSON.stringify(certain));
  assert.match(await app.text("#table-note"), /median of 3 seeds/);
});

test("a link with an algorithm that isn't there says which was meant", async (t) => {
  const { page, app } = await openCompare(t, { link: "vs=snale,snake" });
  await page.locator("#message").waitFor();
  await app.says(/^There is no planner "snale"; did you mean "snake"\?/);
  // While plans are made, the head is taller.
  const places = () => page.evaluate(() => [document.querySelector(".arena-head")?.getBoundingClientRect().bottom, document.getElementById("message")?.getBoundingClientRect().top]);
  await app.poll(places, ([head, message]) => message >= head, "the message to cover no button");
  await page.getByRole("button", { name: "Dismiss" }).click();
  await page.locator("#message").waitFor({ state: "hidden" });
  await lanes(page, 4);
});

test("planning can be cancelled and resumed", async (t) => {
  const { page, app } = await openCompare(t, { room: "room=flat", view: "numbers", link: "vs=snake,genetic,neural,energy,grid_tsp&rooms=furnished&seeds=20" });
  await page.getByRole("button", { name: "Cancel", exact: true }).click();
  await page.locator("#trying", { hasText: /^Stopped: \d+ of \d+/ }).waitFor();
  const stopped = await app.text("#trying");
  await app.frames(30);
  assert.equal(await app.text("#trying"), stopped);
  await page.getByRole("button", { name: "Resume", exact: true }).click();
  await page.locator("#trying", { hasText: /^Planning: / }).waitFor();
  // A smaller choice ends trials that are no longer required.
  for (const id of ["genetic", "neural", "energy", "grid_tsp"]) await page.locator(`#in-${id}`).uncheck();
  await page.locator("#compare-rooms").selectOption("this");
  await tried(page, 1);
  assert.ok(await page.locator("#trying-stop").isHidden());
  assert.ok(await page.locator("#trying-bar").isHidden());
});

test("numbers and charts can be saved", async (t) => {
  const { page } = await openCompare(t, { view: "numbers", link: "vs=boustrophedon,snake,genetic&seeds=3", room: "room=thesis8&robot=cell&seed=4" });
  await tried(page, 5);
  const shown = await table(page);
  const snake = shown.rows.find(({ name }) => name === "Improved snake");
  const steps = value(snake.cells[shown.columns.indexOf("Steps") - 1]);

  const csv = parseCsv((await saved(page, "csv")).toString());
  assert.deepEqual(csv.map(({ planner, seed }) => `${planner} ${seed}`), ["boustrophedon 4", "snake 4", "genetic 4", "genetic 5", "genetic 6"]);
  assert.equal(Number(csv[1].steps), steps);
  assert.ok(csv.every((row) => row.room.length > 3 && row.error === "" && Number(row["length [m]"]) > 1), JSON.stringify(csv[0]));

  const json = JSON.parse((await saved(page, "json")).toString());
  assert.deepEqual(json.map(({ planner, seed }) => `${planner} ${seed}`), csv.map(({ planner, seed }) => `${planner} ${seed}`));
  assert.equal(json[1].numbers.steps, steps);
  assert.equal(json[1].params.patience, 2);

  const svg = (await saved(page, "svg")).toString();
  const drawing = await page.evaluate((text) => {
    const xml = new DOMParser().parseFromString(text, "image/svg+xml");
    return { faults: xml.querySelectorAll("parsererror").length, bars: xml.querySelectorAll("rect[width]").length, text: xml.documentElement.textContent };
  }, svg);
  assert.equal(drawing.faults, 0);
  assert.ok(drawing.bars > 8, `${drawing.bars} bars`);
  assert.ok(drawing.text.includes("Improved snake") && drawing.text.includes("Quarter turns"));
  assert.ok(!svg.includes("var("), "it needs no style sheet");

  const png = await saved(page, "png");
  assert.equal(png.subarray(1, 4).toString(), "PNG");
  const colours = await page.evaluate(async (text) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${text}`)).blob());
    const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, png.toString("base64"));
  assert.ok(colours > 10, `${colours} colours`);

  // Before the first plan there is none, which is no mistake of the page.
  await page.locator("#charts").evaluate((charts) => charts.replaceChildren());
  await page.locator("[data-export=svg]").click();
  await page.getByText("The SVG could not be created: there are no charts yet.").waitFor();
});

test("table 2 of the thesis is one click away, with its printed values beside the bars", async (t) => {
  const { page, app, screenshot } = await openCompare(t, { room: "room=flat", link: "vs=neural&rooms=this", viewport: { width: 1440, height: 900 } });
  await page.locator("#compare-table-2").click();
  await page.locator(".compare[data-view=numbers]").waitFor({ state: "attached" });
  await tried(page, 3);
  const { rows } = await app.poll(() => table(page), (shown) => shown.rows.length === 3 && shown.rows.every(({ cells }) => cells.every((cell, at) => cell !== "–" || shown.columns[at + 1].startsWith("Excess"))));
  assert.deepEqual(rows.map(({ name }) => name).sort(), ["Genetic algorithm", "Growing spirals", "Improved snake"]);
  assert.match(await app.text("#compare-robot"), /cells of 20 cm/);
  assert.match(await app.text("#table-note"), /Table 2 as Emu & Obaida print it/);
  // Figures 5.4 to 5.6, in this order.
  const charts = await page.locator("#charts figure").evaluateAll((all) => all.map((figure) => [figure.querySelector("figcaption").textContent, figure.querySelectorAll("rect.printed").length]));
  assert.deepEqual(charts.slice(0, 3), [["Distance, m", 3], ["Direction changes", 3], ["Revisits", 3]]);
  assert.ok(charts.slice(3).every(([, printed]) => printed === 0));
  assert.match(await app.text("#charts"), /37 printed/);
  await screenshot("table-2");
  // However wide the column is, their text stays small.
  await page.setViewportSize({ width: 760, height: 900 });
  assert.ok((await page.locator("#charts svg").first().boundingBox()).width < 420);
});

test("a planner and its copy are named by the setting that differs, and heads don't cut that off", async (t) => {
  const { page, app, screenshot } = await openCompare(t, { room: "room=bedroom", link: "vs=boustrophedon,boustrophedon~lanes:vertical,boustrophedon~lanes:horizontal&rooms=this", viewport: { width: 1000, height: 800 } });
  await lanes(page, 3);
  const names = await page.locator("#lanes .name").allInnerTexts();
  assert.deepEqual(names.map((name) => /, ([^,]+)$/.exec(name.replaceAll(/\s+/g, " "))?.[1]), ["automatic", "vertical", "horizontal"]);
  const cut = await page.locator("#lanes .uncut").evaluateAll((all) => all.filter((node) => node.scrollWidth > node.clientWidth + 1).map((node) => node.textContent));
  assert.deepEqual(cut, []);
  await screenshot("copies");
  await page.locator("#view-numbers").click();
  await tried(page, 3);
  await app.poll(() => table(page), ({ rows }) => rows.some(({ name }) => name === "Boustrophedon (parallel lanes), vertical"));
  assert.match(await app.text("#charts"), /Boustrophedon \(parallel lanes\), horizontal/);
});

test("numbers on paper have every column, say where they are from, and have nothing to press", async (t) => {
  const { page, app, screenshot } = await openCompare(t, { room: "room=bedroom", view: "numbers", viewport: { width: 794, height: 1123 } });
  await tried(page, 4);
  await app.poll(() => app.text("#table-note"), (text) => /needs at least .* each row's excess is relative to the bound for that row's own coverage, which is measured more finely here than in the Coverage column and is usually a little lower\./.test(text));
  await page.mouse.move(100, 100);
  await page.locator("#printed").waitFor({ state: "attached" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  t.after(() => page.emulateMedia({ media: null }));
  await screenshot("numbers-print");
  const { ends, width } = await page.evaluate(() => ({
    ends: [...document.querySelectorAll("#compared thead th")].map((head) => Math.round(head.getBoundingClientRect().right)),
    width: document.documentElement.clientWidth,
  }));
  assert.ok(ends.length > 15 && ends.every((end) => end <= width), `${ends} of ${width}`);
  const shown = await page.locator("#panel-compare").innerText();
  assert.match(shown, /Bedroom, 4\.0 × 4\.0 m, Roomba 600 .*cells of 12 cm/);
  assert.doesNotMatch(shown, /\b(CSV|JSON|Many runs|Results for)\b/);
  assert.match(shown, /https?:\/\/\S+tab=compare/);
  await page.evaluate(() => document.getElementById("view-race")?.click());
  await app.poll(() => page.locator("#compare-place").innerText(), (text) => /The race after \d+:\d\d\.$/.test(text));
  // A dark page prints light floors, drawn before there is another frame.
  const brightness = (event) =>
    page.evaluate((type) => {
      if (type) dispatchEvent(new Event(type));
      const canvas = document.querySelector("#lanes canvas");
      const { width, height } = canvas;
      const copy = new OffscreenCanvas(width, height).getContext("2d");
      copy.drawImage(canvas, 0, 0);
      return copy.getImageData(0, 0, width, height).data.filter((_, index) => index % 4 === 0).reduce((sum, red) => sum + red, 0) / (width * height);
    }, event);
  const light = await brightness("afterprint");
  await page.emulateMedia({ media: null, colorScheme: "dark" });
  const dark = await app.poll(() => brightness(), (shown) => shown < light - 15);
  const printed = await brightness("beforeprint");
  assert.ok(printed > dark + 15, `${light}, ${dark}, ${printed}`);
});

test("a room of one's own is compared in", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty", viewport: { width: 1366, height: 768 } });
  await page.locator("#tab-compare").click();
  await page.locator("#view-numbers").click();
  await tried(page, 4);
  const isFilled = ({ rows }) => rows.length === 4 && rows.every(({ cells }) => cells.every((cell) => cell !== "–"));
  const open = await app.poll(() => table(page), isFilled);
  await page.locator("#tab-explore").click();
  await app.tool("wall");
  await app.drag([0.5, 0.1], [0.5, 0.6]);
  await page.locator("#tab-compare").click();
  await app.poll(() => table(page), ({ rows }) => rows.some(({ cells }, row) => cells[0] !== "–" && cells.join() !== open.rows[row]?.cells.join()));
  await tried(page, 4);
  const drawn = await app.poll(() => table(page), isFilled);
  const [before, now] = [open, drawn].map((shown) => column(shown, "Distance"));
  assert.ok(now.every((length, row) => length < before[row]), `${now} m, before ${before} m: the wall stands on floor`);
  await page.locator("#view-race").click();
  await lanes(page, 4);
  await app.poll(() => pictures(page, "#lanes canvas"), (shown) => shown.every(({ colours }) => colours > 5));
});

test("a robot that doesn't fit is said to be too wide", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty&robot=create2&planner=snake" });
  // Rows of pillars that no vacuum gets between.
  const { textMap, pillars } = await import("./maps.mjs");
  await app.pick(textMap("pillars.txt", pillars(40, { every: 4, pillar: 2 }), { resolution: 0.1 }));
  await app.says(/fits nowhere|doesn't fit/);
  await page.locator("#tab-compare").click();
  await page.locator("#panel-compare").waitFor();
  await page.waitForFunction(() => document.getElementById("trying").textContent.includes("4 failed"), undefined, { timeout: 60_000 });
  assert.match(await app.text("#race-hint"), /robot, 0\.\d\d m wide.*fit/);
  await page.locator("#view-numbers").click();
  const tip = await page.locator("#compared .failure").first().getAttribute("data-tip");
  assert.match(tip, /robot, 0\.\d\d m wide.*fit/);
  assert.equal(await page.locator("#compared td", { hasText: /\d/ }).count(), 0, "no numbers without plans");
});

test("the comparison fits a phone, light and dark", async (t) => {
  const nine = "boustrophedon,boustrophedon_cells,spiral_stc,backtracking_spiral,contour,wavefront_distance,wavefront_path,s_shape,spiral";
  const { page, app, screenshot } = await openCompare(t, { ...PHONE, link: `vs=${nine}` });
  await lanes(page, 9);
  const fits = async (what) => {
    for (const colorScheme of ["dark", "light"]) {
      await page.emulateMedia({ colorScheme });
      const [wide, inside] = await page.evaluate(() => [document.scrollingElement.scrollWidth, innerWidth]);
      assert.ok(wide <= inside, `${what}, ${colorScheme}: ${wide} of ${inside} pixels`);
      await screenshot(`phone-${what}-${colorScheme}`);
    }
  };
  await fits("race");
  // Nothing of a lane is cut off: its picture, and how far it is.
  const cut = await page.locator("#lanes figure").evaluateAll((figures) =>
    figures.filter((figure) => [...figure.querySelectorAll("canvas, output")].some((part) => part.getBoundingClientRect().right > figure.getBoundingClientRect().right + 1)).length,
  );
  assert.equal(cut, 0, "lanes that are cut off");
  assert.equal(await page.locator("#compare-setup > summary").evaluate((node) => getComputedStyle(node).display), "list-item", "a triangle says that it opens");
  await page.locator("#compare-setup > summary").tap();
  await fits("choices");
  await page.locator("#in-spiral").tap();
  await page.locator("#compare-setup > summary").tap();
  await lanes(page, 8);
  await page.getByRole("button", { name: "Start the race" }).tap();
  await app.poll(() => clocks(page), ({ clock }) => clock > 0);
  await page.locator("#view-numbers").tap();
  await tried(page, 8);
  await fits("numbers");
  // One sees that there is more to the right, until there isn't.
  const scroller = page.getByRole("region", { name: "Table of all numbers" });
  const cue = () => scroller.evaluate((node) => [node.dataset.more, getComputedStyle(node).maskImage !== "none"]);
  await app.poll(cue, ([more, fades]) => more === "true" && fades);
  await scroller.evaluate((node) => node.scrollTo(node.scrollWidth, 0));
  await app.poll(cue, ([more, fades]) => more === "false" && !fades);
  assert.match(await app.text("#table-note"), /In the race robots take longer/);
});
