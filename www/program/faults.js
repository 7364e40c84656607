// @ts-check
// Why a program has ended early, in words.

/**
 * @typedef {{ message: string, line: number, column?: number, step: number, isEarly?: boolean }} Fault It is early before the program is on the floor.
 * @typedef {import("./types").FromWorker} FromWorker
 */

/** What the worker says, of which nothing is sure. @param {Extract<FromWorker, { type: "failed" }>} said @returns {Fault} */
export function faultOf({ message, line, column, step }) {
  return { message: String(message).slice(0, 2000), line: Number(line) || 0, column: Number(column) || 0, step: Number(step) || 0 };
}

/** Its worker was ended. @param {import("./hired.js").Why} why @param {string} text @param {number} step @returns {Fault} */
export function endOf(why, text, step) {
  const message = {
    silent: "A step of the program took too long and was ended. Drive a little in each step, and make sure that loops end.",
    loud: "The program sent too much at a time and was ended.",
    broken: `The program's worker broke down (${text}). It may have used too much memory.`,
    memory: "The program crashed the process that runs it, probably by using too much memory. Don't let lists or texts grow without end.",
  }[why];
  return { message, line: 0, step };
}
