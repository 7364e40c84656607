// @ts-check
// The room of the latest run, laid out: many runs are made in it, and to lay it out takes as long as some minutes in it.

/** @typedef {import("../../../program.js").ProgramRunner} Runner */

export class Rooms {
  #ProgramRunner;
  /** @type {Uint8Array} */
  #job = new Uint8Array();
  /** Not in use, in the room of that job. @type {Runner | undefined} */
  #left;

  /** @param {typeof import("../../../program.js").ProgramRunner} ProgramRunner */
  constructor(ProgramRunner) {
    this.#ProgramRunner = ProgramRunner;
  }

  /** At the start. @param {Uint8Array} job @param {number} [seed] In place of the job's. @returns {Runner} */
  runner(job, seed) {
    const left = this.#left;
    this.#left = undefined;
    const isKnown = job.length === this.#job.length && job.every((byte, index) => byte === this.#job[index]);
    if (left && isKnown) return left.again(seed);
    left?.free();
    this.#job = job;
    return new this.#ProgramRunner(job, seed);
  }

  /** It is no longer in use. @param {Runner} runner */
  takeBack(runner) {
    this.#left?.free();
    this.#left = runner;
  }
}
