// @ts-check
// The line of an endless loop in a program that drives a robot: what it had read is given to it again, followed line by line.
import { THINKING } from "./doubt.js";
import { kitFor } from "./kit.js";
import { Inmate } from "./sandbox.js";

/**
 * @typedef {import("./types").ToWorker} ToWorker
 * @typedef {import("./types").FromWorker} FromWorker
 */

/** Most readings that are kept: ten minutes of them. */
const MOST = 40_000;
/** Readings in a message: the worker may not be silent for long, and may not say much. */
const PART = 1000;

/** What a program was given, from its first step on. */
export class Given {
  /** @type {Float64Array[]} */
  #readings = [];
  #isWhole = true;

  /** @param {Float64Array} readings */
  keep(readings) {
    if (this.#readings.length < MOST) this.#readings.push(readings.slice());
    else {
      this.#readings = [];
      this.#isWhole = false;
    }
  }

  /**
   * Gives it all again to the same program.
   * @param {Extract<ToWorker, { type: "load" }>} load
   * @returns {Promise<Extract<FromWorker, { type: "failed" }> | undefined>} How it ends then; nothing if no step is endless, or it isn't known.
   */
  async again(load) {
    if (!this.#isWhole) return undefined;
    const kit = await kitFor(load.language);
    return new Promise((resolve) => {
      let next = 0;
      /** @param {Extract<FromWorker, { type: "failed" }>} [failure] */
      const end = (failure) => {
        mine.end();
        resolve(failure);
      };
      const mine = new Inmate(
        kit,
        (message) => {
          if (!("id" in Object(message)) || /** @type {{ id: number }} */ (message).id !== load.id) return;
          if (message.type === "failed") return end(message);
          if (message.type !== "loaded" && message.type !== "drive") return;
          const before = this.#readings.slice(next, (next += PART));
          const readings = before.pop();
          if (readings) mine.ask({ type: "sense", id: load.id, readings, before }, THINKING);
          else end();
        },
        () => end(),
      );
      mine.ask({ ...load, traced: true }, THINKING);
    });
  }
}
