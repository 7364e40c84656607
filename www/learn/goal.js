// @ts-check
// A task: its start, what the present run has of it, and the check by many runs.
import { make, setText } from "../dom.js";
import { clock, percent } from "../format.js";
import { textOf } from "../messages.js";
import { workshop } from "../workers.js";
import { press } from "./blocks.js";
import { joined, makeRuns } from "./runs.js";
import { applyLink, applyScenario } from "./scene.js";

/** @param {import("./blocks.js").Context} context @param {Extract<import("../types").LessonBlock, { kind: "goal" }>} goal */
export function goal(context, goal) {
  const { app, text, lesson, done, changed, signal, ticks } = context;
  const box = make("section", { className: "part goal", "aria-label": "Goal" }, make("h4", {}, "Goal"));
  if (goal.title) box.append(make("p", {}, goal.title));
  const list = make("ul", { className: "needs" }, ...goal.needs.map((need) => make("li", {}, words(need, goal))));
  const allowed = make("p", { className: "note" }, `You may change: ${goal.changes.map((name) => WORDS[name] ?? name).join(", ")}. ${count(goal.runs)} of ${goal.minutes} min, seeds ${goal.first_seed} to ${goal.first_seed + goal.runs - 1}.`);
  const live = make("p", { className: "note live" });
  const outcome = make("div", { className: "outcome", role: "status" });
  const bar = make("progress", { max: 1, value: 0, hidden: true, "aria-label": "Runs" });

  const scene = lesson.blocks.find((block) => block.kind === "scene" && block.id === goal.scene && block.scenario);
  const scenario = scene?.kind === "scene" ? scene.scenario : undefined;
  const byProgram = goal.changes.includes("program");
  const onlyProgram = byProgram && goal.changes.length === 1;
  const begin = press("Set up the task", async () => {
    if (scenario) await applyScenario(app, scenario);
    await applyLink(app, goal.start, false);
    if (onlyProgram) document.getElementById("tab-program")?.click();
  });
  /** @type {AbortController | undefined} */
  let running;
  const name = onlyProgram ? "Check my program" : byProgram ? "Check my entry" : "Check my settings";
  const check = press(name, () => (running ? running.abort() : void test()), "primary");

  async function test() {
    const link = app.playground.link();
    const ignored = text.ignored(goal.id, link);
    const program = byProgram && app.playground.link_outline(link).has_program ? app.playground.program() : undefined;
    if (onlyProgram && !program) {
      outcome.textContent = "No program drives the robot yet. Open one in Program, press Run, and check again.";
      return;
    }
    if (program && app.isUnrun) {
      outcome.textContent = "The program was changed since it last ran. Press Run in the tab Program, and check again.";
      return;
    }
    running = new AbortController();
    const ends = AbortSignal.any([signal, running.signal]);
    const pieces = Math.min(goal.runs, 2 * (navigator.hardwareConcurrency || 2));
    const requests = Array.from({ length: pieces }, (_, index) => text.request(goal.id, link, index, pieces));
    /** @type {Float64Array[]} */
    const parts = Array(pieces);
    let made = 0;
    check.textContent = "Cancel";
    bar.hidden = false;
    bar.value = 0;
    outcome.textContent = "";
    try {
      const driven = program && { program, ...(await place(text.place(goal.id, link))) };
      await makeRuns(requests, (index, outcomes) => {
        parts[index] = outcomes;
        bar.value = ++made / pieces;
      }, ends, driven);
      const verdict = text.judge(goal.id, joined(parts));
      done.goals[goal.id] = { link, ...(program && { program }), passed: verdict.passed, runs: verdict.runs };
      changed();
      show(verdict, ignored);
    } catch (error) {
      if (ends.aborted) return;
      outcome.textContent = `The runs could not be made: ${textOf(error)}.`;
      // It is handed in all the same, to be run by who marks it.
      if (program && !done.goals[goal.id]?.passed) done.goals[goal.id] = { link, program, passed: false, runs: [] };
      changed();
    } finally {
      running = undefined;
      check.textContent = name;
      bar.hidden = true;
    }
  }

  /** What a program needs to drive where the task has it. @param {string} link */
  async function place(link) {
    const [{ default: init, job_of_place }, module] = await Promise.all([import("../../workshop.js"), workshop()]);
    await init({ module_or_path: module });
    return { job: job_of_place(link, scenario) };
  }

  /** @param {import("../types").Verdict} verdict @param {string[]} ignored */
  function show(verdict, ignored) {
    const rows = verdict.needs.map(({ text, value, unit, passed }) => make("li", { className: passed ? "right" : "wrong" }, `${signed(text)}: ${value === null ? "not reached" : `${value.toFixed(1)} ${unit}`.trim()}${passed ? "" : ", missed"}`));
    outcome.replaceChildren(make("b", {}, verdict.passed ? "Goal reached." : "Not yet."), make("ul", {}, ...rows));
    if (ignored.length > 0) outcome.append(make("p", {}, `You can't change these here, so the task's own settings were checked: ${ignored.join(", ")}.`));
  }

  const before = done.goals[goal.id];
  if (before) outcome.append(make("b", {}, before.passed ? "Goal reached." : "Not yet."));
  // What the run on the floor has so far; the check makes its own runs.
  ticks.push(() => {
    const { coverage, time_s, distance_m, bumps } = app.view;
    const isOver = time_s > 60 * goal.minutes;
    const isThere = time_s > 0 && !text.ignored(goal.id, app.playground.link()).includes("room");
    setText(live, isThere ? `The run on the floor: ${percent(coverage)} % after ${clock(time_s)}${isOver ? ` (the goal's ${goal.minutes} min are over)` : ""}, ${distance_m.toFixed(0)} m, bumps: ${bumps}` : "");
  });
  box.append(list, allowed, make("p", { className: "act" }, begin, check), bar, live, outcome);
  return box;
}

/** What may be changed, by its name on the page. @type {Record<string, string>} */
const WORDS = { algorithm: "Algorithm with its parameters", program: "the program", params: "the algorithm's parameters", cell: "Planning cell", robot: "Robot", start: "the start point", odometry: "Odometry", "plan seed": "Seed", charge: "Start charge" };

/** @param {number} runs */
const count = (runs) => (runs === 1 ? "One run" : `${runs} runs`);

/** @param {import("../types").Need} need @param {import("../types").Goal} goal */
const words = ({ text }, { minutes }) => `${signed(text)} within ${minutes} min`;

/** @param {string} text */
const signed = (text) => text.replace(">=", "≥").replace("<=", "≤");

/** Columns of what is counted. */
const COUNTS = /^(bumps|falls)/;

/** A table that fills itself. @param {import("./blocks.js").Context} context @param {Extract<import("../types").LessonBlock, { kind: "measure" }>} table @param {number} at Index of the block. */
export function measure({ text, signal, app }, table, at) {
  const cells = table.rows.map(() => table.columns.map(() => make("td", {}, "–")));
  const body = make("tbody", {}, ...table.rows.map(({ title, link }, row) => make("tr", {}, make("th", { scope: "row" }, press(title, () => applyLink(app, link, true), "link")), .../** @type {HTMLElement[]} */ (cells[row]))));
  const head = make("tr", {}, make("td"), ...table.columns.map((column) => make("th", { scope: "col" }, column)));
  const told = make("p", { className: "note", role: "status" }, `${table.runs === 1 ? "One run" : `Medians of ${table.runs} runs`} of ${table.minutes} min.`, make("span", { className: "on-screen" }, " Press a name to see a run."));
  const go = press("Measure", async () => {
    go.disabled = true;
    try {
      const requests = table.rows.map((_, row) => /** @type {{ id: number }} */ (text.measure(at, row)));
      await makeRuns(requests, (row, outcomes) => {
        text.cells(at, outcomes).forEach((value, column) => {
          const cell = cells[row]?.[column];
          if (cell) cell.textContent = value === null ? "not reached" : value.toFixed(Number.isInteger(value) && COUNTS.test(table.columns[column] ?? "") ? 0 : 1);
        });
      }, signal);
    } catch (error) {
      if (!signal.aborted) told.textContent = `The runs could not be made: ${error instanceof Error ? error.message : String(error)}.`;
    }
    go.disabled = false;
  });
  const title = table.title ? [make("caption", {}, table.title)] : [];
  return make("div", { className: "part measure" }, make("div", { className: "scroll" }, make("table", {}, ...title, make("thead", {}, head), body)), make("p", { className: "act" }, go), told);
}

