// @ts-check
// What a program prints and draws, within limits.

/** @typedef {import("../types").Output} One */

/** Most that a program prints or draws in a run, and the longest text. */
const MOST = 20_000;
const LONGEST = 400;

export class Output {
  #count = 0;
  /** @type {One[]} */
  #waiting = [];

  /** Takes what the program has said in a step, and empties it. @param {Record<string, any>[]} said @param {number} step */
  take(said, step) {
    for (const one of /** @type {One[]} */ (said)) {
      if ((this.#count += 1) > MOST && one.kind !== "break") break;
      if (typeof one.text === "string" && one.text.length > LONGEST) one.text = `${one.text.slice(0, LONGEST)}…`;
      this.#waiting.push(Object.assign(one, { variables: undefined, step }));
    }
    if (this.#count === MOST) this.#waiting.push({ kind: "print", step, text: `(more than ${MOST} prints and marks: the rest is left out)` });
    said.length = 0;
  }

  /** What was said since the last time. */
  flush() {
    const said = this.#waiting;
    this.#waiting = [];
    return said;
  }
}
