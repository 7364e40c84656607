// @ts-check
// Play, step, speed, and the time line whose scrubber is the curve of coverage over time.
import { byId, changed, setAttribute, setText } from "../dom.js";
import { clock, percent } from "../format.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { startTimeLine, startTransport, through } from "../shared/time-line.js";

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

/** @param {App} app @returns {{ update(view: View): void, key(key: string): boolean }} */
export function startPlaybar(app) {
  const { act, catalogue } = app;
  const transport = startTransport("", catalogue.speeds, {
    toggle: () => act((p) => (app.view.can.pause ? p.pause() : p.play())),
    step: () => act((p) => p.step()),
    reset: () => act((p) => p.reset()),
    speed: (text) => act((p) => p.set_speed(Number(text))),
  });
  const look = () => ({ at: app.view.time_s, end: app.view.run_end_s, range: rangeOf(app.view), canSeek: app.view.can.seek });
  const showTime = startTimeLine("", look, (seconds) => act((p) => p.seek(seconds)));
  const isDue = atMostEvery(REDRAW);

  return {
    update(view) {
      const { can } = view;
      transport.update({ ...can, play: can.play || can.pause }, can.pause, view.speed);
      const range = rangeOf(view);
      const extent = `${view.run_end_s} ${range} ${view.plan?.coverage} ${view.algorithm}`;
      if (isDue(() => changed(byId("curve-line"), "extent", extent))) {
        drawCurve(app.playground.coverage_curve(), range, view);
        if (view.kind === "behaviour") setText(byId("timeline-plan"), openEnd(app));
      }
      byId("playhead").style.setProperty("--coverage", String(view.coverage));
      // Read aloud at every change, so only while it stands still or is moved by hand.
      showTime(view.state === "playing" && document.activeElement === byId("scrubber"), `${clock(view.time_s)}, ${percent(view.coverage)} % covered`);
    },
    key: transport.key,
  };
}

/** Range of the time line, s: the plan's duration, or the simulated time if that is longer; without a plan, with a
 * margin. @param {View} view */
const rangeOf = (view) => (view.kind === "planner" ? Math.max(view.run_end_s, view.plan?.duration_s ?? 0, 10) : openRange(view.run_end_s));

/** Spans of a time line without a planned end, in seconds: it grows by steps, so that the curve isn't squeezed all the time. */
const SPANS = [60, 120, 300, 600, 1200, 1800, 3600, 7200, 14_400, 28_800];

/** @param {number} end Simulated time, s. */
const openRange = (end) => SPANS.find((span) => end <= 0.95 * span) ?? Math.ceil(end / 0.95 / 86_400) * 86_400;

/** @param {Float64Array} curve @param {number} range @param {View} view */
function drawCurve(curve, range, view) {
  const stride = 2 * Math.max(1, Math.ceil(curve.length / 2 / MOST_POINTS));
  const x = (/** @type {number} */ t) => (t / range) * WIDTH;
  const y = (/** @type {number} */ share) => 100 - 99 * share;
  /** @type {[x: number, y: number][]} */
  const points = [[0, 100]];
  for (let i = 0; i + 1 < curve.length; i += stride) points.push([x(curve[i] ?? 0), y(curve[i + 1] ?? 0)]);
  const [end, reached] = [curve.at(-2) ?? 0, curve.at(-1) ?? 0];
  const line = through([...points, [x(end), y(reached)]]);
  setAttribute(byId("curve-line"), "d", line);
  setAttribute(byId("curve-area"), "d", `${line}V100H0Z`);
  const { plan } = view;
  const known = plan && plan.duration_s > 0 && view.state !== "planning";
  setAttribute(byId("curve-plan"), "d", known ? `M${x(plan.duration_s)} 0V100` : "M0 0");
  setAttribute(byId("curve-ahead"), "d", known && plan.duration_s > end ? `M${x(end)} ${y(reached)}L${x(plan.duration_s)} ${y(plan.coverage)}` : "M0 0");
  if (view.kind === "planner") setText(byId("timeline-plan"), known ? `plan: ${percent(plan.coverage)} % in ${clock(plan.duration_s)}` : "");
}

/** The text in place of the plan. @param {App} app */
function openEnd({ catalogue, view }) {
  const entry = catalogue.behaviours.find(({ id }) => id === view.algorithm);
  if (entry?.manual) return "no plan: you drive";
  return entry?.ends ? "no plan: stops by itself" : "no plan: runs until you pause";
}
