// @ts-check
// Coverage over time of many runs: the middle run as a line, four out of five as a band, and a moment to read off.
import { make, setAttribute } from "../dom.js";
import { clock, percent } from "../format.js";

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
/** Samples that a page key moves by. */
const PAGE = 20;

/** @param {string} text */
const safe = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** @param {HTMLElement} plot */
export function startChart(plot) {
  /** @type {Series[]} */
  let series = [];
  let minutes = 0;
  /** Sample that is read off. @type {number | undefined} */
  let at;
  const readout = make("div", { className: "readout", hidden: true });
  const drawing = make("div");
  plot.append(drawing, readout);

  const last = () => (series[0]?.median.length ?? 1) - 1;
  const size = () => boxFor(plot.clientWidth, innerHeight, series);

  /** @param {number | undefined} sample */
  const read = (sample) => {
    at = sample === undefined ? undefined : Math.min(Math.max(Math.round(sample), 0), last());
    const live = drawing.querySelector("[data-live]");
    readout.hidden = at === undefined || series.length === 0;
    if (live) live.innerHTML = at === undefined ? "" : crosshair(series, at / Math.max(last(), 1), at, size());
    if (at === undefined) return;
    const seconds = (60 * minutes * at) / Math.max(last(), 1);
    const order = series.map((one) => ({ one, now: one.median[at ?? 0] ?? 0 })).sort((a, b) => b.now - a.now);
    readout.replaceChildren(make("b", {}, `after ${clock(seconds)}`), ...order.map(({ one }) => lineOf(one, at ?? 0)));
    readout.dataset.corner = freeCorner(series);
    readout.style.setProperty("--right", `${size().right + 12}px`);
    setAttribute(plot, "aria-valuenow", seconds.toFixed(0));
    setAttribute(plot, "aria-valuetext", `${clock(seconds)}: ${order.map(({ one }) => wordsOf(one, at ?? 0)).join("; ")}`);
  };

  plot.addEventListener("pointermove", (event) => {
    const { left, right, width } = size();
    const x = event.clientX - plot.getBoundingClientRect().left;
    read(((x - left) / (width - left - right)) * last());
  });
  // A finger that is lifted still wants to read.
  plot.addEventListener("pointerleave", ({ pointerType }) => pointerType === "touch" || read(undefined));
  plot.addEventListener("blur", () => read(undefined));
  plot.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const now = at ?? 0;
    /** @type {Record<string, number | undefined>} */
    const to = { ArrowRight: now + 1, ArrowUp: now + 1, ArrowLeft: now - 1, ArrowDown: now - 1, PageUp: now + PAGE, PageDown: now - PAGE, Home: 0, End: last(), Escape: undefined };
    if (!(event.key in to)) return;
    event.preventDefault();
    event.stopPropagation();
    read(to[event.key]);
  });

  const draw = () => {
    if (plot.clientWidth === 0 || series.length === 0) return;
    drawing.innerHTML = picture(series, minutes, size());
    setAttribute(plot, "aria-valuemax", String(60 * minutes));
    read(at);
  };
  new ResizeObserver(draw).observe(plot);

  return {
    /** @param {Series[]} next @param {number} duration Minutes. */
    show(next, duration) {
      series = next;
      minutes = duration;
      draw();
    },
    /** Lets all but one step back; none without a number. @param {number | undefined} which */
    stress(which) {
      for (const group of drawing.querySelectorAll("[data-series]")) {
        group.classList.toggle("back", which !== undefined && group.getAttribute("data-series") !== String(which));
        group.classList.toggle("front", which !== undefined && group.getAttribute("data-series") === String(which));
      }
    },
  };
}

/** Where most room is left for numbers. @param {Series[]} series @returns {"left" | "right"} */
function freeCorner(series) {
  const at = (/** @type {Float64Array} */ values, /** @type {number} */ share) => values[Math.round(share * (values.length - 1))] ?? 0;
  const below = Math.min(...series.map(({ low }) => at(low, 0.6)));
  const above = 1 - Math.max(...series.map(({ high }) => at(high, 0.4)));
  return below >= above ? "right" : "left";
}

/** @param {number} width @param {number} screen @param {Series[]} series @returns {Box} */
function boxFor(width, screen, series) {
  const names = LEAD + LETTER * Math.max(...series.map(({ title }) => title.length), 0);
  const height = Math.round(Math.min(Math.max(width * 0.42, 250), Math.max(screen * 0.48, 250)));
  return { width, height, left: 44, right: width >= NAMED ? names : 12, top: 10, bottom: 40 };
}

/** @param {Series[]} series @param {number} minutes @param {Box} box */
function picture(series, minutes, box) {
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
function crosshair(series, share, sample, box) {
  const x = xOf(share, box).toFixed(1);
  const dots = series.map(({ colour, median }) => `<circle class="dot" data-colour="${colour}" cx="${x}" cy="${yOf(median[sample] ?? 0, box).toFixed(1)}" r="3.5"/>`);
  return `<path class="hair" d="M${x} ${box.top}V${box.height - box.bottom}"/>${dots.join("")}`;
}

/** @param {Series} series @param {number} sample */
function lineOf({ title, colour, shape, low, median, high }, sample) {
  const mark = make("i", { className: "swatch" });
  Object.assign(mark.dataset, { colour, shape });
  const range = make("small", {}, `${percent(low[sample] ?? 0, 0)}–${percent(high[sample] ?? 0, 0)}`);
  return make("span", {}, mark, make("span", { className: "who" }, title), make("span", { className: "value" }, `${percent(median[sample] ?? 0)} %`), range);
}

/** @param {Series} series @param {number} sample */
function wordsOf({ title, low, median, high }, sample) {
  return `${title} ${percent(median[sample] ?? 0)} %, from ${percent(low[sample] ?? 0, 0)} to ${percent(high[sample] ?? 0, 0)}`;
}
