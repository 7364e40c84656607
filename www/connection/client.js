// @ts-check
// The page's end of a connection to a robot. All that matters happens in the worker: the page may be busy.
import { choosePort } from "./ports.js";
import { watchPage } from "./safety.js";

/** @typedef {import("./types").Failure} Failure */

/** How often the worker is told that the page is alive, ms. It stops the robot when it hasn't heard for 150 ms. */
const BEAT_MS = 40;

/**
 * A connection to a robot, real or virtual. Set the callbacks, then `open`.
 *
 * Everything that is refused or fails comes to `onfailed`; promises of methods then say `false` and never reject.
 */
export class ConnectionClient {
  /** 20 times a second while something is open, and once when it closes. @type {(view: import("./types").ConnectionView) => void} */
  onview = () => {};
  /** What went over the line since, oldest first. @type {(traffic: import("./types").Traffic[]) => void} */
  ontraffic = () => {};
  /** Estimated trail since: x, y in m, heading in rad, what it felt, in turn. @type {(trace: Float64Array) => void} */
  ontrace = () => {};
  /** @type {(failure: Failure) => void} */
  onfailed = () => {};

  #module;
  /** @type {Worker} */
  #worker;
  #isBroken = false;
  #beats = 0;
  #asked = 0;
  /** Who waits for which answer. @type {Map<number, (value: boolean | string) => void>} */
  #waiting = new Map();
  #release;
  /** @type {import("./types").ConnectionView | undefined} */
  #view;
  #movesUntil = 0;

  /** @param {WebAssembly.Module} module robot_bg.wasm, compiled */
  constructor(module) {
    this.#module = module;
    this.#worker = this.#start();
    this.#release = watchPage((why) => this.#tell({ type: "leave", why }), () => this.#mayMove());
  }

  #start() {
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data }) => this.#heard(data));
    worker.addEventListener("error", (event) => this.#broke(event.message || "it could not be started"));
    this.#tell({ type: "init", module: this.#module }, worker);
    return worker;
  }

  /** After an error of the program, the next connection has a worker of its own. */
  #revive() {
    if (!this.#isBroken) return;
    this.#worker.terminate();
    this.#isBroken = false;
    this.#worker = this.#start();
  }

  /** Whether something is connected, or about to be. */
  get isOpen() {
    return this.#beats !== 0;
  }

  /**
   * Connects; what was connected before is closed. For a serial port without `port` this has to be called by a click. Says
   * `false` if nothing was opened: `onfailed` was told why, unless the user just chose nothing.
   * @param {import("./types").Target} target
   * @returns {Promise<boolean>}
   */
  async open(target) {
    try {
      const known = target.kind === "serial" ? await choosePort(target.port) : target;
      if (!known) return false;
      if (this.isOpen) await this.close();
      this.#revive();
      // A page that isn't seen counts as away, whatever becomes of its timers.
      this.#beats = window.setInterval(() => document.visibilityState === "visible" && this.#tell({ type: "beat", at: performance.now() / 1000 }), BEAT_MS);
      const opened = await this.#ask({ type: "open", id: 0, target: known });
      if (!opened) this.#rest();
      return opened === true;
    } catch (error) {
      this.onfailed(/** @type {Failure} */ (error));
      return false;
    }
  }

  /** Stops the robot, ends the interface and lets the line go. Takes a second at most. */
  async close() {
    await this.#ask({ type: "close", id: 0 });
    this.#rest();
  }

  /** Brings the worker's copy of room and settings up to date; to be done before a virtual robot and before a ride.
   * @param {import("./types").Followed} followed @returns {Promise<boolean>} */
  async follow({ snapshot, algorithm }) {
    this.#revive();
    return (await this.#ask({ type: "follow", id: 0, snapshot, algorithm })) === true;
  }

  /** Says whether it was done. @param {import("./types").Request} request @returns {Promise<boolean>} */
  async request(request) {
    if (request.do !== "stop") this.#movesUntil = performance.now() + 500;
    return (await this.#ask({ type: "request", id: 0, request })) === true;
  }

  /**
   * Lets the algorithm drive that is chosen in what was followed: a behaviour, or the planned line with these corners, x and y
   * in turn, m. Says whether it does.
   * @param {Float64Array | number[]} corners
   * @returns {Promise<boolean>}
   */
  async ride(corners) {
    this.#movesUntil = performance.now() + 500;
    return (await this.#ask({ type: "ride", id: 0, corners: Float64Array.from(corners) })) === true;
  }

  /** Stops the robot and gives control back. @param {string} why A sentence for the user who comes back. */
  leave(why) {
    this.#tell({ type: "leave", why });
  }

  /** What a hand does to the virtual robot. @param {import("./types").Touch} touch */
  virtual(touch) {
    this.#tell({ type: "virtual", touch });
  }

  /** Everything that went over the line so far, as a recording. @returns {Promise<string>} */
  async recording() {
    return String(await this.#ask({ type: "recording", id: 0 }));
  }

  /** Closes, and ends the worker. It can't be used any more. */
  async end() {
    await this.close();
    this.#release();
    this.#worker.terminate();
  }

  /** @param {import("./types").ToConnection} message */
  #tell(message, worker = this.#worker) {
    worker.postMessage(message);
  }

  /** @param {Extract<import("./types").ToConnection, { id: number }>} message @returns {Promise<boolean | string>} */
  #ask(message) {
    message.id = ++this.#asked;
    return new Promise((resolve) => {
      if (this.#isBroken) return resolve(false);
      this.#waiting.set(message.id, resolve);
      this.#tell(message);
    });
  }

  /** @param {import("./types").FromConnection} message */
  #heard(message) {
    if (message.type === "view") {
      this.#view = message.view;
      this.onview(message.view);
    } else if (message.type === "traffic") this.ontraffic(message.traffic);
    else if (message.type === "trace") this.ontrace(message.trace);
    else if (message.type === "answer") {
      this.#waiting.get(message.id)?.(message.value);
      this.#waiting.delete(message.id);
    } else {
      if (message.failure.kind === "broken") this.#broke();
      this.onfailed(message.failure);
    }
  }

  /** Nothing will be answered any more. @param {string} [why] */
  #broke(why) {
    this.#isBroken = true;
    this.#rest();
    for (const answered of this.#waiting.values()) answered(false);
    this.#waiting.clear();
    if (why) this.onfailed({ kind: "broken", what: `The connection's worker failed: ${why}.`, remedy: "Connect again, or reload the page." });
  }

  #rest() {
    clearInterval(this.#beats);
    this.#beats = 0;
  }

  /** Whether the robot moves, or could by what was asked for since the latest view. */
  #mayMove() {
    if (!this.isOpen) return false;
    const { mode, ride } = this.#view ?? { mode: "", ride: null };
    return mode === "Safe" || mode === "Full" || ride?.done === false || performance.now() < this.#movesUntil;
  }
}
