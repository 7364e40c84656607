// @ts-check
// What a program has printed and drawn.

/** @typedef {import("./types").Output} Output */

/** Most that is kept; the sandbox has limits of its own. */
const MOST = 25_000;

export class Said {
  /** In the order of time. @type {Output[]} */
  all = [];
  /** Changes with them. */
  version = 0;

  /** @param {unknown} output What the worker says. */
  keep(output) {
    if (!Array.isArray(output) || !output.length) return;
    const room = Math.max(0, MOST - this.all.length);
    this.all.push(...output.slice(0, room).filter((one) => typeof one?.kind === "string" && Number.isFinite(one.step)));
    this.version += 1;
  }

  /** What was printed last up to a step. @param {number} until @returns {Output | undefined} */
  printed(until) {
    return this.all.findLast(({ kind, step = 0 }) => kind === "print" && step <= until);
  }

  /** Forgets what comes after a step. @param {number} from */
  cut(from) {
    this.all = this.all.filter(({ step = 0 }) => step < from);
    this.version += 1;
  }
}
