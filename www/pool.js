// @ts-check
// Workers that make the trials of a comparison, as many as the computer has cores for.

/**
 * @typedef {import("../page.js").Comparison} Comparison
 * @typedef {{ worker: Worker, busy: number | undefined }} Hand
 */

/** Most workers: each holds a room and a planner's memory. */
const MOST = 6;

export class Pool {
  /** @type {Hand[]} */
  #hands = [];
  #module;
  #comparison;
  #guard;

  /**
   * @param {WebAssembly.Module} module
   * @param {Comparison} comparison
   * @param {(what: () => void) => boolean} guard
   */
  constructor(module, comparison, guard) {
    this.#module = module;
    this.#comparison = comparison;
    this.#guard = guard;
  }

  /** Gives work to whoever is idle, and ends what isn't wanted any more. */
  tend() {
    const hands = this.#hands;
    for (const hand of hands) {
      if (hand.busy !== undefined && !this.#comparison.is_wanted(hand.busy)) this.#replace(hand);
    }
    for (;;) {
      const idle = hands.find(({ busy }) => busy === undefined);
      if (!idle && hands.length >= Math.min(MOST, navigator.hardwareConcurrency || 2)) return;
      const request = this.#comparison.take_trial();
      if (!request) return;
      const hand = idle ?? this.#hire();
      hand.busy = request.id;
      hand.worker.postMessage({ type: "trial", request });
    }
  }

  /** @returns {Hand} */
  #hire() {
    const hand = { worker: this.#start(), busy: undefined };
    this.#listen(hand);
    this.#hands.push(hand);
    return hand;
  }

  #start() {
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    worker.postMessage({ type: "init", module: this.#module });
    return worker;
  }

  /** @param {Hand} hand */
  #replace(hand) {
    hand.worker.terminate();
    hand.worker = this.#start();
    hand.busy = undefined;
    this.#listen(hand);
  }

  /** @param {Hand} hand */
  #listen(hand) {
    const { worker } = hand;
    worker.addEventListener("message", (/** @type {MessageEvent<import("./types").FromTrial>} */ { data }) => {
      if (worker !== hand.worker || data.id !== hand.busy) return;
      if (data.type === "progress") {
        this.#guard(() => this.#comparison.trial_progress(data.id, data.done));
        return;
      }
      hand.busy = undefined;
      this.#guard(() => {
        if (data.type === "tried") this.#comparison.trial_finished(data.id, data.cells, data.numbers);
        else this.#comparison.trial_failed(data.id, data.message);
      });
    });
    worker.addEventListener("error", (event) => {
      const id = hand.busy;
      if (worker !== hand.worker) return;
      this.#replace(hand);
      const cause = event.message || "its program could not be loaded";
      if (id !== undefined) this.#guard(() => this.#comparison.trial_failed(id, `the planner stopped: ${cause}`));
    });
  }
}
