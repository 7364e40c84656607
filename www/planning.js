// @ts-check
// The page's end of the planning worker.

/**
 * @typedef {import("./worker-types").FromWorker} FromWorker
 * @typedef {import("./worker-types").Proof | undefined} Proof
 * @typedef {object} Listeners
 * @property {(id: number, done: number, cells: import("./worker-types").WirePath, proof: Proof) => void} progress
 * @property {(id: number, cells: import("./worker-types").WirePath, seconds: number, trace: Uint8Array, proof: Proof, knots: import("./worker-types").Knots, film: import("./worker-types").FilmPictures) => void} finished
 * @property {(id: number, film: unknown[]) => void} [filmed] Receives the film of a plan that was kept.
 * @property {(id: number, knots: Float64Array) => void} [smoothed] Receives the rounded corners of a plan that was kept.
 * @property {(id: number, proof: Proof, least: Float64Array | undefined) => void} [proven] Receives what is proven of a plan already received.
 * @property {(id: number, message: string) => void} failed
 */

const nothing = () => ({ cells: new Uint32Array(), proof: undefined, frames: [] });

export class Planning {
  /** @type {Listeners} */
  #listeners;
  /** There from the first request on. @type {Promise<Worker> | undefined} */
  #worker;
  /** Number of the request being worked on. @type {number | undefined} */
  #busy;
  /** The last request. @type {import("./worker-types").PlanRequest | undefined} */
  #request;
  /** Its best path so far, its proof, and the frames of its film. @type {{ cells: import("./worker-types").WirePath; proof: Proof; frames: unknown[] }} */
  #best = nothing();
  /** Id of the request that the worker is busy with, if any: the proof comes after the plan. */
  #sent = false;
  #proving = NaN;
  #began = 0;

  /** @param {Listeners} listeners */
  constructor(listeners) {
    this.#listeners = listeners;
  }

  /** Starts planning; the previous request is dropped. @param {import("./worker-types").PlanRequest} request */
  start(request) {
    this.cancel();
    this.#busy = request.id;
    this.#request = request;
    this.#best = nothing();
    const hired = (this.#worker ??= this.#hire());
    hired.then(
      (worker) => {
        if (this.#busy !== request.id) return;
        this.#sent = true;
        this.#began = performance.now();
        worker.postMessage({ type: "plan", request });
      },
      (error) => {
        // Tried again for the next request.
        if (this.#worker === hired) this.#worker = undefined;
        console.warn(error);
        this.#fail(request.id, "it could not be loaded. Check the connection, then press play");
      },
    );
  }

  /** Ends the current planning at once, whatever the worker is doing. @returns {number} Seconds since that began. */
  cancel() {
    this.#busy = undefined;
    this.#proving = NaN;
    const seconds = (performance.now() - this.#began) / 1000;
    if (!this.#sent) return seconds;
    this.#sent = false;
    void this.#worker?.then((worker) => worker.terminate());
    this.#worker = this.#hire();
    // Listeners are notified.
    this.#worker.catch(() => {});
    return seconds;
  }

  /** Ends the search, whose best walk so far is to be kept: another worker proves how good that is. @returns {number} Seconds since it began. */
  keep() {
    const [seconds, request, { cells, proof, frames }] = [this.cancel(), this.#request, this.#best];
    if (request) this.prove(request, cells, proof, frames);
    return seconds;
  }

  /**
   * Rounds the corners of a plan, makes its film, and proves how good it is.
   * @param {import("./worker-types").PlanRequest} request @param {import("./worker-types").WirePath} cells @param {Proof} [proof] @param {unknown[]} [frames]
   */
  prove(request, cells, proof, frames = []) {
    this.#proving = request.id;
    void (this.#worker ??= this.#hire()).then((worker) => {
      if (this.#proving !== request.id) return;
      this.#sent = true;
      worker.postMessage({ type: "prove", request, cells, proof, frames });
    });
  }

  /** A fresh worker, warmed up before it is needed; the compiled module is shared. */
  async #hire() {
    const { hire } = await import("./workers.js");
    const worker = await hire();
    worker.addEventListener("message", (event) => this.#hear(event.data));
    worker.addEventListener("error", (event) => {
      const id = this.#busy;
      this.#worker = undefined;
      this.#sent = false;
      const cause = event.message || "its program could not be loaded";
      if (id !== undefined) this.#fail(id, `it stopped (${cause})`);
    });
    return worker;
  }

  /** @param {number} id @param {string} cause */
  #fail(id, cause) {
    if (this.#busy !== id) return;
    this.#busy = undefined;
    this.#listeners.failed(id, cause);
  }

  /** @param {FromWorker} message */
  #hear(message) {
    const { id } = message;
    if (message.type === "smoothed" && message.knots && id === this.#proving) this.#listeners.smoothed?.(id, message.knots);
    if (message.type === "filmed" && message.film && id === this.#proving) this.#listeners.filmed?.(id, message.film);
    if (message.type === "proven" && id === this.#proving) {
      this.#proving = NaN;
      this.#sent = false;
      this.#listeners.proven?.(id, message.proof, message.least);
    }
    if (id !== this.#busy) return;
    if (message.type === "progress") {
      const { done, cells, proof, frames } = message;
      this.#best.frames.push(...frames);
      Object.assign(this.#best, { cells, proof });
      this.#listeners.progress(id, done, cells, proof);
      return;
    }
    this.#busy = undefined;
    this.#sent = message.type === "finished";
    if (this.#sent) this.#proving = id;
    if (message.type === "finished") this.#listeners.finished(id, message.cells, message.seconds, message.trace, message.proof, message.knots, message.film);
    else if (message.type === "failed") this.#listeners.failed(id, message.message);
  }
}
