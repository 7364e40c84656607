// @ts-check
// Coverage over time of many runs, with a moment to read off by pointer or keys.
import { make, setAttribute } from "../dom.js";
import { clock, percent } from "../format.js";
import { boxFor, crosshair, picture, wordsOf } from "./coverage-picture.js";

/** @typedef {import("./coverage-picture.js").Series} Series */

/** Samples that a page key moves by. */
const PAGE = 20;

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

/** @param {Series} series @param {number} sample */
function lineOf({ title, colour, shape, low, median, high }, sample) {
  const mark = make("i", { className: "swatch" });
  Object.assign(mark.dataset, { colour, shape });
  const range = make("small", {}, `${percent(low[sample] ?? 0, 0)}–${percent(high[sample] ?? 0, 0)}`);
  return make("span", {}, mark, make("span", { className: "who" }, title), make("span", { className: "value" }, `${percent(median[sample] ?? 0)} %`), range);
}

/** The three curves that a module gives as one. @param {Float64Array} flat */
export function bandsOf(flat) {
  const third = flat.length / 3;
  return { low: flat.subarray(0, third), median: flat.subarray(third, 2 * third), high: flat.subarray(2 * third) };
}
