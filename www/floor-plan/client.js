// @ts-check
// The worker of the Floor plan tab, from the page's side: requests, cancelling, and restarting with the last state.
import { byId } from "../dom.js";

/** @typedef {import("./types").FloorPlanView} FloorPlanView */
/** @typedef {import("./types").Request} Request */
/** @typedef {{ resolve: (result: unknown) => void, reject: (message: unknown) => void, request: Request }} Waiting */

/** Thrown for cancelled requests. */
export const CANCELLED = Symbol("cancelled");

export class FloorPlanClient {
  /** The opened files. @type {File[]} */
  files = [];
  /** @type {FloorPlanView | undefined} */
  view;
  /** @type {(view: FloorPlanView | undefined) => void} */
  onview = () => {};
  /** @type {(done: number) => void} */
  onprogress = () => {};
  /** Called with the canvas of a new worker. @type {(canvas: HTMLCanvasElement) => void} */
  onstart = () => {};
  /** Called when the worker failed, with whether its state is restored. @type {(message: string, returns: boolean) => void} */
  onbroken = () => {};
  /** Called to repeat requests after a restart. @type {(request: Request) => void} */
  onrestore = () => {};
  /** The last state of the worker. @type {{ files: File[], settings: import("./types").FloorPlanSettings } | undefined}
   */
  #good;
  /** Failures since the worker last completed a request. */
  #breaks = 0;
  /** Unanswered requests. @type {Map<number, Waiting>} */
  #waiting = new Map();
  #asked = 0;
  /** @type {Worker | undefined} */
  #worker;
  /** Whether the worker has sent a message: one that never did isn't restarted. */
  #isAlive = false;
  #module;

  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.#module = module;
  }

  start() {
    // The canvas of the one before has gone with it.
    const old = byId("floor-plan-floor");
    const canvas = /** @type {HTMLCanvasElement} */ (old.cloneNode());
    const hadFocus = document.activeElement === old;
    old.replaceWith(canvas);
    if (hadFocus) canvas.focus();
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    this.#worker = worker;
    this.#isAlive = false;
    worker.addEventListener("message", ({ data }) => worker === this.#worker && this.#hear(data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      if (worker === this.#worker) this.#broke(event.message || "it could not be started");
    });
    const offscreen = canvas.transferControlToOffscreen();
    worker.postMessage({ type: "init", module: this.#module, canvas: offscreen }, [offscreen]);
    this.onstart(canvas);
  }

  /** @param {import("./types").Said} said */
  say(said) {
    this.#worker?.postMessage(said);
  }

  /** Rejects with a message for users, or `CANCELLED`. @param {Request} request @returns {Promise<unknown>} */
  ask(request) {
    if (!this.#worker) this.start();
    const id = ++this.#asked;
    this.#worker?.postMessage({ ...request, id });
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject, request }));
  }

  /** Cancels the current request, and restores the state before it. */
  cancel() {
    this.#worker?.terminate();
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    this.start();
    if (this.#good) this.onrestore({ type: "restore", ...this.#good });
    else this.#clear();
    for (const { reject } of waiting) reject(CANCELLED);
  }

  #clear() {
    this.files = [];
    this.#good = undefined;
    this.#show(undefined);
  }

  /** @param {import("./types").FromFloorPlan} message */
  #hear(message) {
    this.#isAlive ||= message.type !== "broken";
    if (message.type === "progress") return this.onprogress(message.done);
    if (message.type === "broken") return this.#broke(message.message);
    if (message.type === "view") return this.#show(message.view);
    const waiting = this.#waiting.get(message.id);
    this.#waiting.delete(message.id);
    const asked = waiting?.request.type;
    const request = waiting?.request;
    // Restored files stay open even if their settings are refused.
    if ((request?.type === "open" && message.type === "answer") || (request?.type === "restore" && message.view)) this.files = request.files;
    if (message.type === "answer" && asked !== "restore") this.#breaks = 0;
    // Files that can't be restored are dropped.
    if (asked === "restore" && !message.view) this.#clear();
    else this.#show(message.view);
    if (message.type === "answer") waiting?.resolve(message.result);
    else waiting?.reject(message.message);
  }

  /** @param {FloorPlanView | undefined} view */
  #show(view) {
    this.view = view;
    if (view) this.#good = { files: this.files, settings: view.settings };
    this.onview(view);
  }

  /** @param {string} message */
  #broke(message) {
    const returns = this.#isAlive && ++this.#breaks < 2 && this.#good !== undefined;
    if (returns) this.cancel();
    else {
      this.#worker?.terminate();
      this.#worker = undefined;
      for (const { reject } of this.#waiting.values()) reject(CANCELLED);
      this.#waiting.clear();
      // The next request starts it again.
      this.#clear();
    }
    this.onbroken(message, returns);
  }
}
