// @ts-check
// The page's end of the planning worker.

/**
 * @typedef {import("./types").FromWorker} FromWorker
 * @typedef {object} Listeners
 * @property {(id: number, done: number, cells: Uint32Array) => void} progress
 * @property {(id: number, cells: Uint32Array, seconds: number) => void} finished
 * @property {(id: number, message: string) => void} failed
 */

export class Planning {
  /** @type {WebAssembly.Module} */
  #module;
  /** @type {Listeners} */
  #listeners;
  /** @type {Worker} */
  #worker;
  /** Number of the request being worked on. @type {number | undefined} */
  #busy;

  /**
   * @param {WebAssembly.Module} module
   * @param {Listeners} listeners
   */
  constructor(module, listeners) {
    this.#module = module;
    this.#listeners = listeners;
    this.#worker = this.#hire();
  }

  /** Starts planning; what was being planned is dropped. @param {import("./types").PlanRequest} request */
  start(request) {
    this.cancel();
    this.#busy = request.id;
    this.#worker.postMessage({ type: "plan", request });
  }

  /** Ends the current planning at once, whatever the worker is doing. */
  cancel() {
    if (this.#busy === undefined) return;
    this.#busy = undefined;
    this.#worker.terminate();
    this.#worker = this.#hire();
  }

  /** A fresh worker, warmed up before it is needed; the compiled module is shared. */
  #hire() {
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    worker.addEventListener("message", (event) => {
      if (worker === this.#worker) this.#hear(event.data);
    });
    worker.addEventListener("error", (event) => {
      if (worker !== this.#worker) return;
      const id = this.#busy;
      this.cancel();
      const cause = event.message || "its program could not be loaded";
      if (id !== undefined) this.#listeners.failed(id, `The planner stopped: ${cause}. Try another algorithm or reload.`);
    });
    worker.postMessage({ type: "init", module: this.#module });
    return worker;
  }

  /** @param {FromWorker} message */
  #hear(message) {
    if (message.id !== this.#busy) return;
    if (message.type === "progress") {
      this.#listeners.progress(message.id, message.done, message.cells);
      return;
    }
    this.#busy = undefined;
    if (message.type === "finished") this.#listeners.finished(message.id, message.cells, message.seconds);
    else this.#listeners.failed(message.id, message.message);
  }
}
