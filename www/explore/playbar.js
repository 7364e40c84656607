// @ts-check
// Play, step, speed, and the time line whose scrubber is the curve of coverage over time.
import { button, byId, changed, fill, make, select, setAttribute, setEnabled, setText } from "../dom.js";
import { clock, percent } from "../format.js";

/**
 * @typedef {import("../types").PageView} View
 * @typedef {import("../main.js").App} App
 */

/** Width of the curve's own coordinates; its height is 100. */
const WIDTH = 1000;
/** Most points that are drawn. */
const MOST_POINTS = 400;
/** Milliseconds between redraws of the curve while it grows. */
const REDRAW = 200;

/** @param {App} app @returns {(view: View) => void} */
export function startPlaybar(app) {
  const { act, catalogue } = app;
  fill(select("speed"), catalogue.speeds.map((x) => [String(x), x === 0 ? "max" : `${x}×`]));
  select("speed").disabled = false;
  select("speed").addEventListener("change", () => act((p) => p.set_speed(Number(select("speed").value))));

  button("play").addEventListener("click", () => {
    const { can } = app.view;
    if (can.pause) act((p) => p.pause());
    else if (can.play) act((p) => p.play());
  });
  button("step").addEventListener("click", () => app.view.can.step && act((p) => p.step()));
  button("reset").addEventListener("click", () => app.view.can.reset && act((p) => p.reset()));
  startScrubber(app);

  let drawn = 0;
  return (view) => {
    const { can } = view;
    setEnabled(button("play"), can.play || can.pause);
    setEnabled(button("step"), can.step);
    setEnabled(button("reset"), can.reset);
    if (changed(button("play"), "pausing", can.pause)) {
      const name = can.pause ? "Pause" : "Play";
      button("play").setAttribute("aria-label", name);
      button("play").title = `${name} (space)`;
      byId("play-icon").setAttribute("href", can.pause ? "#i-pause" : "#i-play");
    }
    if (changed(select("speed"), "speed", view.speed)) select("speed").value = String(view.speed);

    const range = rangeOf(view);
    const now = performance.now();
    const extent = `${view.run_end_s} ${range} ${view.plan?.coverage} ${view.algorithm}`;
    if (now - drawn > REDRAW && changed(byId("curve-line"), "extent", extent)) {
      drawn = now;
      drawCurve(app.playground.coverage_curve(), range, view);
      if (view.kind === "behaviour") setText(byId("timeline-plan"), openEnd(app));
      drawTicks(range);
    }
    const scrubber = byId("scrubber");
    scrubber.style.setProperty("--at", String(view.time_s / range));
    byId("playhead").style.setProperty("--coverage", String(view.coverage));
    setAttribute(scrubber, "aria-valuemax", String(Math.floor(view.run_end_s)));
    // Read aloud at every change, so only while it stands still or is moved by hand.
    if (view.state !== "playing" || document.activeElement !== scrubber) {
      setAttribute(scrubber, "aria-valuenow", String(Math.floor(view.time_s)));
      setAttribute(scrubber, "aria-valuetext", `${clock(view.time_s)}, ${percent(view.coverage)} % covered`);
    }
    setAttribute(scrubber, "aria-disabled", String(!can.seek));
  };
}

/** Seconds that the time line spans: what the plan foresees, or what was driven if that is more; without a plan, some more. @param {View} view */
const rangeOf = (view) => (view.kind === "planner" ? Math.max(view.run_end_s, view.plan?.duration_s ?? 0, 10) : openRange(view.run_end_s));

/** Spans of a time line without a planned end, in seconds: it grows by steps, so that the curve isn't squeezed all the time. */
const SPANS = [60, 120, 300, 600, 1200, 1800, 3600, 7200, 14_400, 28_800];

/** @param {number} end What was driven, s. */
const openRange = (end) => SPANS.find((span) => end <= 0.95 * span) ?? Math.ceil(end / 0.95 / 86_400) * 86_400;

/** @param {Float64Array} curve @param {number} range @param {View} view */
function drawCurve(curve, range, view) {
  const stride = 2 * Math.max(1, Math.ceil(curve.length / 2 / MOST_POINTS));
  const x = (/** @type {number} */ t) => ((t / range) * WIDTH).toFixed(1);
  const y = (/** @type {number} */ share) => (100 - 99 * share).toFixed(2);
  let line = `M0 ${y(0)}`;
  for (let i = 0; i + 1 < curve.length; i += stride) line += `L${x(curve[i] ?? 0)} ${y(curve[i + 1] ?? 0)}`;
  const end = curve.length >= 2 ? (curve[curve.length - 2] ?? 0) : 0;
  const reached = curve.length >= 2 ? (curve[curve.length - 1] ?? 0) : 0;
  line += `L${x(end)} ${y(reached)}`;
  setAttribute(byId("curve-line"), "d", line);
  setAttribute(byId("curve-area"), "d", `${line}V100H0Z`);
  const { plan } = view;
  const known = plan && plan.duration_s > 0 && view.state !== "planning";
  setAttribute(byId("curve-plan"), "d", known ? `M${x(plan.duration_s)} 0V100` : "M0 0");
  setAttribute(byId("curve-ahead"), "d", known && plan.duration_s > end ? `M${x(end)} ${y(reached)}L${x(plan.duration_s)} ${y(plan.coverage)}` : "M0 0");
  if (view.kind === "planner") setText(byId("timeline-plan"), known ? `plan: ${percent(plan.coverage)} % in ${clock(plan.duration_s)}` : "");
}

/** What stands where the plan would. @param {App} app */
function openEnd({ catalogue, view }) {
  const entry = catalogue.behaviours.find(({ id }) => id === view.algorithm);
  if (entry?.manual) return "no plan: you drive";
  return entry?.ends ? "no plan: stops by itself" : "no plan: runs until you pause";
}

/** @param {number} range */
function drawTicks(range) {
  if (!changed(byId("ticks"), "range", range)) return;
  const steps = [1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18000, 36000, 86400];
  const step = steps.find((s) => range / s <= 6) ?? range;
  const ticks = [];
  for (let t = 0; t < range * 0.97; t += step) {
    const tick = make("span", {}, clock(t));
    tick.style.setProperty("--at", String(t / range));
    ticks.push(tick);
  }
  byId("ticks").replaceChildren(...ticks);
}

/** @param {App} app */
function startScrubber(app) {
  const scrubber = byId("scrubber");
  /** @param {number} seconds */
  const seek = (seconds) => {
    if (app.view.can.seek) app.act((p) => p.seek(Math.max(0, Math.min(seconds, app.view.run_end_s))));
  };
  /** @param {PointerEvent} event */
  const seekTo = (event) => {
    const box = scrubber.getBoundingClientRect();
    seek(((event.clientX - box.left) / box.width) * rangeOf(app.view));
  };
  scrubber.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    scrubber.setPointerCapture(event.pointerId);
    seekTo(event);
  });
  scrubber.addEventListener("pointermove", (event) => {
    if (scrubber.hasPointerCapture(event.pointerId)) seekTo(event);
  });
  scrubber.addEventListener("keydown", (event) => {
    const { time_s, run_end_s } = app.view;
    const small = Math.max(1, rangeOf(app.view) / 200);
    /** @type {Record<string, number>} */
    const targets = {
      ArrowLeft: time_s - small,
      ArrowDown: time_s - small,
      ArrowRight: time_s + small,
      ArrowUp: time_s + small,
      PageDown: time_s - 10 * small,
      PageUp: time_s + 10 * small,
      Home: 0,
      End: run_end_s,
    };
    const target = targets[event.key];
    if (target === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    seek(target);
  });
}
