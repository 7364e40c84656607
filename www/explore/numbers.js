// @ts-check
// The numbers beside the floor: of the plan, and of the run so far. Those that Compare has, too, look and read the same.
import { byId, make, setAttribute, setHidden, setText } from "../dom.js";
import { clock, count, isClock, metres, percent, shareAbove, shown, smallLength, took } from "../format.js";

/**
 * @typedef {import("../types").PageView} View
 * @typedef {import("../types").PlanView} Plan
 * @typedef {{ plan?: (p: Plan) => string, run?: (v: View) => string, when?: (v: View) => boolean }} Texts
 * @typedef {{ label: string, tip: string | ((v: View) => string) } & Texts} Line
 * @typedef {{ metric: string, label?: string, more?: string | ((v: View) => string), plan?: (p: Plan) => number | null, beyond?: (p: Plan) => string, run?: (v: View) => number, when?: (v: View) => boolean }} MetricLine
 * A metric of the tables, which says what it is called, how it is shown and what it means.
 */

/** @type {(Line | MetricLine)[]} */
const RUN = [
  { metric: "coverage", plan: (p) => 100 * p.coverage, run: (v) => 100 * v.coverage },
  { metric: "duration", more: "A run takes a little longer than its plan, as the robot keeps itself on the path.", plan: (p) => p.duration_s, run: (v) => v.time_s },
  { metric: "length", label: "Distance", plan: (p) => p.length_m, run: (v) => v.distance_m },
  { metric: "turning", plan: (p) => p.turning_deg / 360, run: (v) => v.turning_deg / 360 },
  { metric: "swept_again", plan: (p) => 100 * p.overlap, run: (v) => 100 * v.overlap },
  { label: "Bumps", tip: "How often the bumper touched a wall or furniture.", run: (v) => count(v.bumps) },
  { label: "Position error", tip: "Distance between the true position and the one estimated from wheel counts.", run: (v) => smallLength(v.pose_error_m) },
  { label: "Dirt left", tip: "Share of the room's dirt not picked up yet.", run: (v) => `${percent(v.dirt_left ?? 0)} %`, when: (v) => v.dirt_left !== null },
];

/** What a quarter turn costs in comparisons, steps. */
const TURN = 2;

/** @type {(Line | MetricLine)[]} */
const PLAN = [
  { label: "Cells visited", when: isWalk, tip: "Cells of the planning grid that the plan visits, out of those reachable from the start.", plan: (p) => `${count(p.visited_cells)} of ${count(p.reachable_cells)}` },
  { metric: "excess_length", more: exactly, plan: (p) => above(p.length_m, p.least?.length_m), beyond: (p) => (p.least ? ` over ${metres(p.least.length_m)} m` : "") },
  { metric: "excess_time", more: exactly, plan: (p) => above(p.duration_s, p.least?.duration_s), beyond: (p) => (p.least ? ` over ${clock(p.least.duration_s)}` : "") },
  { metric: "steps", when: isWalk, plan: (p) => p.steps },
  { metric: "revisits", when: isWalk, plan: (p) => p.revisits },
  { metric: "turns", when: isWalk, plan: (p) => p.turns },
  { metric: "above_minimum", when: isWalk, more: "It is computed after planning; a plan that misses cells has none.", plan: (p) => (p.above_bound === null ? null : 100 * p.above_bound) },
  { label: "Optimality gap", tip: ownGap, plan: (p) => (p.gap === 0 ? "proven optimal" : shareAbove(p.gap ?? 0)) + (Math.abs((p.turn_weight ?? TURN) - TURN) < 0.005 ? "" : ", by its own turn cost"), when: (v) => typeof v.plan?.gap === "number" },
  { label: "Kept early", tip: "The search was stopped early and its best plan kept: time spent, and progress at that moment.", plan: (p) => `after ${took(p.planning_s ?? 0)}, ${percent(p.kept_at ?? 0, 0)} % of the search`, when: (v) => typeof v.plan?.kept_at === "number" },
  { metric: "planning", label: "Planned in", more: "The opening scene's plan is preloaded.", plan: (p) => p.planning_s },
];

/** Whether the plan is a walk over cells, not a path in metres. @param {View} view */
function isWalk({ plan }) {
  return !plan || plan.reachable_cells > 0 || plan.length_m === 0;
}

/** The floor that a minimum is for. @param {View} view */
function exactly({ plan }) {
  return plan?.least ? `This plan sweeps ${percent(plan.least.coverage)} %, measured on lines 4 mm apart, more exactly than Coverage.` : "";
}

/** Percent above the least, if that is known. @param {number} value @param {number | undefined} least */
function above(value, least) {
  return least ? Math.max(0, 100 * (value / least - 1)) : null;
}

/** Explanation of the gap that a planner proves. @param {View} view */
function ownGap({ plan }) {
  const turn = +(plan?.turn_weight ?? 0).toFixed(2);
  const weights = `its steps + ${turn} × its quarter turns${plan?.times_turns ? " (the time that this robot takes for one, in steps; the turn to the first step counts too)" : ""}`;
  return `How far the plan is above the proven minimum of what this search minimises: ${weights}. "Above the minimum" counts a quarter turn as ${TURN} steps instead. 0 %: proven optimal.`;
}

/** @param {MetricLine} line @param {import("../types").MetricInfo[]} metrics @returns {Line} */
function lineOf({ metric: id, label, more, plan, beyond, run, when }, metrics) {
  const metric = metrics.find((known) => known.id === id);
  if (!metric) throw new Error(`no metric is called "${id}"`);
  const unit = !metric.unit || isClock(metric) ? "" : ` ${metric.unit}`;
  const text = (/** @type {number | null} */ value) => {
    if (value === null) return id === "planning" ? "preloaded" : "–";
    return id === "above_minimum" && value === 0 ? "proven optimal" : shown(metric, value) + unit;
  };
  return {
    label: label ?? metric.label,
    tip: typeof more === "function" ? (v) => `${metric.definition} ${more(v)}`.trim() : [metric.definition, more ?? ""].join(" ").trim(),
    plan: plan && ((p) => text(plan(p)) + (beyond?.(p) ?? "")),
    run: run && ((v) => text(run(v))),
    when,
  };
}

/** @param {import("../main.js").App} app @returns {(view: View) => void} */
export function startNumbers({ catalogue }) {
  /** @type {{ of: Line, plan: Element, run: Element, line: HTMLElement }[]} */
  const rows = [];
  /** @param {Line | MetricLine} description @param {boolean} isPlanOnly */
  const row = (description, isPlanOnly) => {
    const of = "metric" in description ? lineOf(description, catalogue.metrics) : description;
    const plan = make("td", isPlanOnly ? { colSpan: 2 } : {});
    const run = make("td");
    const term = make("button", { type: "button", className: "term" }, of.label);
    if (!isPlanOnly) plan.className = "plan-only";
    const line = make("tr", typeof of.tip === "string" ? { "data-tip": of.tip } : {}, make("th", { scope: "row" }, term), plan, ...(isPlanOnly ? [] : [run]));
    rows.push({ of, plan, run, line });
    return line;
  };
  byId("metrics-run").append(...RUN.map((line) => row(line, false)));
  byId("metrics-plan").append(...PLAN.map((line) => row(line, true)));

  return (view) => {
    const known = view.plan && (view.plan.length_m > 0 || view.path_corners) ? view.plan : null;
    // A path in metres has no cells.
    setHidden(byId("metrics-plan"), view.path_corners > 0);
    for (const { of, plan, run, line } of rows) {
      if (typeof of.tip !== "string") setAttribute(line, "data-tip", of.tip(view));
      if (of.when) setHidden(line, !of.when(view));
      setText(plan, known && of.plan ? of.plan(known) : "–");
      setText(run, of.run ? of.run(view) : "–");
    }
  };
}
