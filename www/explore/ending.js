// @ts-check
// The end of a run: what was reached, how good that is, and what to try next.
import { byId, changed, make, setHidden } from "../dom.js";
import { clock, metres, percent, shareAbove } from "../format.js";
import { style } from "../parts.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("../types").PageView} View
 */

/** Coverage below which floor was left out. */
const CLEAN = 0.95;
/** Excess over the minimum from which another planner is worth a try. */
const GOOD = 0.03;
/** Bumps that explain it where wheels don't slip: plans touch nothing, but pets and people come in their way. */
const BUMPS = 10;
/** Less coverage than planned that is explained. */
const MISSED = 0.002;

/** @param {App} app @returns {Promise<(view: View) => void>} */
export async function startEnding(app) {
  await style(new URL("./ending.css", import.meta.url).href);
  const words = make("p", { role: "status" });
  const next = make("p", { className: "ending-next" });
  const close = make("button", { type: "button", className: "quiet square", "aria-label": "Dismiss" });
  close.append(/** @type {Node} */ (byId("message-close").firstElementChild).cloneNode(true));
  const card = make("div", { className: "message ending", id: "ending", hidden: true }, make("div", {}, words, next), close);
  byId("search-box").before(card);
  /** What was reached at the end that is shown, and at the one that was put away: a bound that is proven later doesn't bring it back. */
  let [shown, dismissed] = ["", ""];
  close.addEventListener("click", () => {
    dismissed = shown;
    byId("floor").focus();
  });

  return (view) => {
    shown = view.state === "finished" ? reached(app, view) : "";
    if (shown === "") dismissed = "";
    const more = `${missed(view)}${bound(view)}`;
    const text = shown && `${shown}${more}`;
    setHidden(card, shown === "" || shown === dismissed || view.search.film !== null && view.search.film.at < view.search.film.pictures);
    if (text === "" || !changed(card, "text", text)) return;
    const far = driven(view);
    const start = shown.slice(0, shown.length - far.length - 1);
    words.replaceChildren(start, make("span", { className: "ending-long" }, far), ".", make("span", { className: "ending-bound" }, more), make("span", { className: "ending-short" }, inShort(view)));
    const ways = suggestions(app, view);
    const before = (/** @type {number} */ i) => (i === 0 ? "" : i === ways.length - 1 ? " or " : ", ");
    next.replaceChildren("Try next: ", ...ways.map((way, i) => make("span", {}, before(i), way)));
  };
}

/** @param {View} view */
const driven = ({ distance_m }) => `, driving ${metres(distance_m)} m`;

/** @param {App} app @param {View} view */
function reached({ catalogue }, view) {
  const { coverage, swept_before, time_s, kind, activity, algorithm } = view;
  const before = swept_before > 0.005 ? ` (${percent(swept_before)} % before the room changed); the run since then took` : " in";
  const swept = `${percent(coverage)} % of the reachable floor swept${before} ${clock(time_s)}${driven(view)}.`;
  if (kind !== "behaviour") return `Done: ${swept}`;
  const ends = catalogue.behaviours.find(({ id }) => id === algorithm)?.ends;
  return `${ends ? "The robot has stopped by itself" : "The robot has stopped"}${activity && activity !== "done" ? ` (${activity})` : ""}: ${swept}`;
}

/** Why it is less than planned, if it is the driving that makes the difference. @param {View} view */
function missed({ plan, coverage, swept_before, smooth, can_smooth, slip, bumps }) {
  const less = (plan?.coverage ?? 0) - coverage;
  if (less < MISSED || swept_before > 0) return "";
  const why = [smooth && can_smooth ? "curves cut corners" : "", slip !== "none" ? "wheels slip" : bumps >= BUMPS ? "bumps pushed it off its path" : ""].filter(Boolean).join(" and ");
  return why && ` Planned: ${percent(plan?.coverage ?? 0)} % (${why}).`;
}

/** @param {View} view */
const aboveMinimum = ({ kind, plan }) => (kind === "behaviour" ? null : (plan?.above_bound ?? null));

/** How far the path is above the least distance and time, as shares: of plans that aren't walks over cells, or miss some. @param {View} view */
function excess({ plan }) {
  const least = plan?.least;
  return plan && least?.length_m ? { length: Math.max(0, plan.length_m / least.length_m - 1), time: Math.max(0, plan.duration_s / least.duration_s - 1) } : null;
}

/** How many times the least distance a run drove that nobody planned, and how many times as long as that takes at top speed. @param {View} view */
const times = ({ distance_m, least_m, time_s, least_s }) => (least_m === null || least_s === null ? null : { least_m, least_s, far: (distance_m / least_m).toFixed(1), long: (time_s / least_s).toFixed(1) });

/** How far it is from the minimum, once that is known. @param {View} view */
function bound(view) {
  const [above, beyond] = [aboveMinimum(view), excess(view)];
  if (above !== null) return above <= 0 ? " No plan can need fewer steps and turns: this one is proven optimal." : ` The plan is ${shareAbove(above)} above the minimum of steps and turns.`;
  if (beyond) return ` The plan is ${shareAbove(beyond.length)} above the least distance for this much floor, and ${shareAbove(beyond.time)} above the least time.`;
  const more = times(view);
  return more ? ` This much floor needs ${metres(more.least_m)} m at least, which take ${clock(more.least_s)} at top speed; it drove ${more.far} times as far, and took ${more.long} times as long.` : "";
}

/** The same on small screens. @param {View} view */
function inShort(view) {
  const [above, beyond] = [aboveMinimum(view), excess(view)];
  if (above !== null) return above <= 0 ? " Proven optimal." : ` ${shareAbove(above)} above the minimum.`;
  if (beyond) return ` ${shareAbove(beyond.length)} above the least distance.`;
  const more = times(view);
  return more ? ` ${more.far} times the least distance, ${more.long} times its time at top speed.` : "";
}

/** What to try next, the most useful first. @param {App} app @param {View} view @returns {HTMLElement[]} */
function suggestions(app, view) {
  const { catalogue, act } = app;
  const link = (/** @type {string} */ text, /** @type {() => void} */ what, more = "") => make("button", { type: "button", className: "link", onclick: what }, text, make("span", { className: "ending-long" }, more));
  const ways = [];
  const above = view.plan?.above_bound ?? null;
  const better = catalogue.planners.find(({ anytime }) => anytime);
  const isSearching = catalogue.planners.some(({ id, anytime }) => anytime && id === view.algorithm);
  const usual = catalogue.planners[0];
  if (view.kind === "behaviour" && usual) ways.push(link(`a plan: ${usual.title}`, () => act((p) => p.select_algorithm(usual.id))));
  else if (above !== null && above > GOOD && better && !isSearching) ways.push(link(better.title, () => act((p) => p.select_algorithm(better.id)), ", which searches for a shorter plan"));
  const finer = [...catalogue.cell_sizes_m].reverse().find((size) => size < view.cell_size_m - 1e-9);
  // Paths in metres have no cells.
  if ((view.plan?.steps ?? 0) > 0 && view.coverage < CLEAN && finer) ways.push(link(`smaller planning cells (${+(100 * finer).toFixed(1)} cm)`, () => act((p) => p.set_cell_size(finer))));
  if (view.slip === "none" && view.kind === "planner") ways.push(link("wheels that slip", () => act((p) => p.set_slip("typical"))));
  ways.push(link("a race of several algorithms", () => byId("tab-compare").click()));
  return ways;
}
