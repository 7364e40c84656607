// @ts-check
// The race: a canvas for every robot, one clock for all.
import { byId, changed, make, setAttribute, setHidden, setText } from "../dom.js";
import { nameOf, swatch } from "./entrants.js";
import { clock, metres, percent } from "../format.js";
import { sentence, textOf } from "../messages.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { fitSize } from "../shared/pan-zoom.js";
import { startRange } from "../shared/range.js";
import { startTransport, through } from "../shared/time-line.js";

/**
 * @typedef {import("./tab.js").Comparing} Comparing
 * @typedef {import("../types").ComparisonView} CompareView
 * @typedef {import("../types").RaceView} RaceView
 */

/** Milliseconds between redraws of the curves. */
const REDRAW = 250;

/** Definitions of a robot's figures, and why they differ from those of the table. */
const DRIVEN = "Swept share of the reachable floor, and the time when the robot is done. In the race the robot tracks its path and corrects itself at corners. So it takes a few percent longer than planned (see Numbers), and longer still if pets or people are in its way.";
const RANK = "Place: first those that have swept 95 % and are done, by time; then the others by coverage. A behaviour that never stops counts when it has swept 95 %.";

/** @param {Comparing} it */
export function startRace(it) {
  const { app, act } = it;
  const isRunning = () => isMoving(it.view.race);
  const transport = startTransport("race-", app.catalogue.speeds, {
    toggle: () => act((c) => (isRunning() ? c.pause() : c.play())),
    step: () => act((c) => c.step()),
    reset: () => act((c) => c.seek(0)),
    speed: (text) => act((c) => c.set_speed(Number(text))),
  });
  const showRange = startRange("race-scrub", (seconds) => act((c) => c.seek(seconds)));
  const isDue = atMostEvery(REDRAW);

  /** @param {CompareView} view */
  const update = (view) => {
    const { race } = view;
    setHidden(byId("race-hint"), Boolean(race && race.lanes.length > 0));
    setText(byId("race-hint"), hint(it));
    const who = race ? race.lanes.map(({ entrant }) => `${entrant} ${view.entrants[entrant]?.title}`).join() : "";
    if (changed(byId("lanes"), "who", who)) buildLanes(it, race);
    const bench = [view.leaves, ...view.waiting].map((entrant) => (entrant === null ? "" : `${entrant} ${view.entrants[entrant]?.title}`)).join();
    if (changed(byId("bench"), "who", bench)) showBench(it);
    if (race) updateLanes(it, race);
    const pane = byId("lanes").querySelector("canvas");
    if (pane) fitSize(pane, it.comparison);
    const can = Boolean(race);
    transport.update({ play: can, step: can, reset: can }, isRunning(), race?.speed, "Start the race");
    if (!race) return;
    setText(byId("race-time"), clock(race.time_s));
    showRange(rangeOf(race), race.state === "seeking" ? undefined : race.time_s);
    if (!isRunning()) setAttribute(byId("race-scrub"), "aria-valuetext", clock(race.time_s));
    // A late entrant catches up while the end stays.
    const extent = [who, race.end_s, race.planned_s, ...race.lanes.map(({ time_s }) => Math.floor(time_s))].join(" ");
    if (isDue(() => changed(byId("race-curves"), "extent", extent))) drawCurves(it, race);
  };
  return { update, key: transport.key };
}

/** The end of a race; "" while it goes on. @param {CompareView} view */
export function winner({ entrants, race }) {
  const first = race?.state === "finished" && race.lanes.find(({ place }) => place === 1);
  if (!race || !first) return "";
  const rest = race.lanes.every(({ finished }) => finished) ? "" : ` Behaviours that don't stop were stopped at ${clock(race.time_s)}.`;
  return `The race is over. First: ${entrants[first.entrant]?.title}, ${percent(first.coverage)} % in ${clock(first.won_s ?? first.time_s)}.${rest}`;
}

/** @param {Comparing} it */
function hint({ view: { entrants, done, total, cancelled } }) {
  if (!entrants.some(({ chosen }) => chosen)) return "Choose at least two algorithms.";
  if (done < total && !cancelled) return "Planning. Each robot lines up when its plan is ready.";
  const failure = entrants.find(({ state }) => state === "failed")?.message;
  return failure ? `No plan can be made here: ${failure}` : "None of these algorithms has a plan for this room yet.";
}

/** @param {Comparing} it @param {RaceView | null} race */
function buildLanes({ act, view, comparison, about }, race) {
  const panes = (race?.lanes ?? []).map(({ entrant }) => {
    const { title = "", mark } = view.entrants[entrant] ?? {};
    const name = make("button", { type: "button", className: "link name", title, onclick: () => about(entrant) }, ...nameOf(view.entrants[entrant]));
    const out = make("button", { type: "button", className: "quiet square small", "aria-label": `Take ${title} out of the race`, title: "Take out of the race", onclick: () => act((c) => c.set_racing(entrant, false)) });
    out.innerHTML = '<svg class="icon" aria-hidden="true"><use href="#i-close" /></svg>';
    const rank = make("span", { className: "rank", "data-tip": RANK });
    return make("figure", {}, make("figcaption", {}, rank, swatch(mark), name, make("output", { "data-tip": DRIVEN }), out), make("canvas", { role: "img" }), make("p", { className: "fault", role: "alert", hidden: true }));
  });
  byId("lanes").replaceChildren(...panes);
  byId("lanes").dataset.count = String(panes.length);
  comparison.set_panes(panes.map((pane) => /** @type {HTMLCanvasElement} */ (pane.querySelector("canvas"))));
}

/** Those that could race, but don't. @param {Comparing} it */
function showBench({ act, view }) {
  const leaves = view.leaves === null ? "" : view.entrants[view.leaves]?.title;
  const names = view.waiting.map((entrant) => {
    const { title = "", mark } = view.entrants[entrant] ?? {};
    return make("button", { type: "button", onclick: () => act((c) => c.set_racing(entrant, true)) }, swatch(mark), title);
  });
  const tip = "At most nine robots race. A tenth takes the place of the last one.";
  const what = leaves ? `Join the race in place of ${leaves}:` : "Join the race:";
  byId("bench").replaceChildren(...(names.length > 0 ? [make("span", { className: "note", "data-tip": tip }, what), ...names] : []));
}

/** @param {Comparing} it @param {RaceView} race */
function updateLanes({ view }, race) {
  race.lanes.forEach((lane, index) => {
    const pane = byId("lanes").children[index];
    const output = pane?.querySelector("output");
    const canvas = pane?.querySelector("canvas");
    if (!output || !canvas) return;
    const [rank, isDone] = [pane?.querySelector(".rank"), lane.finished || lane.won_s !== null];
    if (rank) setText(rank, race.time_s > 0 ? `#${lane.place}` : "");
    // It stops where its program failed.
    const failure = view.entrants[lane.entrant]?.id === "program" && lane.won_s === null ? race.failure : "";
    const fault = /** @type {HTMLElement} */ (pane?.querySelector(".fault"));
    setHidden(fault, failure === "");
    setText(fault, failure);
    const isLate = !isDone && lane.time_s < 0.9 * race.time_s - 1;
    setText(output, `${isLate ? `catching up, at ${clock(lane.time_s)}: ` : ""}${percent(lane.coverage)} %${isDone ? ` ${failure ? "until" : "in"} ${clock(lane.won_s ?? lane.time_s)}` : race.state === "finished" ? " at the end" : ""}`);
    setAttribute(pane, "data-leads", String(lane.place === 1 && race.time_s > 0));
    // While it drives, the picture is put into words now and then; while it stands, the words fit it.
    const far = isMoving(race) ? Math.floor(lane.coverage * 10) : lane.time_s;
    if (changed(canvas, "said", `${race.state} ${far} ${lane.finished}`)) {
      const title = view.entrants[lane.entrant]?.title;
      canvas.setAttribute("aria-label", `${title}: ${percent(lane.coverage)} % of the reachable floor is clean after ${clock(lane.time_s)} and ${metres(lane.distance_m)} m${lane.finished ? ", done" : ""}; place ${lane.place}.`);
    }
  });
}

/** @param {RaceView | null} race */
const isMoving = (race) => ["playing", "seeking"].includes(race?.state ?? "");

/** Range of the time line, s. @param {RaceView} race */
const rangeOf = (race) => Math.max(race.planned_s, race.end_s, 1);

/** Times on the axis, s: at most seven, at round minutes. @param {number} range */
function ticksOf(range) {
  const step = [10, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400].find((seconds) => range / seconds <= 7) ?? 86_400;
  return Array.from({ length: Math.floor(range / step) + 1 }, (_, i) => i * step);
}

/** Coverage over time of every robot. @param {Comparing} it @param {RaceView} race */
function drawCurves({ view, comparison }, race) {
  const range = rangeOf(race);
  const lines = race.lanes.map(({ entrant }, index) => {
    const curve = comparison.coverage_curve(index);
    const points = Array.from({ length: curve.length / 2 }, (_, i) => /** @type {[number, number]} */ ([(1000 * (curve[2 * i] ?? 0)) / range, 99.5 - 99 * (curve[2 * i + 1] ?? 0)]));
    const mark = view.entrants[entrant]?.mark;
    return `<path d="${through([[0, 99.5], ...points])}" data-colour="${mark?.colour}" data-shape="${mark?.shape}"/>`;
  });
  byId("race-ticks").replaceChildren(...ticksOf(range).map((seconds) => {
    const tick = make("span", {}, clock(seconds));
    tick.style.setProperty("--at", String(seconds / range));
    return tick;
  }));
  byId("race-curves").innerHTML = `<path class="grid-line" d="M0 .5H1000M0 50H1000M0 99.5H1000"/>${lines.join("")}`;
}

/** The user's program drives its race in the sandbox. @param {import("../main.js").App} app @param {import("../../workshop.js").Comparison} comparison */
export function raceProgram(app, comparison) {
  const job = comparison.take_race_job();
  const program = job && app.playground.program();
  if (!job || !program) return;
  const { version } = JSON.parse(new TextDecoder().decode(job));
  let isWanted = true;
  const seconds = 1.5 * (comparison.view().race?.planned_s ?? 0) + 60;
  void import("../program/work.js")
    .then(({ work }) => work({ program, job, seconds, onPart: (part) => void (isWanted = comparison.extend_race(version, part)) }, { isWanted: () => isWanted }))
    .catch((error) => isWanted && comparison.race_failed(version, sentence(`${textOf(error)}.`)));
}
