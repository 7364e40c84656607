// @ts-check
// The race: a canvas for every robot, one clock for all.
import { button, byId, changed, fill, make, select, setAttribute, setEnabled, setHidden, setText, typed } from "../dom.js";
import { swatch } from "./entrants.js";
import { clock, metres, percent } from "../format.js";

/**
 * @typedef {import("./tab.js").Comparing} Comparing
 * @typedef {import("../types").ComparisonView} CompareView
 * @typedef {import("../types").RaceView} RaceView
 */

/** Milliseconds between redraws of the curves. */
const REDRAW = 250;

/** What the figures of a robot mean, and why they differ from those of the table. */
const DRIVEN = "Rank, coverage, and time when it is done. In the race the robot tracks its path and corrects itself at corners, so it takes a few percent longer than planned (see Numbers).";

/** @param {Comparing} it */
export function startRace(it) {
  const { app, act } = it;
  fill(select("race-speed"), app.catalogue.speeds.map((x) => [String(x), x === 0 ? "max" : `${x}×`]));
  select("race-speed").addEventListener("change", () => act((c) => c.set_speed(Number(select("race-speed").value))));
  const isRunning = () => isMoving(it.view.race);
  const toggle = () => act((c) => (isRunning() ? c.pause() : c.play()));
  button("race-play").addEventListener("click", toggle);
  button("race-step").addEventListener("click", () => act((c) => c.step()));
  button("race-reset").addEventListener("click", () => act((c) => c.seek(0)));
  const scrub = typed("race-scrub", HTMLInputElement);
  let held = false;
  scrub.addEventListener("pointerdown", () => (held = true));
  for (const end of ["pointerup", "pointercancel", "blur"]) scrub.addEventListener(end, () => (held = false));
  scrub.addEventListener("input", () => act((c) => c.seek(Number(scrub.value))));
  /** @type {Record<string, () => boolean>} */
  const keys = { " ": toggle, ".": () => act((c) => c.step()), r: () => act((c) => c.seek(0)) };

  let size = "";
  let drawn = 0;
  /** @param {CompareView} view */
  const update = (view) => {
    const { race } = view;
    setHidden(byId("race-hint"), Boolean(race && race.lanes.length > 0));
    setText(byId("race-hint"), hint(it));
    const who = race ? race.lanes.map(({ entrant }) => entrant).join(" ") : "";
    if (changed(byId("lanes"), "who", who)) {
      buildLanes(it, race);
      size = "";
    }
    if (race) updateLanes(it, race);
    const pane = byId("lanes").querySelector("canvas");
    const now = pane ? `${pane.clientWidth} ${pane.clientHeight} ${devicePixelRatio}` : "";
    if (pane && now !== size && pane.clientWidth > 0) {
      size = now;
      it.comparison.resize(pane.clientWidth, pane.clientHeight, devicePixelRatio);
    }
    updateBar(race, isRunning(), held);
    const at = performance.now();
    if (race && at - drawn > REDRAW && changed(byId("race-curves"), "extent", `${who} ${race.end_s} ${race.planned_s}`)) {
      drawn = at;
      drawCurves(it, race);
    }
  };
  return { update, key: (/** @type {string} */ key) => keys[key]?.() ?? false };
}

/** @param {Comparing} it */
function hint({ view: { entrants, done, total, cancelled } }) {
  if (!entrants.some(({ chosen }) => chosen)) return "Choose at least two algorithms.";
  if (done < total && !cancelled) return "Planning. Robots line up as their plans are ready.";
  const failure = entrants.find(({ state }) => state === "failed")?.message;
  return failure ? `No plan can be made here: ${failure}` : "None of these algorithms has a plan for this room yet.";
}

/** @param {Comparing} it @param {RaceView | null} race */
function buildLanes({ app, comparison, about }, race) {
  const panes = (race?.lanes ?? []).map(({ entrant }) => {
    const planner = app.catalogue.planners[entrant];
    const name = make("button", { type: "button", className: "link", onclick: () => about(entrant) }, planner?.title ?? "");
    return make("figure", {}, make("figcaption", {}, swatch(entrant), name, make("output", { "data-tip": DRIVEN })), make("canvas", { role: "img" }));
  });
  byId("lanes").replaceChildren(...panes);
  byId("lanes").dataset.count = String(panes.length);
  comparison.set_panes(panes.map((pane) => /** @type {HTMLCanvasElement} */ (pane.querySelector("canvas"))));
}

/** @param {Comparing} it @param {RaceView} race */
function updateLanes({ app }, race) {
  race.lanes.forEach((lane, index) => {
    const pane = byId("lanes").children[index];
    const output = pane?.querySelector("output");
    const canvas = pane?.querySelector("canvas");
    if (!output || !canvas) return;
    setText(output, `${race.time_s > 0 ? `${lane.place}. ` : ""}${percent(lane.coverage)} %${lane.finished ? ` in ${clock(lane.time_s)}` : ""}`);
    setAttribute(pane, "data-leads", String(lane.place === 1 && race.time_s > 0));
    // While it drives, the picture is put into words now and then; while it stands, the words fit it.
    const far = isMoving(race) ? Math.floor(lane.coverage * 10) : lane.time_s;
    if (changed(canvas, "said", `${race.state} ${far} ${lane.finished}`)) {
      const title = app.catalogue.planners[lane.entrant]?.title;
      canvas.setAttribute("aria-label", `${title}: ${percent(lane.coverage)} % of the reachable floor is clean after ${clock(lane.time_s)} and ${metres(lane.distance_m)} m${lane.finished ? ", done" : ""}; place ${lane.place}.`);
    }
  });
}

/** @param {RaceView | null} race */
const isMoving = (race) => ["playing", "seeking"].includes(race?.state ?? "");

/** @param {RaceView | null} race @param {boolean} running @param {boolean} held Whether the time line is being dragged. */
function updateBar(race, running, held) {
  for (const id of ["race-play", "race-step", "race-reset"]) setEnabled(button(id), Boolean(race));
  if (changed(button("race-play"), "running", running)) {
    const name = running ? "Pause" : "Start the race";
    button("race-play").setAttribute("aria-label", name);
    button("race-play").title = `${name} (space)`;
    byId("race-play-icon").setAttribute("href", running ? "#i-pause" : "#i-play");
  }
  if (!race) return;
  if (changed(select("race-speed"), "speed", race.speed)) select("race-speed").value = String(race.speed);
  setText(byId("race-time"), clock(race.time_s));
  const scrub = typed("race-scrub", HTMLInputElement);
  const range = Math.max(race.planned_s, race.end_s, 1);
  if (changed(scrub, "max", range)) scrub.max = String(range);
  if (!held && race.state !== "seeking") scrub.value = String(race.time_s);
  if (!running) setAttribute(scrub, "aria-valuetext", clock(race.time_s));
}

/** Coverage over time of every robot. @param {Comparing} it @param {RaceView} race */
function drawCurves({ comparison }, race) {
  const range = Math.max(race.planned_s, race.end_s, 1);
  const lines = race.lanes.map(({ entrant }, index) => {
    const curve = comparison.coverage_curve(index);
    let path = "M0 99.5";
    for (let i = 0; i + 1 < curve.length; i += 2) path += `L${((1000 * (curve[i] ?? 0)) / range).toFixed(1)} ${(99.5 - 99 * (curve[i + 1] ?? 0)).toFixed(1)}`;
    return `<path d="${path}" data-colour="${entrant % 8}" data-shape="${Math.floor(entrant / 8)}"/>`;
  });
  byId("race-curves").innerHTML = `<path class="grid-line" d="M0 .5H1000M0 50H1000M0 99.5H1000"/>${lines.join("")}`;
}
