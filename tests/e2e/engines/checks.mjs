// What must work in every browser: each tab does its main thing. Details are tested in Chromium.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { ROOT } from "../browser.mjs";
import { robovac } from "../serial/robot.mjs";
import { programmed, reproduced, shown } from "./numbers.mjs";

/** Waits for one of these states of the tab Explore. */
const state = (page, ...states) => page.until((wanted) => wanted.includes(document.body.dataset.state ?? ""), states);
const text = (page, id) => page.evaluate((name) => document.getElementById(name).textContent, id);
const number = async (page, id) => Number((await text(page, id)).replace(/[^\d.]/g, ""));
/** Waits until an element's text, as a number, is larger than this. */
const grows = (page, id, than) =>
  page.until((name, least) => {
    const value = Number(document.getElementById(name).textContent.replace(/[^\d.]/g, ""));
    return value > least && value;
  }, id, than);
/** What a function promises as a script of the page's own: Firefox's arrays of bytes are others in scripts of tests. */
const ofPage = (page, what) =>
  page.evaluate((text) => document.head.append(Object.assign(document.createElement("script"), { type: "module", textContent: text })), `document.body.dataset.promised = await (${what})().catch(String);`)
    .then(() => page.until(() => document.body.dataset.promised));
const seen = (page, selector) => page.until((which) => document.querySelector(which)?.checkVisibility(), selector);
const frames = (page, count) => page.evaluate((left) => new Promise((done) => {
  const next = () => (left-- > 0 ? requestAnimationFrame(next) : done());
  next();
}), count);

/** Waits until there is a picture on each canvas, also on those that a worker paints: more than a few colours. */
const painted = (page, selector) =>
  page.until((which) => [...document.querySelectorAll(which)].every((canvas) => {
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
    copy.drawImage(canvas, 0, 0);
    return new Set(new Uint32Array(copy.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size > 10;
  }), selector);

/** Waits until the plan's cell in a row of Explore's numbers fits, and is none of `others`; returns its text. */
const planned = (page, name, pattern, ...others) =>
  page.until((start, source, old) => {
    const row = [...document.querySelectorAll("#metrics tr")].find(({ cells: [first] }) => first.textContent.startsWith(start));
    const text = row?.cells[1].textContent ?? "";
    return new RegExp(source).test(text) && !old.includes(text) && text;
  }, name, pattern.source, others);

/** Waits until the floor plan is at rest; its free floor, m². */
const floor = (page) => page.until(() => document.getElementById("panel-floor-plan").ariaBusy !== "true" && Number(/([\d.]+) m² of floor/.exec(document.getElementById("floor-plan-result").textContent)?.[1]));

/** Waits until it stands still. */
async function rests(page) {
  let before;
  do {
    before = await number(page, "connection-distance");
    await frames(page, 20);
  } while (before !== (await number(page, "connection-distance")));
}

/**
 * By name.
 * @typedef {object} Given What a check gets.
 * @property {import("./engine.mjs").Engine} page The browser's only window.
 * @property {string} url The page's address.
 * @property {(address: string, what: Function) => Promise<any>} inChromium Calls a function in the page in Chromium.
 * @property {string} folder For files.
 * @property {import("node:test").TestContext} t
 * @type {Record<string, (given: Given) => Promise<void>>}
 */
export const CHECKS = {
  "opens on a robot that is already cleaning": async ({ page, url }) => {
    await page.open(url);
    await state(page, "playing");
    const [coverage, distance] = [await grows(page, "n-coverage", 0), await grows(page, "n-distance", 0)];
    await grows(page, "n-distance", distance);
    await grows(page, "n-coverage", coverage);
    assert.equal(await page.evaluate(() => document.getElementById("message").hidden), true);
    await painted(page, "#floor");
    const line = await page.evaluate(() => getComputedStyle(document.querySelector(".term")).getPropertyValue("text-decoration-style"));
    assert.equal(line, "dotted", "that a word has a definition can be seen");
  },

  "Program: a program in Python drives from its sandbox, as in Chromium and on the command line, to the last bit": async ({ page, url, inChromium }) => {
    await page.open(`${url}#room=empty&tab=program`);
    await page.until(() => document.getElementById("program-status")?.textContent.startsWith("Change a number"));
    await grows(page, "n-distance", 0.3);
    const digest = await ofPage(page, programmed);
    assert.match(digest, /^[\da-f]{16}$/);
    assert.equal(digest, await inChromium("#room=empty", programmed));
    const words = ["run", path.join(ROOT, "programs/examples/turn_when_you_bump.py"), "--room", "flat", "--seed", "42", "--slip", "typical", "--noise", "typical", "--minutes", "1", "--json"];
    assert.equal(digest, JSON.parse(execFileSync(robovac(), words, { encoding: "utf8" })).runs[0].digest);
  },

  "Explore: plans by menus, plays by keys; a wall is drawn and undone, and a reload keeps it": async ({ page, url }) => {
    await page.open(`${url}#room=thesis8&robot=cell&speed=1`);
    await state(page, "playing", "finished");
    await page.choose("#algorithm", "spiral_stc");
    await page.until(() => location.hash.includes("planner=spiral_stc"));
    await planned(page, "Above the minimum", /^[\d.]+ %/);
    await state(page, "playing", "finished");
    await page.evaluate(() => document.activeElement?.blur());
    await page.press("r");
    await state(page, "ready");
    await page.press(".");
    await state(page, "paused");
    await page.press("Space");
    await state(page, "playing", "finished");
    await page.press("?");
    await seen(page, "dialog[open]");
    await page.press("Escape");
    await page.until(() => !document.querySelector("dialog[open]"));
    await page.evaluate(() => document.getElementById("floor").focus());
    await page.press("Tab");
    assert.notEqual(await page.evaluate(() => document.activeElement.id), "floor", "Tab moves on");
    await page.evaluate(() => document.getElementById("floor").focus());

    const before = await planned(page, "Cells visited", /^\d/);
    await page.press("w");
    await seen(page, "#tools [data-tool=wall][aria-pressed=true]");
    await page.press("ArrowRight", "Enter");
    const after = await planned(page, "Cells visited", /^\d/, before);
    await page.press("Control+z");
    assert.equal(await planned(page, "Cells visited", /^\d/, after), before);
    await page.press("Control+Shift+z");
    assert.equal(await planned(page, "Cells visited", /^\d/, before), after);
    await page.until(() => location.hash.includes("room=own"));
    await page.reload();
    assert.equal(await planned(page, "Cells visited", /^\d/), after);
  },

  "a link gives the same run as in Chromium, to the last bit": async ({ page, url, inChromium }) => {
    const address = "#room=empty&robot=cell&planner=snake&seed=11&slip=typical&noise=typical&speed=0";
    await page.open(url + address);
    const here = [await page.evaluate(shown), await page.evaluate(reproduced)];
    assert.ok(here[0].length > 12 && here[1].points > 500, JSON.stringify(here));
    assert.deepEqual(here, await inChromium(address, `async () => [await (${shown})(), await (${reproduced})()]`));
  },

  "Compare: a race": async ({ page, url }) => {
    await page.open(`${url}#room=empty&tab=compare&view=race&vs=boustrophedon,spiral_stc`);
    await page.until(() => document.getElementById("trying")?.textContent.startsWith("2 plan") && document.querySelectorAll("#lanes figure").length === 2);
    await page.choose("#race-speed", "64");
    await page.click("#race-play");
    await page.until(() => /^(0:[3-5]|[1-9])/.test(document.getElementById("race-time").textContent));
    await page.press("Space");
    assert.equal(await page.evaluate(() => document.querySelectorAll("#lanes figure[data-leads=true]").length), 1);
    await painted(page, "#lanes canvas");
    await page.click("#view-numbers");
    await page.until(() => document.querySelectorAll("#compared tbody tr").length === 2);
  },

  "Map: it grows, and a reload resumes the run": async ({ page, url }) => {
    await page.open(`${url}#room=room12ft&robot=roomba600&seed=3&tab=map&explorer=bounce&pace=256`);
    await page.until(() => document.getElementById("panel-map")?.dataset.phase === "ready");
    await page.click("#map-play");
    const mapped = await grows(page, "map-n-boundary", 0);
    await grows(page, "map-n-boundary", mapped);
    await page.click("#map-play");
    await page.until(() => ["paused", "finished"].includes(document.getElementById("panel-map").dataset.phase));
    await painted(page, "#map-floor");
    const figures = () => page.evaluate(() => ["boundary", "time", "error"].map((name) => document.getElementById(`map-n-${name}`).textContent));
    const before = await figures();
    await page.reload();
    await page.until(() => ["paused", "finished"].includes(document.getElementById("panel-map")?.dataset.phase));
    assert.deepEqual(await figures(), before);
  },

  "Floor plan: the sample is traced and swept, a file is opened, and a reload keeps it": async ({ page, url, folder }) => {
    const file = path.join(folder, "my flat.dxf");
    fs.copyFileSync(path.join(ROOT, "www/floor-plan/sample.dxf"), file);
    await page.open(`${url}#room=empty&tab=floor-plan`);
    await seen(page, "#floor-plan-sample");
    await page.click("#floor-plan-sample");
    const whole = await floor(page);
    assert.ok(whole > 30 && whole < 60, `${whole} m²`);
    for (const stage of ["1", "2", "3"]) {
      await page.click(`[data-stage="${stage}"]`);
      await seen(page, `[data-stage="${stage}"][aria-pressed=true]`);
    }
    await grows(page, "floor-plan-n-subgoals", 20);
    assert.equal(await number(page, "floor-plan-n-resolved"), await number(page, "floor-plan-n-collisions"));
    await painted(page, "#floor-plan-floor");

    await page.pick("#files", file);
    await page.until(() => document.getElementById("floor-plan-name").textContent === "my flat");
    assert.equal(await floor(page), whole);
    await page.choose("[aria-label='What FURNITURE is']", "ignored");
    await page.until((before) => document.getElementById("panel-floor-plan").ariaBusy !== "true" && !document.getElementById("floor-plan-result").textContent.includes(`${before} m² of`), whole);
    const area = await floor(page);
    assert.ok(area > whole + 3, `${area} m² without furniture, ${whole} with`);
    await page.until(isKept);
    await page.reload();
    await page.until(() => document.getElementById("floor-plan-name")?.textContent === "my flat");
    assert.equal(await floor(page), area);
    await page.click("#floor-plan-use");
    await page.until(() => document.getElementById("room").selectedOptions[0]?.textContent === "my flat");
  },

  "Robot: the virtual one is connected, driven by an algorithm, and stopped": async ({ page, url }) => {
    await page.open(`${url}#room=empty&behaviour=bounce&robot=roomba600&tab=connection`);
    await seen(page, "#connection-virtual");
    await page.click("#connection-virtual");
    await seen(page, "#connection-modes .in[data-mode=Passive]");
    assert.equal(await number(page, "connection-distance"), 0);
    await page.click("#connection-arm");
    await seen(page, "#connection-modes .in[data-mode=Safe]");
    await seen(page, "#connection-go[aria-disabled=false]");
    await page.click("#connection-go");
    await grows(page, "connection-distance", 0.1);
    await page.press("Space");
    await rests(page);
    await painted(page, "#connection-floor");
  },
};

/** In the page: whether the drawing and the roles of its layers are stored, which is a moment after they were chosen. */
function isKept() {
  const roles = String([...document.querySelectorAll("#floor-plan-layers select")].map(({ value }) => value));
  return new Promise((resolve) => {
    const request = indexedDB.open("robovac-drafts");
    request.onsuccess = () => {
      const kept = request.result.transaction("board").objectStore("board").getAll();
      kept.onsuccess = () => {
        request.result.close();
        const [choices, files] = kept.result;
        resolve(String(choices?.settings.roles) === roles && files?.files[0].name === "my flat.dxf");
      };
    };
  });
}
