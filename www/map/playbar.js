// @ts-check
// Time: play, step, speed, and the time line with the share of the boundary that is mapped; of a robot that is lost on a map,
// with how far off it is.
import { button, byId, changed, setAttribute, setText } from "../dom.js";
import { clock, pace, percent, smallLength } from "../format.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { startTimeLine, startTransport, through } from "../shared/time-line.js";

/** Shortest time line, s. */
const SHORTEST = 300;
/** Milliseconds between redraws of the curve. */
const REDRAW = 200;

/** @param {import("./tab.js").MapTab} it */
export function startPlaybar(it) {
  const { act } = it;
  const isMoving = () => ["playing", "seeking"].includes(it.view.phase);
  const transport = startTransport("map-", it.app.catalogue.speeds, {
    toggle: () => act((s) => (it.view.can.pause ? s.pause() : s.play())),
    step: () => act((s) => s.step()),
    reset: () => act((s) => s.seek(0)),
    speed: (text) => it.set("pace", text),
  });
  button("map-hint-play").addEventListener("click", () => {
    act((s) => s.play());
    button("map-play").focus();
  });
  const look = () => ({ at: it.view.time_s, end: it.view.end_s, range: rangeOf(it.view), canSeek: it.view.can.seek });
  const showTime = startTimeLine("map-", look, (seconds) => act((s) => s.seek(seconds)));
  const isDue = atMostEvery(REDRAW);
  /** Upper end of the scale of errors, m. */
  let top = 0.1;

  const update = (/** @type {import("../types").MapView} */ view) => {
    const { can } = view;
    const running = isMoving();
    transport.update({ ...can, play: can.play || can.pause, reset: can.seek }, running, view.speed);
    // A requested speed that isn't reached is mentioned.
    const reached = view.speed_factor;
    const isSlow = view.phase === "playing" && reached > 0 && (view.speed === 0 || reached < 0.9 * view.speed);
    setText(byId("map-pace"), isSlow ? pace(reached) : "");
    const range = rangeOf(view);
    const isLost = view.known !== null;
    showTime(running, `${clock(view.time_s)}, ${isLost ? off(view) : `${percent(view.figures?.boundary ?? 0)} % of the boundary mapped`}`);
    const is = `${view.grid} ${view.samples} ${view.version} ${range} ${view.end_s} ${isLost}`;
    if (isDue(() => changed(byId("map-curve"), "curve", is), !running)) {
      const curve = it.session.curve();
      top = drawDrift(curve, view.end_s);
      if (isLost) drawError(curve, range, top);
      else drawBoundary(curve, range);
      setText(byId("map-curve-name"), isLost ? "Position error over time; shaded where it has no estimate" : "Boundary mapped over time");
      setText(byId("map-curve-top"), isLost ? length(top) : "100 %");
    }
    const height = isLost ? (view.figures?.position_m ?? top) / top : (view.figures?.boundary ?? 0);
    byId("map-scrubber").style.setProperty("--coverage", String(Math.min(height, 1)));
  };
  return { update, key: transport.key };
}

/** Length of the time line, s: it grows by a third when it is full. @param {import("../types").MapView} view */
export function rangeOf(view) {
  let range = SHORTEST;
  while (view.end_s > range) range = Math.ceil((range * 4) / 180) * 60;
  return range;
}

/** How far off it is, in words. @param {import("../types").MapView} view */
function off({ figures }) {
  const error = figures?.position_m;
  return error === null || error === undefined ? "lost" : `off by ${smallLength(error)}`;
}

/** @param {number} metres */
const length = (metres) => (metres < 1 ? `${metres * 100} cm` : `${metres} m`);

/** The samples of a curve. @param {Float64Array} curve Four numbers a sample. @returns {[time: number, boundary: number, here: number, odometry: number][]} */
const samples = (curve) => Array.from({ length: curve.length / 4 }, (_, i) => [curve[4 * i] ?? 0, curve[4 * i + 1] ?? 0, curve[4 * i + 2] ?? NaN, curve[4 * i + 3] ?? NaN]);

/** @param {Float64Array} curve @param {number} range */
function drawBoundary(curve, range) {
  const points = samples(curve).map(([time, boundary]) => /** @type {[number, number]} */ ([(1000 * time) / range, 99.5 - 99 * boundary]));
  const line = through([[0, 99.5], ...points]);
  setAttribute(byId("map-curve"), "d", line);
  setAttribute(byId("map-area"), "d", `${line}L${points.at(-1)?.[0] ?? 0} 100L0 100Z`);
  setAttribute(byId("map-astray"), "d", "");
}

/** The error of a robot that is lost on a map, and when it had no estimate. @param {Float64Array} curve @param {number} range @param {number} top */
function drawError(curve, range, top) {
  const points = samples(curve).map(([time, , here]) => /** @type {[number, number]} */ ([(1000 * time) / range, 99.5 - (99 * here) / top]));
  setAttribute(byId("map-curve"), "d", through(points));
  setAttribute(byId("map-area"), "d", "");
  const astray = points.map(([x, y], i) => (Number.isNaN(y) ? `M${(points[i - 1]?.[0] ?? 0).toFixed(1)} 0H${x.toFixed(1)}V100H${(points[i - 1]?.[0] ?? 0).toFixed(1)}Z` : ""));
  setAttribute(byId("map-astray"), "d", astray.join(""));
}

/** Drift, beside, with scales that hold all of it: it ends where the clock is, or was last. @param {Float64Array} curve @param {number} end Time that the run has come to, s. */
function drawDrift(curve, end) {
  const all = samples(curve);
  const most = Math.max(0.1, ...all.flatMap(([, , here, odometry]) => [here || 0, odometry || 0]));
  const top = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500].find((limit) => limit >= most) ?? most;
  const across = (/** @type {number} */ time) => (1000 * time) / Math.max(end, 1);
  setAttribute(byId("map-drift-here"), "d", through(all.map(([time, , here]) => [across(time), 100 - (100 * here) / top])));
  setAttribute(byId("map-drift-odometry"), "d", through(all.map(([time, , , odometry]) => [across(time), 100 - (100 * odometry) / top])));
  setText(byId("map-drift-top"), length(top));
  setText(byId("map-drift-end"), clock(end));
  return top;
}
