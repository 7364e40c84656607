// @ts-check
// Play, step, back, speed, and a time line: for every run that is shown once more, or faster.
import { button, byId, changed, fill, make, select, setAttribute, setEnabled } from "../dom.js";
import { clock } from "../format.js";

/** Times between ticks, s. */
const TICKS = [1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18_000, 36_000, 86_400];

/** @param {HTMLSelectElement} into @param {number[]} speeds Times real time; 0 for as fast as it goes. */
export const fillSpeeds = (into, speeds) => fill(into, speeds.map((x) => [String(x), x === 0 ? "max" : `${x}×`]));

/**
 * The buttons of a play bar, and its speed.
 * @param {string} prefix Of their ids.
 * @param {number[]} speeds
 * @param {{ toggle(): unknown, step(): unknown, reset(): unknown, speed(text: string): unknown }} deeds
 */
export function startTransport(prefix, speeds, deeds) {
  const [play, step, reset, speed] = [button(`${prefix}play`), button(`${prefix}step`), button(`${prefix}reset`), select(`${prefix}speed`)];
  let can = { play: false, step: false, reset: false };
  fillSpeeds(speed, speeds);
  speed.disabled = false;
  speed.addEventListener("change", () => deeds.speed(speed.value));
  const keys = { " ": () => can.play && deeds.toggle(), ".": () => can.step && deeds.step(), r: () => can.reset && deeds.reset() };
  [play, step, reset].forEach((node, index) => node.addEventListener("click", Object.values(keys)[index] ?? null));
  return {
    /** @param {typeof can} now @param {boolean} isRunning @param {number} [pace] @param {string} [begin] The label of
     * the button while it doesn't run. */
    update(now, isRunning, pace, begin = "Play") {
      can = now;
      setEnabled(play, can.play);
      setEnabled(step, can.step);
      setEnabled(reset, can.reset);
      if (changed(play, "running", isRunning)) {
        const name = isRunning ? "Pause" : begin;
        play.setAttribute("aria-label", name);
        play.title = `${name} (space)`;
        byId(`${prefix}play-icon`).setAttribute("href", isRunning ? "#i-pause" : "#i-play");
      }
      if (pace !== undefined && changed(speed, "speed", pace)) speed.value = String(pace);
    },
    /** Space, full stop and R. @param {string} key */
    key(key) {
      const deed = /** @type {Record<string, () => unknown>} */ (keys)[key];
      deed?.();
      return Boolean(deed);
    },
  };
}

/**
 * @typedef {object} Time
 * @property {number} at Time shown, s.
 * @property {number} end Time that the run has come to, s.
 * @property {number} range What the line spans, s.
 * @property {boolean} canSeek
 */

/**
 * A slider over a curve, with ticks below.
 * @param {string} prefix Of their ids. @param {() => Time} look @param {(seconds: number) => void} seek
 * @returns {(isQuiet: boolean, words: string) => void} To be called with every view: whether it isn't to be read aloud, and how.
 */
export function startTimeLine(prefix, look, seek) {
  const scrubber = byId(`${prefix}scrubber`);
  const go = (/** @type {number} */ seconds) => {
    const { end, canSeek } = look();
    if (canSeek) seek(Math.max(0, Math.min(seconds, end)));
  };
  const follow = (/** @type {PointerEvent} */ event) => {
    const box = scrubber.getBoundingClientRect();
    go(((event.clientX - box.left) / box.width) * look().range);
  };
  scrubber.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    scrubber.setPointerCapture(event.pointerId);
    follow(event);
  });
  scrubber.addEventListener("pointermove", (event) => scrubber.hasPointerCapture(event.pointerId) && follow(event));
  scrubber.addEventListener("keydown", (event) => {
    const { at, end, range } = look();
    const small = Math.max(1, range / 200);
    /** @type {Record<string, number>} */
    const targets = { ArrowLeft: at - small, ArrowDown: at - small, ArrowRight: at + small, ArrowUp: at + small, PageDown: at - 10 * small, PageUp: at + 10 * small, Home: 0, End: end };
    const target = targets[event.key];
    if (target === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    go(target);
  });
  // As many ticks as there is room for.
  let [span, width] = [0, 0];
  const showTicks = () => byId(`${prefix}ticks`).replaceChildren(...ticks(span, width));
  new ResizeObserver(([entry]) => {
    width = entry?.contentRect.width ?? 0;
    if (span > 0) showTicks();
  }).observe(scrubber);
  return (isQuiet, words) => {
    const { at, end, range, canSeek } = look();
    scrubber.style.setProperty("--at", String(at / range));
    setAttribute(scrubber, "aria-disabled", String(!canSeek));
    setAttribute(scrubber, "aria-valuemax", String(Math.floor(end)));
    if (!isQuiet) {
      setAttribute(scrubber, "aria-valuenow", String(Math.floor(at)));
      setAttribute(scrubber, "aria-valuetext", words);
    }
    if (span !== range) {
      span = range;
      showTicks();
    }
  };
}

/** Most ticks, and the width of a character of their text, px. */
const [MOST_TICKS, CHARACTER] = [6, 6];

/** @param {number} range s. @param {number} width Of the line, px. */
function ticks(range, width) {
  const most = Math.max(2, Math.min(MOST_TICKS, Math.floor(width / (CHARACTER * (clock(range).length + 1)))));
  const step = TICKS.find((s) => range / s <= most) ?? range;
  return Array.from({ length: Math.ceil((range * 0.97) / step) }, (_, i) => {
    const tick = make("span", {}, clock(i * step));
    tick.style.setProperty("--at", String((i * step) / range));
    return tick;
  });
}

/** A line through points; none where there is no number. @param {Iterable<[x: number, y: number]>} points */
export function through(points) {
  let line = "";
  let isDown = false;
  for (const [x, y] of points) {
    if (!Number.isNaN(y)) line += `${isDown ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
    isDown = !Number.isNaN(y);
  }
  return line;
}
