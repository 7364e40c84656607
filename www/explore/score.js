// @ts-check
// The parts of a game's card, and what a run had swept at a time.
import { make, setText } from "../dom.js";

/** @param {string} label @param {HTMLElement} control @param {string} [className] */
export const labelled = (label, control, className = "field") => make("label", { className }, make("span", { className: "label" }, label), control);

/** A row of the score. @param {string} who @param {string} name */
export function scoreRow(who, name) {
  const [bar, value] = [make("i"), make("b", {}, "")];
  const show = (/** @type {number} */ next, /** @type {string} */ text) => {
    bar.style.setProperty("--share", String(next));
    setText(value, text);
  };
  return { nodes: [make("span", {}, name), make("span", { className: `meter ${who}`, "aria-hidden": "true" }, bar), value], show };
}

/** The share that a run had swept after so many seconds, 0 to 1. @param {Float64Array} curve Times, s, each with the share. @param {number} seconds */
export function sweptAt(curve, seconds) {
  let [before, reached] = [0, 0];
  for (let i = 0; i + 1 < curve.length; i += 2) {
    const [time, share] = [curve[i] ?? 0, curve[i + 1] ?? 0];
    if (time > seconds) return reached + ((share - reached) * (seconds - before)) / (time - before);
    [before, reached] = [time, share];
  }
  return reached;
}
