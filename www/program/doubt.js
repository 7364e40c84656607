// @ts-check
// Whether a step that takes long is endless, or the machine is slow. Time can't tell, but the same run can, followed line by
// line: it counts statements.
import { PATIENCE } from "./sandbox.js";

/** Longest silence of a planner, which may think, and of a run that is followed line by line, ms. */
export const THINKING = 10_000;
/** Longest step on a slow machine, ms. */
const MOST_PATIENCE = 4000;
/** Farthest behind what was heard of a worker that it can be silent, steps: more than it takes in a slice. */
const UNHEARD = 20_000;

export class Doubt {
  /** Longest silence of a program that isn't followed, ms. */
  #patience = PATIENCE;
  /** The step by which the line is looked for; 0 while there is no doubt. */
  until = 0;

  /** Another program, or the same anew. */
  reset() {
    this.#patience = PATIENCE;
    this.until = 0;
  }

  /** Longest silence, ms. */
  get limit() {
    return this.until ? THINKING : this.#patience;
  }

  /** It was silent. @param {number} step How far it was heard. @param {number} asked How far it was asked to go; 0 if it wasn't. */
  begin(step, asked) {
    this.until = Math.min(asked || Infinity, step + UNHEARD);
  }

  /** No step is endless: it gets more time. @returns {string} What to say if it has had enough; else empty. */
  end() {
    this.until = 0;
    this.#patience *= 2;
    return this.#patience > MOST_PATIENCE ? `A step of the program took longer than ${MOST_PATIENCE / 1000} s and was ended. Do less in each step.` : "";
  }
}
