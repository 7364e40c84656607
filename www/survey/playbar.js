// @ts-check
// Time: play, step, speed, and the time line with the share of the boundary that is mapped.
import { button, byId, changed, fill, make, select, setAttribute, setEnabled, setText } from "../dom.js";
import { clock, pace, percent } from "../format.js";

/** Shortest time line, s. */
const SHORTEST = 300;
/** Milliseconds between redraws of the curve. */
const REDRAW = 200;

/** @param {import("./place.js").Surveying} it */
export function startPlaybar(it) {
  const { act } = it;
  const isMoving = () => ["playing", "seeking"].includes(it.view.phase);
  button("survey-play").addEventListener("click", () => {
    if (it.view.can.pause) act((s) => s.pause());
    else if (it.view.can.play) act((s) => s.play());
  });
  button("survey-hint-play").addEventListener("click", () => {
    act((s) => s.play());
    button("survey-play").focus();
  });
  button("survey-step").addEventListener("click", () => it.view.can.step && act((s) => s.step()));
  button("survey-reset").addEventListener("click", () => it.view.can.seek && act((s) => s.seek(0)));
  fill(select("survey-speed"), it.app.catalogue.speeds.map((x) => [String(x), x === 0 ? "max" : `${x}×`]));
  select("survey-speed").addEventListener("change", () => it.set("pace", select("survey-speed").value));
  startScrubber(it);
  let drawn = 0;

  /** @param {import("./types").SurveyView} view */
  return (view) => {
    const { can } = view;
    setEnabled(button("survey-play"), can.play || can.pause);
    setEnabled(button("survey-step"), can.step);
    setEnabled(button("survey-reset"), can.seek);
    const running = isMoving();
    if (changed(button("survey-play"), "running", running)) {
      const name = running ? "Pause" : "Let it drive";
      button("survey-play").setAttribute("aria-label", name);
      button("survey-play").title = `${name} (space)`;
      byId("survey-play-icon").setAttribute("href", running ? "#i-pause" : "#i-play");
    }
    if (changed(select("survey-speed"), "speed", view.speed)) select("survey-speed").value = String(view.speed);
    // What was asked for and isn't reached is worth a word.
    const reached = view.speed_factor;
    const isSlow = view.phase === "playing" && reached > 0 && (view.speed === 0 || reached < 0.9 * view.speed);
    setText(byId("survey-pace"), isSlow ? pace(reached) : "");
    const range = rangeOf(view);
    const scrubber = byId("survey-scrubber");
    scrubber.style.setProperty("--at", String(view.time_s / range));
    scrubber.style.setProperty("--coverage", String(view.figures?.boundary ?? 0));
    setAttribute(scrubber, "aria-disabled", String(!can.seek));
    setAttribute(scrubber, "aria-valuemax", view.end_s.toFixed(0));
    if (!running) {
      setAttribute(scrubber, "aria-valuenow", view.time_s.toFixed(0));
      setAttribute(scrubber, "aria-valuetext", `${clock(view.time_s)}, ${percent(view.figures?.boundary ?? 0, 0)} % of the boundary mapped`);
    }
    const now = performance.now();
    const is = `${view.samples} ${view.version} ${range} ${view.end_s}`;
    if ((now - drawn > REDRAW || !running) && changed(scrubber, "curve", is)) {
      drawn = now;
      drawCurves(it.survey.curve(), range, view.end_s);
      drawTicks(range);
    }
  };
}

/** Length of the time line, s: it grows by a third when it is full. @param {import("./types").SurveyView} view */
export function rangeOf(view) {
  let range = SHORTEST;
  while (view.end_s > range) range = Math.ceil((range * 4) / 180) * 60;
  return range;
}

/** @param {Float64Array} curve Four numbers a sample. @param {number} range @param {number} end Time that the run has come to, s. */
function drawCurves(curve, range, end) {
  const x = (/** @type {number} */ time) => ((1000 * time) / range).toFixed(1);
  let boundary = "M0 99.5";
  let most = 0.1;
  for (let i = 0; i < curve.length; i += 4) {
    boundary += `L${x(curve[i] ?? 0)} ${(99.5 - 99 * (curve[i + 1] ?? 0)).toFixed(1)}`;
    most = Math.max(most, curve[i + 2] || 0, curve[i + 3] || 0);
  }
  setAttribute(byId("survey-curve"), "d", boundary);
  const last = curve.length >= 4 ? x(curve[curve.length - 4] ?? 0) : "0";
  setAttribute(byId("survey-area"), "d", `${boundary}L${last} 100L0 100Z`);
  // Drift, beside, with scales that hold all of it: it ends where the clock is, or was last.
  const span = Math.max(end, 1);
  const across = (/** @type {number} */ time) => ((1000 * time) / span).toFixed(1);
  const top = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50].find((limit) => limit >= most) ?? 100;
  for (const [id, at] of /** @type {const} */ ([["survey-drift-here", 2], ["survey-drift-odometry", 3]])) {
    let line = "";
    let isDown = false;
    for (let i = 0; i < curve.length; i += 4) {
      const error = curve[i + at] ?? NaN;
      // While it has no idea where it is, there is no line.
      if (!Number.isNaN(error)) line += `${isDown ? "L" : "M"}${across(curve[i] ?? 0)} ${(100 - (100 * error) / top).toFixed(1)}`;
      isDown = !Number.isNaN(error);
    }
    setAttribute(byId(id), "d", line);
  }
  setText(byId("survey-drift-top"), top < 1 ? `${top * 100} cm` : `${top} m`);
  setText(byId("survey-drift-end"), clock(end));
}

/** @param {number} range */
function drawTicks(range) {
  if (!changed(byId("survey-ticks"), "range", range)) return;
  const step = [60, 120, 300, 600, 900, 1800, 3600, 7200, 18_000, 36_000].find((s) => range / s <= 6) ?? range;
  const ticks = [];
  for (let t = 0; t < range * 0.97; t += step) {
    const tick = make("span", {}, clock(t));
    tick.style.setProperty("--at", String(t / range));
    ticks.push(tick);
  }
  byId("survey-ticks").replaceChildren(...ticks);
}

/** @param {import("./place.js").Surveying} it */
function startScrubber(it) {
  const scrubber = byId("survey-scrubber");
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
