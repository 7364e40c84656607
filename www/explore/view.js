// @ts-check
// Writes the view into the document, and only what changed.
import { button, byId, changed, make, setAttribute, setEnabled, setHidden, setText, typed } from "../dom.js";
import { clock, count, metres, pace, percent, smallLength, took } from "../format.js";
import { updateMessage } from "../messages.js";
import { atMostEvery } from "../shared/frame-pacer.js";

/**
 * @typedef {import("../types").PageView} View
 * @typedef {import("../types").PlanView} Plan
 * @typedef {{ label: string, tip: string | ((v: View) => string), plan?: (p: Plan) => string, run?: (v: View) => string, when?: (v: View) => boolean }} Metric
 */

/** @type {Metric[]} */
const RUN_METRICS = [
  { label: "Coverage", tip: "Swept share of the floor that this robot can reach, at its true cleaning width. Plan: driven without errors.", plan: (p) => `${percent(p.coverage)} %`, run: (v) => `${percent(v.coverage)} %` },
  { label: "Time", tip: "From start to standstill at the robot's speeds and accelerations, in minutes and seconds.", plan: (p) => clock(p.duration_s), run: (v) => clock(v.time_s) },
  { label: "Distance", tip: "Distance driven, in metres.", plan: (p) => `${metres(p.length_m)} m`, run: (v) => `${metres(v.distance_m)} m` },
  { label: "Turning", tip: "Sum of all turns in degrees, including the one at the start.", plan: (p) => `${count(p.turning_deg)}°`, run: (v) => `${count(v.turning_deg)}°` },
  { label: "Overlap", tip: "Repeated passes as a share of the swept floor: at 30 %, three tenths of it were swept a second time.", plan: (p) => `${percent(p.overlap, 0)} %`, run: (v) => `${percent(v.overlap, 0)} %` },
  { label: "Bumps", tip: "How often the bumper touched a wall or furniture.", run: (v) => count(v.bumps) },
  { label: "Position error", tip: "Distance between the true position and the one estimated from wheel counts.", run: (v) => smallLength(v.pose_error_m) },
  { label: "Dirt left", tip: "Share of the room's dirt not picked up yet.", run: (v) => `${percent(v.dirt_left ?? 0, 0)} %`, when: (v) => v.dirt_left !== null },
];

/** @type {Metric[]} */
const PLAN_METRICS = [
  { label: "Cells visited", tip: "Cells of the planning grid that the plan visits, out of those reachable from the start.", plan: (p) => `${count(p.visited_cells)} of ${count(p.reachable_cells)}` },
  { label: "Steps", tip: "Steps from one cell to the next.", plan: (p) => count(p.steps) },
  { label: "Revisits", tip: "Repeated visits to cells, which clean nothing new.", plan: (p) => count(p.revisits) },
  { label: "Turns", tip: "Quarter turns between steps on the grid; a reversal counts as two.", plan: (p) => count(p.turns) },
  { label: "Above the bound", tip: "How far the plan's cost is above a proven lower bound for these cells, in percent, as in Compare. A plan costs its steps + 2 × its quarter turns. It is computed after planning; a plan that misses cells has none.", plan: (p) => above(p.above_bound) },
  { label: "Optimality gap", tip: ownGap, plan: (p) => above(p.gap), when: (v) => typeof v.plan?.gap === "number" },
  { label: "Kept early", tip: "The search was stopped early and its best plan kept: time spent, and progress at that moment.", plan: (p) => `after ${took(p.planning_s ?? 0)}, ${percent(p.kept_at ?? 0, 0)} % of the search`, when: (v) => typeof v.plan?.kept_at === "number" },
  { label: "Planned in", tip: "Planning time on this computer. The opening scene's plan is preloaded.", plan: (p) => (p.planning_s === null ? "preloaded" : took(p.planning_s)) },
];

/** Explanation of the gap that a planner proves. @param {View} view */
function ownGap({ plan }) {
  const turn = +(plan?.turn_weight ?? 0).toFixed(2);
  const weights = `its steps + ${turn} × its quarter turns${plan?.times_turns ? " (the time that this robot takes for one, in steps; the turn to the first step counts too)" : ""}`;
  return `How far the plan's cost is above the proven lower bound of what this search minimises, in percent. Here a plan costs ${weights}. 0 % means proven optimal.`;
}

/** @param {number | null} share */
const above = (share) => (share === null ? "–" : share === 0 ? "proven optimal" : `${gap(share)} %`);

/** @type {{ metric: Metric, plan: Element, run: Element, line: HTMLElement }[]} */
const rows = [];

/** @param {Metric} metric @param {boolean} wide */
function row(metric, wide) {
  const plan = make("td", wide ? { colSpan: 2 } : {});
  const run = make("td");
  const term = make("button", { type: "button", className: "term" }, metric.label);
  if (!wide) plan.className = "plan-only";
  const line = make("tr", typeof metric.tip === "string" ? { "data-tip": metric.tip } : {}, make("th", { scope: "row" }, term), plan, ...(wide ? [] : [run]));
  rows.push({ metric, plan, run, line });
  return line;
}

byId("metrics-run").append(...RUN_METRICS.map((metric) => row(metric, false)));
byId("metrics-plan").append(...PLAN_METRICS.map((metric) => row(metric, true)));

/** Where fingers point there is hardly a keyboard. */
const HAS_KEYS = !matchMedia("(hover: none)").matches;

/** Whether it is time to put the picture into words. */
const mayNarrate = atMostEvery(4000);

/** @param {import("../main.js").App} app */
export function updateView({ view, playground }) {
  const { plan } = view;
  const known = plan && plan.steps > 0 ? plan : null;
  for (const { metric, plan, run, line } of rows) {
    if (typeof metric.tip !== "string") setAttribute(line, "data-tip", metric.tip(view));
    if (metric.when) setHidden(line, !metric.when(view));
    setText(plan, known && metric.plan ? metric.plan(known) : "–");
    setText(run, metric.run ? metric.run(view) : "–");
  }
  setText(byId("n-coverage"), percent(view.coverage));
  setText(byId("n-time"), clock(view.time_s));
  setText(byId("n-time-unit"), view.time_s < 3600 ? "min" : "h");
  setText(byId("n-distance"), metres(view.distance_m));
  setAttribute(byId("numbers"), "data-long", String(view.time_s >= 36_000 || view.distance_m >= 10_000));
  setAttribute(document.body, "data-state", view.state);
  setAttribute(document.body, "data-kind", view.kind);
  updateFolds(view);
  updateMessage(view);
  setHidden(byId("search-box"), !view.search.text);
  setText(byId("search-note"), view.search.text);
  updatePlanning(view);
  updateTools(view);

  // While paused the search changes only by a step or a seek, which is announced at once.
  const decision = ["playing", "planning", "seeking"].includes(view.state) ? "" : view.search.text;
  const news = [changed(byId("floor"), "state", view.state), changed(byId("floor"), "decision", decision)];
  if (mayNarrate(undefined, news.includes(true))) {
    const text = playground.description();
    setAttribute(byId("floor"), "aria-label", text);
    // Read aloud only when something comes to an end, not all the time.
    if (!["playing", "planning", "seeking"].includes(view.state)) setText(byId("narration"), text);
  }
}

/** The sensors are open for robots that live by them, out of the way otherwise; then it is up to the user. @param {View} view */
export function updateFolds({ kind }) {
  const fold = typed("senses-fold", HTMLDetailsElement);
  if (changed(fold, "kind", kind)) fold.open = kind === "behaviour";
}

/** A share in percent, rounded up: nothing but 0 is shown as that. @param {number} share */
const gap = (share) => (Math.ceil(share * 1000 - 1e-6) / 10).toFixed(1);

/** @param {View} view */
function updatePlanning({ state, plan, can }) {
  const planning = state === "planning";
  const done = planning && plan ? Math.floor(plan.progress * 100) : 0;
  setHidden(byId("planning"), !planning);
  setText(byId("planning-percent"), `${done} %`);
  setAttribute(typed("planning-bar", HTMLProgressElement), "value", String(done));
  setEnabled(button("planning-cancel"), can.cancel);
  const proven = planning ? (plan?.gap ?? null) : null;
  setHidden(byId("planning-gap"), proven === null);
  setText(byId("planning-gap"), proven === null ? "" : proven === 0 ? "Proven optimal" : `${gap(proven)} % above the proven bound`);
  setHidden(byId("planning-keep"), !can.keep);
}

/** @param {View} view */
function updateTools({ can, tool, state, speed_factor, speed, is_lifted, is_carried, is_held_high }) {
  for (const node of byId("tools").querySelectorAll("button[data-tool]")) {
    const name = node.getAttribute("data-tool");
    setAttribute(node, "aria-pressed", String(name === tool && !is_lifted));
    setEnabled(/** @type {HTMLButtonElement} */ (node), name === "view" || can.edit);
  }
  setAttribute(byId("stage"), "data-tool", tool);
  setEnabled(button("lift"), can.lift || is_lifted);
  setAttribute(button("lift"), "aria-pressed", String(is_lifted));
  setText(byId("lift-name"), is_lifted ? "Put down" : "Lift robot");
  setAttribute(button("lift"), "aria-label", is_lifted ? "Put the robot down" : "Lift the robot");
  setHidden(byId("carry-note"), !is_carried);
  // Never over the robot.
  setAttribute(byId("carry-note"), "data-low", String(is_held_high));
  setText(byId("carry-note"), is_carried ? (HAS_KEYS ? "Click where to put the robot down. Arrow keys move it, Enter puts it down, Escape puts it back." : "Tap where to put the robot down, or drag it there.") : "");
  setEnabled(button("undo"), can.undo);
  setEnabled(button("redo"), can.redo);
  const lags = state === "playing" && speed_factor > 0 && (speed === 0 || speed_factor < 0.9 * speed);
  setText(byId("pace"), lags ? `${pace(speed_factor)} reached` : "");
}
