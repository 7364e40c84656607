// @ts-check
// The worker with the drawing board, from the page's side: asked, cancelled, started again with what it had.
import { byId } from "../dom.js";

/** @typedef {import("./types").FloorPlanView} FloorPlanView */
/** @typedef {import("./types").Request} Request */
/** @typedef {{ resolve: (result: unknown) => void, reject: (message: unknown) => void, request: Request }} Waiting */

/** Thrown for what was cancelled. */
export const CANCELLED = Symbol("cancelled");

export class FloorPlanClient {
  /** What is on the board. @type {File[]} */
  files = [];
  /** @type {FloorPlanView | undefined} */
  view;
  /** @type {(view: FloorPlanView | undefined) => void} */
  onview = () => {};
  /** @type {(done: number) => void} */
  onprogress = () => {};
  /** The board is a new one; its canvas too. @type {(canvas: HTMLCanvasElement) => void} */
  onstart = () => {};
  /** It broke; whether what was on the board comes back. @type {(message: string, returns: boolean) => void} */
  onbroken = () => {};
  /** What was on the board is to be asked for again. @type {(request: Request) => void} */
  onrestore = () => {};
  /** What the board last had. @type {{ files: File[], settings: import("./types").FloorPlanSettings } | undefined} */
  #good;
  /** Breaks since the board last did what somebody asked of it. */
  #breaks = 0;
  /** Asked and not answered. @type {Map<number, Waiting>} */
  #waiting = new Map();
  #asked = 0;
  /** @type {Worker | undefined} */
  #worker;
  /** Whether the worker has said anything: one that never did won't do better when it is started again. */
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

  /** Ends what it does, and brings back what was on the board before. */
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
    // What is brought back is on the board even if what was chosen for it is refused.
    if ((request?.type === "open" && message.type === "answer") || (request?.type === "restore" && message.view)) this.files = request.files;
    if (message.type === "answer" && asked !== "restore") this.#breaks = 0;
    // What can't even be brought back is given up.
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
