// @ts-check
// The worker with the drawing board, from the page's side: asked, cancelled, started again with what it had.
import { byId } from "../dom.js";

/** @typedef {import("./types").DraftView} DraftView */
/** @typedef {import("./types").Request} Request */
/** @typedef {{ resolve: (result: unknown) => void, reject: (message: unknown) => void, request: Request }} Waiting */

/** Thrown for what was cancelled. */
export const CANCELLED = Symbol("cancelled");

export class Drafter {
  /** What is on the board. @type {File[]} */
  files = [];
  /** @type {DraftView | undefined} */
  view;
  /** @type {(view: DraftView | undefined) => void} */
  onview = () => {};
  /** @type {(done: number) => void} */
  onprogress = () => {};
  /** The board is a new one; its canvas too. @type {(canvas: HTMLCanvasElement) => void} */
  onstart = () => {};
  /** @type {(message: string) => void} */
  onbroken = () => {};
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
    const old = byId("draft-floor");
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
    // What can't even be brought back is given up.
    if (this.files.length && !waiting.some(({ request }) => request.type === "restore")) {
      this.ask({ type: "restore", files: this.files, settings: this.view?.settings ?? null }).catch(() => this.#clear());
    } else this.#clear();
    for (const { reject } of waiting) reject(CANCELLED);
  }

  #clear() {
    this.files = [];
    this.#show(undefined);
  }

  /** @param {import("./types").FromDrafter} message */
  #hear(message) {
    this.#isAlive ||= message.type !== "broken";
    if (message.type === "progress") return this.onprogress(message.done);
    if (message.type === "broken") return this.#broke(message.message);
    if (message.type === "view") return this.#show(message.view);
    const waiting = this.#waiting.get(message.id);
    this.#waiting.delete(message.id);
    if (message.type === "answer" && waiting?.request.type === "open") this.files = waiting.request.files;
    this.#show(message.view);
    if (message.type === "answer") waiting?.resolve(message.result);
    else waiting?.reject(message.message);
  }

  /** @param {DraftView | undefined} view */
  #show(view) {
    this.view = view;
    this.onview(view);
  }

  /** @param {string} message */
  #broke(message) {
    if (this.#isAlive) this.cancel();
    else {
      this.#worker?.terminate();
      this.#worker = undefined;
      for (const { reject } of this.#waiting.values()) reject(CANCELLED);
      this.#waiting.clear();
    }
    this.onbroken(message);
  }
}
