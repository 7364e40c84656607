// @ts-check
// Workers that make trials or runs, as many as the computer has cores for.
import { textOf } from "../messages.js";

/**
 * @typedef {{ id: number, job?: ArrayLike<number> }} Request
 * @typedef {{ worker: Worker, busy: number | undefined }} Hand
 * @typedef {object} Source A source of work that takes the results.
 * @property {"trial" | "runs"} type The kind of work.
 * @property {number} most Most workers: each holds a room and a planner's memory.
 * @property {() => Request | undefined} take
 * @property {() => import("../program/work.js").Text | undefined} program The user's program, for requests with a job for it.
 * @property {(id: number) => boolean} isWanted
 * @property {(answer: import("../worker-types").FromTrial | import("../worker-types").FromRuns) => void} answered
 * @property {(id: number, message: string) => void} failed
 */

export class Pool {
  /** @type {Hand[]} */
  #hands = [];
  #module;
  #source;
  #guard;

  /**
   * @param {WebAssembly.Module} module
   * @param {Source} source
   * @param {(what: () => void) => boolean} guard
   */
  constructor(module, source, guard) {
    this.#module = module;
    this.#source = source;
    this.#guard = guard;
  }

  /** Gives work to idle workers, and ends work that is no longer required. */
  tend() {
    const hands = this.#hands;
    for (const hand of hands) {
      if (hand.busy !== undefined && !this.#source.isWanted(hand.busy)) this.#replace(hand);
    }
    for (;;) {
      const idle = hands.find(({ busy }) => busy === undefined);
      if (!idle && hands.length >= Math.min(this.#source.most, navigator.hardwareConcurrency || 2)) return;
      const request = this.#source.take();
      if (!request) return;
      const hand = idle ?? this.#hire();
      hand.busy = request.id;
      if (request.job) this.#prepare(hand, request);
      else hand.worker.postMessage({ type: this.#source.type, request });
    }
  }

  /** The user's program drives or plans first, in the sandbox. @param {Hand} hand @param {Request} request */
  #prepare(hand, request) {
    const { worker } = hand;
    const isWanted = () => worker === hand.worker && hand.busy === request.id;
    const { type, program } = this.#source;
    void import("../program/work.js")
      .then(({ prepared }) => prepared(program(), { ...request, job: request.job ?? [] }, isWanted))
      .then(
        (whole) => isWanted() && worker.postMessage({ type, request: whole }),
        (error) => {
          if (!isWanted()) return;
          hand.busy = undefined;
          this.#guard(() => this.#source.failed(request.id, textOf(error)));
        },
      );
  }

  /** @returns {Hand} */
  #hire() {
    const hand = { worker: this.#start(), busy: undefined };
    this.#listen(hand);
    this.#hands.push(hand);
    return hand;
  }

  #start() {
    const worker = new Worker(new URL("../worker.js", import.meta.url), { type: "module" });
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
    worker.addEventListener("message", (/** @type {MessageEvent<import("../worker-types").FromTrial | import("../worker-types").FromRuns>} */ { data }) => {
      if (worker !== hand.worker || data.id !== hand.busy) return;
      if (data.type !== "progress") hand.busy = undefined;
      this.#guard(() => {
        this.#source.answered(data);
        // At once, not with the next frame: short runs would wait longer than they take.
        if (data.type !== "progress") this.tend();
      });
    });
    worker.addEventListener("error", (event) => {
      const id = hand.busy;
      if (worker !== hand.worker) return;
      this.#replace(hand);
      const cause = event.message || "its program could not be loaded";
      if (id !== undefined) this.#guard(() => this.#source.failed(id, `it stopped: ${cause}`));
    });
  }
}
