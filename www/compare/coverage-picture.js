// @ts-check
// The picture of coverage over time of many runs: the median run as a line, the middle 80 % of the runs as a band.
import { percent } from "../format.js";

/**
 * @typedef {object} Series
 * @property {string} title
 * @property {number} colour
 * @property {number} shape
 * @property {Float64Array} low Coverage, 0 to 1, at equal distances in time from the start to the end.
 * @property {Float64Array} median
 * @property {Float64Array} high
 * @typedef {{ width: number, height: number, left: number, right: number, top: number, bottom: number }} Box
 */

/** Coverage that gets a line across, in percent; 90 is what times are taken to. */
const GRID = [0, 25, 50, 75, 90, 100];
/** Distance between the ends' names, width of a letter and of what stands before a name, in pixels. */
const [LINE, LETTER, LEAD] = [17, 6.4, 34];
/** Width from which on the ends have names. */
const NAMED = 640;
/** Marks along each line. */
const MARKS = 6;
const DIAMOND = "m0 -5.5l5.5 5.5l-5.5 5.5l-5.5 -5.5z";

/** @param {string} text */
const safe = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** @param {number} width @param {number} screen @param {Series[]} series @returns {Box} */
export function boxFor(width, screen, series) {
  const names = LEAD + LETTER * Math.max(...series.map(({ title }) => title.length), 0);
  const height = Math.round(Math.min(Math.max(width * 0.42, 250), Math.max(screen * 0.48, 250)));
  return { width, height, left: 44, right: width >= NAMED ? names : 12, top: 10, bottom: 40 };
}

/** @param {Series[]} series @param {number} minutes @param {Box} box */
export function picture(series, minutes, box) {
  const { width, height, left, right, top, bottom } = box;
  const lines = GRID.map((share) => {
    const y = yOf(share / 100, box).toFixed(1);
    return `<path class="grid-line${share === 90 ? " goal" : ""}" d="M${left} ${y}H${width - right}"/><text class="value" text-anchor="end" x="${left - 7}" y="${y}" dy="4">${share}${share === 100 ? " %" : ""}</text>`;
  });
  const step = [1, 2, 5, 10, 20, 60, 120].find((step) => minutes / step <= (width < 500 ? 4 : 8)) ?? 120;
  const ticks = [];
  for (let minute = 0; minute <= minutes + 1e-9; minute += step) {
    const x = xOf(minute / minutes, box).toFixed(1);
    ticks.push(`<path class="grid-line" d="M${x} ${height - bottom}v5"/><text class="value" text-anchor="middle" x="${x}" y="${height - bottom + 18}">${minute}</text>`);
  }
  const axis = `<text class="value" text-anchor="middle" x="${(left + width - right) / 2}" y="${height - 5}">simulated minutes</text>`;
  const names = width >= NAMED ? ends(series, box) : "";
  const words = `Coverage over ${minutes} minutes: at the end ${series.map((one) => wordsOf(one, one.median.length - 1)).join("; ")}. The table has the same data.`;
  return `<svg viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" aria-label="${safe(words)}">${lines.join("")}${ticks.join("")}${axis}${series.map((one, i) => bandOf(one, i, box)).join("")}${series.map((one, i) => curveOf(one, i, series.length, box)).join("")}${names}<g data-live=""></g></svg>`;
}

/** @param {number} share Of the time. @param {Box} box */
const xOf = (share, { width, left, right }) => left + share * (width - left - right);
/** @param {number} coverage @param {Box} box */
const yOf = (coverage, { height, top, bottom }) => top + (1 - coverage) * (height - top - bottom);

/** @param {Float64Array} values @param {Box} box */
function pointsOf(values, box) {
  return [...values].map((value, i) => `${xOf(i / (values.length - 1), box).toFixed(1)} ${yOf(value, box).toFixed(1)}`);
}

/** @param {Series} series @param {number} index @param {Box} box */
function bandOf({ colour, low, high }, index, box) {
  const path = [...pointsOf(low, box), ...pointsOf(high, box).reverse()].join("L");
  return `<g data-series="${index}" data-colour="${colour}"><path class="band" d="M${path}Z"/></g>`;
}

/** The middle run with the marks that its algorithm has in lists. @param {Series} series @param {number} index @param {number} count @param {Box} box */
function curveOf({ title, colour, shape, median }, index, count, box) {
  const marks = Array.from({ length: MARKS }, (_, i) => {
    // Not all at the same moments, where lines run together.
    const share = (i + (index + 0.5) / count) / MARKS;
    const sample = Math.round(share * (median.length - 1));
    return markAt(xOf(sample / (median.length - 1), box), yOf(median[sample] ?? 0, box), shape);
  });
  return `<g data-series="${index}" data-colour="${colour}" data-shape="${shape}"><title>${safe(title)}</title><path class="curve" d="M${pointsOf(median, box).join("L")}"/>${marks.join("")}</g>`;
}

/** A disc, square, diamond or triangle, as swatches are. @param {number} x @param {number} y @param {number} shape */
function markAt(x, y, shape) {
  const [cx, cy] = [x.toFixed(1), y.toFixed(1)];
  const outline = ["", "m-4 -4h8v8h-8z", DIAMOND, DIAMOND, "m0 -5l5 9h-10z", "m0 5l5 -9h-10z"][shape];
  return outline ? `<path class="mark" d="M${cx} ${cy}${outline}"/>` : `<circle class="mark" cx="${cx}" cy="${cy}" r="4"/>`;
}

/** Names at the ends of the lines, moved apart where they would lie on each other. @param {Series[]} series @param {Box} box */
function ends(series, box) {
  const order = series.map((one, index) => ({ one, index, y: yOf(one.median.at(-1) ?? 0, box) })).sort((a, b) => a.y - b.y);
  const most = box.height - box.bottom + 6;
  const places = order.map(({ y }) => y);
  for (let i = 1; i < places.length; i += 1) places[i] = Math.max(places[i] ?? 0, (places[i - 1] ?? 0) + LINE);
  for (let i = places.length - 1; i >= 0; i -= 1) places[i] = Math.min(places[i] ?? 0, most - LINE * (places.length - 1 - i));
  const x = box.width - box.right;
  return order
    .map(({ one, index, y }, i) => {
      const to = places[i] ?? y;
      return `<g data-series="${index}" data-colour="${one.colour}" data-shape="${one.shape}"><path class="lead" d="M${x + 2} ${y.toFixed(1)}L${x + 12} ${to.toFixed(1)}"/>${markAt(x + 18, to, one.shape)}<text class="name" x="${x + 27}" y="${to.toFixed(1)}" dy="4">${safe(one.title)}</text></g>`;
    })
    .join("");
}

/** @param {Series[]} series @param {number} share Of the time. @param {number} sample @param {Box} box */
export function crosshair(series, share, sample, box) {
  const x = xOf(share, box).toFixed(1);
  const dots = series.map(({ colour, median }) => `<circle class="dot" data-colour="${colour}" cx="${x}" cy="${yOf(median[sample] ?? 0, box).toFixed(1)}" r="3.5"/>`);
  return `<path class="hair" d="M${x} ${box.top}V${box.height - box.bottom}"/>${dots.join("")}`;
}

/** @param {Series} series @param {number} sample */
export function wordsOf({ title, low, median, high }, sample) {
  return `${title} ${percent(median[sample] ?? 0)} %, from ${percent(low[sample] ?? 0, 0)} to ${percent(high[sample] ?? 0, 0)}`;
}
