// @ts-check
// The table of many runs: times to 90 and 99 %, final coverage, and other results.
import { make } from "../dom.js";
import { clock, count, metres, percent } from "../format.js";
import { fromLink, inLink, keepingFocus, pressed, sorted, sortHead } from "./sorting.js";

/**
 * @typedef {import("../types").Summary} Summary
 * @typedef {import("./sorting.js").Order} Order
 * @typedef {{ title: string, explores: boolean, mark: HTMLElement, summary: Summary | null, failure: string }} Row
 */

/** In place of the unit of a time, which depends on how long the runs are. */
const TIME = "time";

/** Columns: name, unit, definition. */
const COLUMNS = /** @type {const} */ ([
  ["90 % clean", TIME, "Time until 90 % of the reachable floor was swept: the median, and below it the 10 % and 90 % quantiles. Lower is better."],
  ["reached", "of runs", "Share of the runs that swept 90 % in time."],
  ["99 % clean", TIME, "Time until 99 % of the reachable floor was swept. Lower is better."],
  ["reached", "of runs", "Share of the runs that swept 99 % in time."],
  ["Coverage", "% at the end", "Swept share of the reachable floor at the end: the median, and the 10 % to 90 % quantiles. Higher is better."],
  ["Distance", "m", "Median distance driven."],
  ["Excess", "% of distance", "How far the distance exceeds the proven least length of a path that sweeps as much floor, in percent. Below it: how far the time exceeds the time for that length at top speed. Medians. Lower is better."],
  ["Bumps", "", "Median number of bumps."],
  ["Falls", "in all runs", "Falls down a drop-off, in all runs together."],
  ["Dirt left", "% at the end", "Share of the dirt left at the end. Lower is better."],
]);

/** The same with exploring behaviours, which detect walls and furniture instead of sweeping. */
const EXPLORING = /** @type {const} */ ([
  ["90 % found", TIME, "Time until bumper or light bumper had found 90 % of the reachable walls and furniture; for cleaning algorithms, until 90 % of the floor was swept. Lower is better."],
  ["reached", "of runs", "Share of the runs that reached 90 % in time."],
  ["99 % found", TIME, "Time until 99 % was found, or swept. Lower is better."],
  ["reached", "of runs", "Share of the runs that reached 99 % in time."],
  ["Found", "% at the end", "Share of the reachable walls and furniture found at the end; for cleaning algorithms, share of the floor swept. Higher is better."],
]);

/** What each column is sorted by: key, which values are better, value. */
const SORTED = /** @type {[key: string, better: "lower" | "higher", value: (summary: Summary) => number | null | undefined][]} */ ([
  ["time90", "lower", ({ time_to }) => time_to[0]?.median_s],
  ["reached90", "higher", ({ time_to, runs }) => (time_to[0]?.reached ?? 0) / runs],
  ["time99", "lower", ({ time_to }) => time_to[1]?.median_s],
  ["reached99", "higher", ({ time_to, runs }) => (time_to[1]?.reached ?? 0) / runs],
  ["coverage", "higher", ({ coverage }) => coverage.median],
  ["length", "lower", ({ distance_m }) => distance_m.median],
  ["excess_length", "lower", ({ excess }) => excess?.[0].median],
  ["bumps", "lower", ({ bumps }) => bumps.median],
  ["falls", "lower", ({ falls }) => falls],
  ["dirt", "lower", ({ dirt_left }) => dirt_left?.median],
]);

/** @param {HTMLElement} table */
export function startTable(table) {
  /** @type {Order} */
  let order;
  /** @type {Shown | undefined} */
  let shown;
  const draw = () => shown && drawTable(table, shown, order, sortBy);
  const sortBy = (/** @type {string} */ key) => {
    order = pressed(order, key);
    draw();
  };
  return {
    /** @param {Row[]} rows @param {number} minutes How long a run is. @param {(which: number | undefined) => void} stress What pointing at a row does. */
    show(rows, minutes, stress) {
      shown = { rows, minutes, stress };
      draw();
    },
    link: () => inLink(order),
    /** @param {URLSearchParams} pairs Of a link. */
    restore(pairs) {
      order = fromLink(pairs);
      draw();
    },
  };
}

/** @typedef {{ rows: Row[], minutes: number, stress: (which: number | undefined) => void }} Shown */

/** @param {HTMLElement} table @param {Shown} shown @param {Order} order @param {(key: string) => void} sortBy */
function drawTable(table, { rows, minutes, stress }, order, sortBy) {
  const known = rows.flatMap(({ summary }) => summary ?? []);
  const exploring = rows.some(({ explores }) => explores);
  const comparable = known.length > 1 && rows.every(({ explores }) => explores === exploring);
  const all = exploring ? [...EXPLORING, ...COLUMNS.slice(EXPLORING.length)] : COLUMNS;
  const columns = all.slice(0, known.some(({ dirt_left }) => dirt_left) ? undefined : -1);
  const times = minutes <= 60 ? "min:s" : "(h:)min:s";
  const heads = columns.map(([label, unit, definition], column) => {
    const cell = make("th", { scope: "col", "data-tip": definition }, make("span", { className: "unit" }, unit === TIME ? times : unit));
    const [key, better] = SORTED[column] ?? [label, "lower"];
    sortHead(cell, label, key, better, order, sortBy);
    return cell;
  });
  const best = {
    times: [0, 1].map((goal) => Math.min(...known.map((summary) => summary.time_to[goal]?.median_s ?? Infinity))),
    coverage: Math.max(...known.map((summary) => summary.coverage.median)),
  };
  const lines = inOrder(rows, order).map((row) => {
    const cells = row.summary ? cellsOf(row.summary, minutes, comparable ? best : undefined) : columns.map(() => make("td", {}, "–"));
    const name = make("th", { scope: "row" }, row.mark, row.title);
    if (row.failure) name.append(make("span", { className: "failure", "data-tip": row.failure, tabIndex: 0 }, "failed"));
    else if (row.summary) name.append(make("small", {}, `${count(row.summary.runs)} ${row.summary.runs === 1 ? "run" : "runs"}`));
    return make("tr", { onpointerenter: () => stress(rows.indexOf(row)), onpointerleave: () => stress(undefined) }, name, ...cells);
  });
  keepingFocus(table, () => {
    table.querySelector("thead")?.replaceChildren(make("tr", {}, make("th", { scope: "col" }, "Algorithm"), ...heads));
    table.querySelector("tbody")?.replaceChildren(...lines);
  });
}

/** Best first, or last. @param {Row[]} rows @param {Order} order */
function inOrder(rows, order) {
  const [, better, value] = SORTED.find(([key]) => key === order?.key) ?? [];
  return order && better && value ? sorted(rows, order, better, ({ summary }) => summary && value(summary)) : rows;
}

/** A median, and the range below it if there is one. @param {{ low: number, median: number, high: number }} values @param {(value: number) => string} text */
function spread({ low, median, high }, text) {
  const cell = make("td", {}, text(median));
  if (low < high) cell.append(make("small", {}, `${text(low)}–${text(high)}`));
  return cell;
}

/** @param {Summary} summary @param {number} minutes @param {{ times: number[], coverage: number } | undefined} best */
function cellsOf({ runs, time_to, coverage, distance_m, bumps, falls, dirt_left, excess }, minutes, best) {
  const times = time_to.flatMap(({ percent: goal, reached, low_s, median_s, high_s }, i) => {
    const late = `> ${clock(60 * minutes)}`;
    const time = make("td", { className: best && median_s !== null && median_s === best.times[i] ? "best" : "" }, median_s === null ? late : clock(median_s));
    if (median_s === null) time.dataset.tip = `Fewer than half of the runs reached ${goal} % within ${minutes} minutes, so there is no median.`;
    if (low_s !== null) time.append(make("small", {}, `${clock(low_s)}${high_s === null ? ` to ${late}` : `–${clock(high_s)}`}`));
    return [time, make("td", {}, `${Math.min(Math.round((100 * reached) / runs), reached < runs ? 99 : 100)} %`, make("small", {}, `${reached} of ${runs}`))];
  });
  const end = spread(coverage, percent);
  if (best && percent(coverage.median) === percent(best.coverage)) end.className = "best";
  const [way, hits] = [spread(distance_m, metres), spread(bumps, count)];
  const more = make("td", {}, excess ? count(100 * excess[0].median) : "–");
  if (excess) more.append(make("small", {}, `${count(100 * excess[1].median)} of time`));
  const dirt = dirt_left ? spread(dirt_left, percent) : "";
  return [...times, end, way, more, hits, make("td", { className: falls > 0 ? "fell" : "" }, count(falls)), ...(dirt ? [dirt] : [])];
}
