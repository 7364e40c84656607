// @ts-check
// Programs of users, in a worker or in node: the same interface for both languages. docs/programs.md describes it.
import { loadJavaScript } from "./javascript.js";
import { loadPython } from "./python.js";

export { SourceError } from "./words.js";

/** @typedef {import("./robot.js").Facts} Facts */
/** @typedef {import("./robot.js").Layout} Layout */
/**
 * @typedef {object} Options
 * @property {"python" | "javascript"} language
 * @property {string} source
 * @property {string} [name] name of its file, for messages
 * @property {Facts} facts of the robot
 * @property {number} seed of its random numbers: a whole number from 0 to 2^53 - 1
 * @property {Layout} layout where its readings are
 * @property {{wasm: BufferSource | WebAssembly.Module, files: Record<string, string>}} [micropython] for Python: what
 *   scripts/micropython.mjs writes, and the package: paths in programs/python with their texts
 * @property {any} [parser] for JavaScript: the one of `@lezer/javascript`; mistakes then have a line, and it can be traced
 * @property {boolean} [traced] keeps the line; needed for `budget` and `breakpoints`; takes about twice the time
 * @property {number} [budget] turns of loops in one step (in JavaScript: statements), after which it counts as endless
 * @property {{line: number, condition?: string}[]} [breakpoints]
 * @property {number} [memory] the most that Python may use, MB
 * @property {(text: string) => any} [evaluate] makes JavaScript of text, elsewhere than here
 * @property {typeof import("./robot.js").Base} [Robot] its class, if there is one already
 * @property {() => void} [begins] called when all is ready, before the program's first line runs
 */
/**
 * @typedef {object} Program
 * @property {"step" | "run" | "plan"} kind
 * @property {number} left command for the left wheel, whole mm/s
 * @property {number} right
 * @property {number} line that was begun last; 0 if it isn't traced
 * @property {Record<string, any>[]} output what it has said, to be emptied by the caller
 * @property {(readings: Float64Array) => boolean} step one step with new readings; false once it is done
 * @property {() => number} [hold] for how many further steps its command surely stays, unless the robot gets blocked
 * @property {(steps: number) => void} [skip] so many steps went by in such a time
 * @property {() => [name: string, text: string, type: string][]} variables
 * @property {() => any} save its state, or undefined if it has to be replayed
 * @property {(state: any) => void} restore
 * @property {(room: {rows: string[], cell: number, start: number[]}) => IterableIterator<[number, number]>} plan
 */

/** Loads a program; throws a SourceError for a mistake in it. @param {Options} options @returns {Promise<Program>} */
export async function load(options) {
  return options.language === "python" ? loadPython(options) : loadJavaScript(options);
}
