// @ts-check
// Progress in lessons, kept in this browser.
import { download } from "../files.js";

/**
 * What was done in a lesson.
 * @typedef {object} Done
 * @property {Record<string, number>} predictions The options that were committed.
 * @property {Record<string, import("../types").GoalAnswer & { passed: boolean }>} goals
 * @property {Record<string, { answers: [number, string, boolean][] }>} quizzes Seeds, answers, whether they were right.
 * @property {number} hints How many hints are open.
 * @property {number} parts How many parts there are to do.
 */

const KEY = "lessons";

/** @type {Record<string, Done>} */
let memory = read();

/** @returns {Record<string, Done>} */
function read() {
  try {
    const kept = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return kept && typeof kept === "object" ? kept : {};
  } catch {
    return {};
  }
}

function write() {
  try {
    localStorage.setItem(KEY, JSON.stringify(memory));
  } catch {
    // Without storage, progress lasts as long as the page.
  }
}

/** @returns {Done} */
export const nothing = () => ({ predictions: {}, goals: {}, quizzes: {}, hints: 0, parts: 0 });

/** What was done in a lesson; changes are kept by `keep`. @param {string} key @returns {Done} */
export function done(key) {
  return (memory[key] = { ...nothing(), ...memory[key] });
}

export const keep = write;

/** How far a lesson is: `[done, parts]`. @param {string} key @returns {[number, number]} */
export function progress(key) {
  const state = memory[key];
  if (!state) return [0, 0];
  const goals = Object.values(state.goals).filter(({ passed }) => passed).length;
  const quizzes = Object.values(state.quizzes).filter(({ answers }) => answers.some(([, , right]) => right)).length;
  return [Math.min(goals + quizzes + Object.keys(state.predictions).length, state.parts), state.parts];
}

export function exportAll() {
  download("lessons-progress.json", JSON.stringify(memory, null, 1), "application/json");
}

export function clearAll() {
  memory = {};
  try {
    localStorage.removeItem(KEY);
  } catch {
    // There was nothing to clear.
  }
}
