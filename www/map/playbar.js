// @ts-check
// Time: play, step, speed, and the time line with the share of the boundary that is mapped; of a robot that is lost on a map,
// with how far off it is.
import { button, byId, changed, fill, make, select, setAttribute, setEnabled, setText } from "../dom.js";
import { clock, pace, percent } from "../format.js";

/** Shortest time line, s. */
const SHORTEST = 300;
/** Milliseconds between redraws of the curve. */
const REDRAW = 200;

/** @param {import("./tab.js").MapTab} it */
export function startPlaybar(it) {
  const { act } = it;
  const isMoving = () => ["playing", "seeking"].includes(it.view.phase);
  button("map-play").addEventListener("click", () => {
    if (it.view.can.pause) act((s) => s.pause());
    else if (it.view.can.play) act((s) => s.play());
  });
  button("map-hint-play").addEventListener("click", () => {
    act((s) => s.play());
    button("map-play").focus();
  });
  button("map-step").addEventListener("click", () => it.view.can.step && act((s) => s.step()));
  button("map-reset").addEventListener("click", () => it.view.can.seek && act((s) => s.seek(0)));
  fill(select("map-speed"), it.app.catalogue.speeds.map((x) => [String(x), x === 0 ? "max" : `${x}×`]));
  select("map-speed").addEventListener("change", () => it.set("pace", select("map-speed").value));
  startScrubber(it);
  let drawn = 0;
  /** Upper end of the scale of errors, m. */
  let top = 0.1;

  /** @param {import("../types").MapView} view */
  return (view) => {
    const { can } = view;
    setEnabled(button("map-play"), can.play || can.pause);
    setEnabled(button("map-step"), can.step);
    setEnabled(button("map-reset"), can.seek);
    const running = isMoving();
    if (changed(button("map-play"), "running", running)) {
      const name = running ? "Pause" : "Play";
      button("map-play").setAttribute("aria-label", name);
      button("map-play").title = `${name} (space)`;
      byId("map-play-icon").setAttribute("href", running ? "#i-pause" : "#i-play");
    }
    if (changed(select("map-speed"), "speed", view.speed)) select("map-speed").value = String(view.speed);
    // What was asked for and isn't reached is worth a word.
    const reached = view.speed_factor;
    const isSlow = view.phase === "playing" && reached > 0 && (view.speed === 0 || reached < 0.9 * view.speed);
    setText(byId("map-pace"), isSlow ? pace(reached) : "");
    const range = rangeOf(view);
    const scrubber = byId("map-scrubber");
    scrubber.style.setProperty("--at", String(view.time_s / range));
    const isLost = view.known !== null;
    setAttribute(scrubber, "aria-disabled", String(!can.seek));
    setAttribute(scrubber, "aria-valuemax", view.end_s.toFixed(0));
    if (!running) {
      setAttribute(scrubber, "aria-valuenow", view.time_s.toFixed(0));
      setAttribute(scrubber, "aria-valuetext", `${clock(view.time_s)}, ${isLost ? off(view) : `${percent(view.figures?.boundary ?? 0, 0)} % of the boundary mapped`}`);
    }
    const now = performance.now();
    const is = `${view.samples} ${view.version} ${range} ${view.end_s} ${isLost}`;
    if ((now - drawn > REDRAW || !running) && changed(scrubber, "curve", is)) {
      drawn = now;
      const curve = it.session.curve();
      top = drawDrift(curve, view.end_s);
      if (isLost) drawError(curve, range, top);
      else drawBoundary(curve, range);
      setText(byId("map-curve-name"), isLost ? "Position error over time; shaded while it is lost" : "Boundary mapped over time");
      setText(byId("map-curve-top"), isLost ? length(top) : "100 %");
      drawTicks(range);
    }
    const height = isLost ? (view.figures?.position_m ?? top) / top : (view.figures?.boundary ?? 0);
    scrubber.style.setProperty("--coverage", String(Math.min(height, 1)));
  };
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
  return error === null || error === undefined ? "lost" : `off by ${error < 1 ? `${(100 * error).toFixed(0)} cm` : `${error.toFixed(2)} m`}`;
}

/** @param {number} metres */
const length = (metres) => (metres < 1 ? `${metres * 100} cm` : `${metres} m`);

/** The samples of a curve. @param {Float64Array} curve Four numbers a sample. @returns {[time: number, boundary: number, here: number, odometry: number][]} */
const samples = (curve) => Array.from({ length: curve.length / 4 }, (_, i) => [curve[4 * i] ?? 0, curve[4 * i + 1] ?? 0, curve[4 * i + 2] ?? NaN, curve[4 * i + 3] ?? NaN]);

/** A line through points; none where there is no number. @param {[x: number, y: number][]} points */
function through(points) {
  let line = "";
  let isDown = false;
  for (const [x, y] of points) {
    if (!Number.isNaN(y)) line += `${isDown ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
    isDown = !Number.isNaN(y);
  }
  return line;
}

/** @param {Float64Array} curve @param {number} range */
function drawBoundary(curve, range) {
  const points = samples(curve).map(([time, boundary]) => /** @type {[number, number]} */ ([(1000 * time) / range, 99.5 - 99 * boundary]));
  const line = through([[0, 99.5], ...points]);
  setAttribute(byId("map-curve"), "d", line);
  setAttribute(byId("map-area"), "d", `${line}L${points.at(-1)?.[0] ?? 0} 100L0 100Z`);
  setAttribute(byId("map-astray"), "d", "");
}

/** The error of a robot that is lost on a map, and when it had no idea. @param {Float64Array} curve @param {number} range @param {number} top */
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
  const top = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50].find((limit) => limit >= most) ?? 100;
  const across = (/** @type {number} */ time) => (1000 * time) / Math.max(end, 1);
  setAttribute(byId("map-drift-here"), "d", through(all.map(([time, , here]) => [across(time), 100 - (100 * here) / top])));
  setAttribute(byId("map-drift-odometry"), "d", through(all.map(([time, , , odometry]) => [across(time), 100 - (100 * odometry) / top])));
  setText(byId("map-drift-top"), length(top));
  setText(byId("map-drift-end"), clock(end));
  return top;
}

/** @param {number} range */
function drawTicks(range) {
  if (!changed(byId("map-ticks"), "range", range)) return;
  const step = [60, 120, 300, 600, 900, 1800, 3600, 7200, 18_000, 36_000].find((s) => range / s <= 6) ?? range;
  const ticks = [];
  for (let t = 0; t < range * 0.97; t += step) {
    const tick = make("span", {}, clock(t));
    tick.style.setProperty("--at", String(t / range));
    ticks.push(tick);
  }
  byId("map-ticks").replaceChildren(...ticks);
}

/** @param {import("./tab.js").MapTab} it */
function startScrubber(it) {
  const scrubber = byId("map-scrubber");
  /** @param {number} seconds */
  const seek = (seconds) => {
    if (it.view.can.seek) it.act((s) => s.seek(Math.max(0, Math.min(seconds, it.view.end_s))));
  };
  /** @param {PointerEvent} event */
  const seekTo = (event) => {
    const box = scrubber.getBoundingClientRect();
    seek(((event.clientX - box.left) / box.width) * rangeOf(it.view));
  };
  scrubber.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    scrubber.setPointerCapture(event.pointerId);
    seekTo(event);
  });
  scrubber.addEventListener("pointermove", (event) => scrubber.hasPointerCapture(event.pointerId) && seekTo(event));
  scrubber.addEventListener("keydown", (event) => {
    const { time_s, end_s } = it.view;
    const small = Math.max(1, rangeOf(it.view) / 200);
    /** @type {Record<string, number>} */
    const targets = { ArrowLeft: time_s - small, ArrowDown: time_s - small, ArrowRight: time_s + small, ArrowUp: time_s + small, PageDown: time_s - 10 * small, PageUp: time_s + 10 * small, Home: 0, End: end_s };
    const target = targets[event.key];
    if (target === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    seek(target);
  });
}
