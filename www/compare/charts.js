// @ts-check
// Bars for length, turns and revisits, as in figures 5.4 to 5.6 of Emu & Obaida 2020, and all numbers side by side.
import { shown } from "../format.js";

/**
 * @typedef {import("../types").TableView} Table
 * @typedef {import("../types").ComparisonView["entrants"][number]} Entrant
 */

/** Numbers that get bars; the first three are those of the figures. */
const BARS = ["length", "direction_changes", "revisits", "turns", "duration", "above_minimum"];
/** Numbers of the chart with an axis for each. */
const AXES = ["coverage", "length", "duration", "energy", "turns", "revisits", "area_swept_again", "planning"];
/** Height of a bar with its name, of a printed value's bar, and width of all, in units of the drawing. */
const [ROW, PRINTED, WIDTH] = [34, 18, 330];
/** Height of the chart with axes down to the first name below it, and of a name. */
const [PROFILES, KEY] = [292, 18];

/** @param {string} text */
const safe = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/**
 * Draws the charts of a table.
 * @param {HTMLElement} into
 * @param {Table} table
 * @param {Entrant[]} entrants
 * @param {(entrant: number) => void} choose
 */
export function drawCharts(into, table, entrants, choose) {
  const charts = BARS.map((id) => bars(table, entrants, id)).concat(parallel(table, entrants));
  into.innerHTML = charts.map((svg) => `<figure>${svg}</figure>`).join("");
  for (const mark of into.querySelectorAll("[data-entrant]")) mark.addEventListener("click", () => choose(Number(mark.getAttribute("data-entrant"))));
}

/** @param {Table} table @param {Entrant[]} entrants @param {string} id */
function bars({ metrics, rows }, entrants, id) {
  const column = metrics.findIndex((metric) => metric.id === id);
  const metric = metrics[column];
  if (!metric) return "";
  const known = rows.flatMap((row) => {
    const spread = row.values[column];
    return spread ? [{ row, spread, printed: row.printed[column] ?? null }] : [];
  });
  known.sort((a, b) => a.spread.median - b.spread.median);
  const most = Math.max(...known.map(({ spread, printed }) => Math.max(spread.max, printed ?? 0)), 1e-9);
  const any = known.some(({ printed }) => printed !== null);
  const x = (/** @type {number} */ value) => (value / most) * (WIDTH - (any ? 96 : 64));
  const title = `${metric.label}${metric.unit && metric.unit !== "s" ? `, ${metric.unit}` : ""}`;
  const pitch = ROW + (any ? PRINTED : 0);
  const height = 6 + pitch * known.length;
  const items = known.map(({ row, spread, printed }, i) => {
    const y = 6 + pitch * i;
    const { title: name, mark } = drawn(entrants[row.entrant]);
    const range = spread.max > spread.min ? `<path class="range" d="M${x(spread.min)} ${y + 22}H${x(spread.max)}"/>` : "";
    return `<g data-entrant="${row.entrant}"><title>${name}: ${shown(metric, spread.median)}</title><text x="0" y="${y + 11}" class="name">${name}</text><rect y="${y + 16}" width="${Math.max(x(spread.median), 1)}" height="12" rx="2" ${mark}/>${range}<text x="${x(spread.max) + 6}" y="${y + 26}" class="value">${shown(metric, spread.median)}</text>${printed === null ? "" : printedBar(x(printed), y + ROW, shown(metric, printed))}</g>`;
  });
  return svg(title, height, items.join(""), `${title}: ${known.map(({ row, spread }) => `${entrants[row.entrant]?.title} ${shown(metric, spread.median)}`).join(", ")}`);
}

/** What a paper prints. @param {number} width @param {number} y @param {string} value */
const printedBar = (width, y, value) =>
  `<rect class="printed" y="${y}" width="${Math.max(width, 1)}" height="10" rx="2"/><text class="value" x="${width + 6}" y="${y + 9}">${value} printed</text>`;

/** One axis for each number, the best at the top, the worst at the bottom. @param {Table} table @param {Entrant[]} entrants */
function parallel({ metrics, rows }, entrants) {
  const axes = AXES.map((id) => metrics.findIndex((metric) => metric.id === id)).filter((column) => column >= 0 && rows.some((row) => row.values[column]));
  const [top, bottom] = [40, 250];
  const x = (/** @type {number} */ i) => 30 + (i * (WIDTH - 60)) / Math.max(axes.length - 1, 1);
  const ends = axes.map((column) => {
    const values = rows.flatMap((row) => row.values[column]?.median ?? []);
    const [low, high] = [Math.min(...values), Math.max(...values)];
    return metrics[column]?.better === "lower" ? { best: low, worst: high } : { best: high, worst: low };
  });
  const marks = axes.map((column, i) => {
    const metric = metrics[column];
    const end = ends[i];
    if (!metric || !end) return "";
    return `<path class="grid-line" d="M${x(i)} ${top}V${bottom}"/><text class="name middle" x="${x(i)}" y="${i % 2 ? 26 : 14}">${safe(metric.label)}</text><text class="value middle" x="${x(i)}" y="${bottom + (i % 2 ? 26 : 14)}">${shown(metric, end.worst)}</text>`;
  });
  const lines = rows.map((row) => {
    const points = axes.flatMap((column, i) => {
      const [value, end] = [row.values[column]?.median, ends[i]];
      if (value === undefined || !end) return [];
      const metric = metrics[column];
      const share = metric && shown(metric, end.best) === shown(metric, end.worst) ? 0 : (value - end.best) / (end.worst - end.best);
      return [`${x(i).toFixed(1)} ${(top + share * (bottom - top)).toFixed(1)}`];
    });
    const { title: name, mark } = drawn(entrants[row.entrant]);
    return points.length > 1 ? `<path class="profile" d="M${points.join("L")}" data-entrant="${row.entrant}" ${mark}><title>${name}</title></path>` : "";
  });
  const key = rows.map((row, i) => {
    const { title: name, mark } = drawn(entrants[row.entrant]);
    const y = PROFILES + KEY * i;
    return `<path class="profile" d="M0 ${y}H26" data-entrant="${row.entrant}" ${mark}/><text class="name" x="34" y="${y + 4}">${name}</text>`;
  });
  return svg("Best at the top, worst at the bottom", PROFILES + KEY * rows.length, marks.join("") + lines.join("") + key.join(""), "Profiles of the algorithms over all numbers; the table has the same data.");
}

/** A planner's name and mark, as SVG. @param {Entrant} [entrant] */
function drawn(entrant) {
  return { title: safe(entrant?.title ?? ""), mark: `data-colour="${entrant?.mark.colour}" data-shape="${entrant?.mark.shape}"` };
}

/** @param {string} title @param {number} height @param {string} inside @param {string} words */
function svg(title, height, inside, words) {
  return `<figcaption>${safe(title)}</figcaption><svg viewBox="0 0 ${WIDTH} ${height}" role="img" aria-label="${safe(words)}">${inside}</svg>`;
}
