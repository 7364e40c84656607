// Many runs in Compare: chosen, made in workers, shown as chart and table, saved, linked.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { App, seconds } from "./app.mjs";
import { openPage } from "./harness.mjs";

const SMALL = "runs=bounce&paths=boustrophedon&times=3&minutes=2";
const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };

/** Opens many runs by their link. */
async function openRuns(t, { link = SMALL, room = "room=empty&slip=typical", ...options } = {}) {
  const opened = await openPage(t, { address: `#${room}&tab=compare&view=runs&${link}`, ...options });
  const app = new App(opened.page);
  await opened.page.locator("body[data-tab=compare][data-boot=ready]").waitFor();
  return { ...opened, app };
}

/** Runs all that is missing. */
async function run(page, count) {
  await page.locator("#runs-go").click();
  await page.waitForFunction((n) => document.getElementById("runs-far").textContent === `${n} runs done`, count, { timeout: 240_000 });
}

/** Names and cells of the table without what is small. */
const table = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("#runs-table tbody tr")].map((tr) => ({
      name: tr.querySelector("th").childNodes[1].textContent,
      cells: [...tr.querySelectorAll("td")].map((td) => td.firstChild.textContent),
    })),
  );

/** The file saved by a click on an export button. */
async function saved(page, kind) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-export=${kind}]`).click()]);
  assert.match(download.suggestedFilename(), new RegExp(`^runs-.*\\.${kind}$`));
  return fs.readFileSync(await download.path());
}

test("runs are made when one asks, and chart, table and files tell the same of them", async (t) => {
  const { page, app } = await openRuns(t);
  assert.match(await app.text("#runs-plan"), /^2 algorithms, 3 runs of 2 minutes each/);
  assert.ok(await page.locator("#runs-chart").isHidden());
  await run(page, 6);
  const rows = await table(page);
  assert.deepEqual(rows.map(({ name }) => name).sort(), ["Boustrophedon (parallel lanes)", "Bounce"].sort());
  assert.ok(rows.every(({ cells }) => cells[0] === "> 2:00" && cells[1] === "0 %"), JSON.stringify(rows));
  assert.equal(await page.locator("#runs-plot .curve").count(), 2);
  assert.equal(await page.locator("#runs-plot .band").count(), 2);

  // Best first, worst first, as before; the link knows it.
  const coverages = async () => (await table(page)).map(({ cells }) => Number(cells[4]));
  const [least, most] = (await coverages()).sort((a, b) => a - b);
  const head = page.locator("#runs-table th", { hasText: "Coverage" });
  for (const [order, sort] of [[[most, least], "descending"], [[least, most], "ascending"]]) {
    await head.getByRole("button").press("Enter");
    assert.deepEqual(await coverages(), order);
    assert.equal(await head.getAttribute("aria-sort"), sort);
  }
  await app.linked("sort", (sort) => sort === "coverage-");
  await head.getByRole("button").press("Enter");
  assert.equal(await head.getAttribute("aria-sort"), "none");

  const json = JSON.parse((await saved(page, "json")).toString());
  const csv = (await saved(page, "csv")).toString().trimEnd().split("\n");
  assert.equal(csv.length, 7);
  for (const { algorithm, coverage, each } of json.algorithms) {
    assert.equal(each.length, 3);
    assert.equal(new Set(each.map(({ digest }) => digest)).size, 3, `seeds make a difference for ${algorithm}`);
    const shown = (Math.floor(1000 * coverage.median + 1e-6) / 10).toFixed(1);
    assert.ok(rows.some(({ cells }) => cells[4] === shown), `${shown} of ${algorithm} in ${JSON.stringify(rows)}`);
  }
  assert.match((await saved(page, "svg")).toString(), /^<svg [^]*class="curve"[^]*<\/svg>$/);
  assert.equal((await saved(page, "png")).subarray(1, 4).toString(), "PNG");
});

test("keyboard reads off the chart moment by moment", async (t) => {
  const { page } = await openRuns(t);
  await run(page, 6);
  const plot = page.locator("#runs-plot");
  const words = () => plot.getAttribute("aria-valuetext");
  await plot.focus();
  await page.keyboard.press("End");
  const end = await words();
  assert.match(end, /^2:00: .*Bounce \d+\.\d %, from \d+ to \d+/);
  assert.ok(await page.locator(".readout").isVisible());
  await page.keyboard.press("PageDown");
  await page.keyboard.press("ArrowLeft");
  assert.equal(seconds((await words()).split(": ")[0]), 107, "21 of 200 samples before the end of 120 s");
  await page.keyboard.press("Home");
  assert.match(await words(), /^0:00: /);
  await page.keyboard.press("Escape");
  assert.ok(await page.locator(".readout").isHidden());
});

test("runs can be cancelled and gone on with, and what was made stays", async (t) => {
  const { page, app } = await openRuns(t, { room: "room=flat&noise=typical", link: "runs=bounce&paths=&times=100&minutes=60" });
  await page.locator("#runs-go").click();
  await page.waitForFunction(() => /^([1-9]|\d\d) of 100 runs/.test(document.getElementById("runs-far").textContent), null, { timeout: 120_000 });
  await page.getByRole("button", { name: "Cancel" }).click();
  await page.getByRole("button", { name: "Resume" }).waitFor();
  const made = await app.text("#runs-far");
  assert.match(made, /^\d+ of 100 runs done$/);
  await app.frames(20);
  assert.equal(await app.text("#runs-far"), made, "nobody goes on in secret");
  assert.ok(await page.locator("#runs-chart").isVisible());
  await page.locator("#runs-seeds").selectOption("10");
  await page.locator("#runs-minutes").selectOption("10");
  await run(page, 10);
});

test("the link brings back who is run how often, and bad ones are refused", async (t) => {
  const { page, app } = await openRuns(t, { link: "runs=bounce,spiral_out&paths=snake~patience:3&times=42&minutes=10" });
  assert.equal(await page.locator("#runs-seeds").inputValue(), "42");
  assert.ok(await page.locator("#run-behaviour-spiral_out").isChecked());
  assert.ok(!(await page.locator("#run-planner-spiral").isChecked()), "the planner of that name isn't meant");
  await page.locator("#run-behaviour-spiral_out").uncheck();
  assert.equal(await app.linked("runs", (runs) => runs === "bounce"), "bounce");
  assert.equal(await app.linked("paths"), "snake~patience:3");
  await page.evaluate(() => (location.hash = "#room=empty&tab=compare&view=runs&runs=snail"));
  await page.getByText('there is no behaviour "snail"').waitFor();
});

test("figure 18 of the paper is one click away", async (t) => {
  const { page, app } = await openRuns(t);
  await page.locator("#runs-figure").click();
  await page.getByRole("button", { name: "Cancel" }).click();
  assert.match(await app.text("#compare-robot"), /DVR-1/);
  assert.equal(await page.locator("#runs-behaviours input[id]:checked").count(), 5);
  assert.equal(await page.locator("#runs-seeds").inputValue(), "100");
});

test("many runs fit onto a phone", async (t) => {
  const { page } = await openRuns(t, PHONE);
  await run(page, 6);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing sticks out");
  const box = await page.locator("#runs-plot svg").boundingBox();
  assert.ok(box.width > 300 && box.x + box.width <= 390, JSON.stringify(box));
});
