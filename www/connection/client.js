// @ts-check
// The page's end of a connection to a robot. Everything critical runs in two workers, as the page can be busy.
import { accessBy } from "./access.js";
import { ConnectionWorkers } from "./connection-workers.js";
import { choosePort } from "./ports.js";
import { watchPage } from "./safety.js";

/** @typedef {import("./types").Failure} Failure */

/** Interval of beats to the worker, ms. Without them it slows the robot down, then stops it. */
const BEAT_MS = 40;

/**
 * A connection to a robot, real or virtual. Set the callbacks, then `open`.
 *
 * Refusals and failures are reported to `onfailed`; promises of methods then resolve to `false` and never reject.
 */
export class ConnectionClient {
  /** 20 times a second while something is open, and once when it closes. @type {(view: import("./types").ConnectionView) => void} */
  onview = () => {};
  /** New traffic, oldest first. @type {(traffic: import("./types").Traffic[]) => void} */
  ontraffic = () => {};
  /** New part of the estimated trail: x, y in m, heading in rad, contacts, in turn. @type {(trace: Float64Array) => void} */
  ontrace = () => {};
  /** Readings for the user's program, which drives: each is to be answered. @type {(readings: Float64Array) => void} */
  onreadings = () => {};
  /** @type {(failure: Failure) => void} */
  onfailed = () => {};

  #workers;
  #beats = 0;
  #release;
  /** @type {import("./types").ConnectionView | undefined} */
  #view;
  #movesUntil = 0;

  /** @param {WebAssembly.Module} module workshop_bg.wasm, compiled */
  constructor(module) {
    this.#workers = new ConnectionWorkers(module);
    this.#workers.onreport = (message) => this.#heard(message);
    this.#workers.onbroke = () => this.#rest();
    const leave = (/** @type {string} */ why) => {
      if (this.#mayMove()) this.#workers.stop();
      this.leave(why);
    };
    this.#release = watchPage(leave, () => this.#mayMove());
  }

  /** Whether something is connected, or about to be. */
  get isOpen() {
    return this.#beats !== 0;
  }

  /**
   * Connects; what was connected before is closed. For an adapter without `port` this has to be called by a click.
   * Resolves to `false` if nothing was opened, which `onfailed` reports unless the user chose no port.
   * @param {import("./types").Target} target
   * @returns {Promise<boolean>}
   */
  async open(target) {
    try {
      const known = target.kind === "serial" || target.kind === "usb" ? await choosePort(accessBy(target.kind), target.port) : target;
      if (!known) return false;
      if (this.isOpen) await this.close();
      this.#workers.revive();
      // A hidden page counts as gone, as its timers are unreliable.
      this.#beats = window.setInterval(() => document.visibilityState === "visible" && this.#workers.tell({ type: "beat", at: performance.now() / 1000 }), BEAT_MS);
      const opened = await this.#workers.ask({ type: "open", id: 0, target: known });
      if (!opened) this.#rest();
      return opened === true;
    } catch (error) {
      this.onfailed(/** @type {Failure} */ (error));
      return false;
    }
  }

  /** Stops the robot, ends the interface and lets the line go. Takes a second at most. */
  async close() {
    await this.#workers.ask({ type: "close", id: 0 });
    this.#rest();
  }

  /** Brings the worker's copy of room and settings up to date; to be done before a virtual robot and before a ride.
   * @param {import("./types").Followed} followed @returns {Promise<boolean>} */
  async follow({ snapshot, algorithm }) {
    this.#workers.revive();
    return (await this.#workers.ask({ type: "follow", id: 0, snapshot, algorithm })) === true;
  }

  /** Says whether it was done. @param {import("./types").Request} request @returns {Promise<boolean>} */
  async request(request) {
    if (request.do !== "stop") this.#movesUntil = performance.now() + 500;
    return (await this.#workers.ask({ type: "request", id: 0, request })) === true;
  }

  /**
   * Starts the algorithm of the followed snapshot: a behaviour, or the planned line with these corners, x and y in
   * turn, m, or its trajectory with rounded corners. With `cleans`, brushes and vacuum run for one that is for cleaning. Resolves to whether it drives.
   * @param {Float64Array | number[]} corners
   * @param {boolean} cleans
   * @param {Float64Array} [knots]
   * @returns {Promise<boolean>}
   */
  async ride(corners, cleans, knots = new Float64Array()) {
    this.#movesUntil = performance.now() + 500;
    return (await this.#workers.ask({ type: "ride", id: 0, corners: Float64Array.from(corners), knots, cleans })) === true;
  }

  /** Facts about the robot for the user's program, as JSON; empty if there are none. */
  async facts() {
    const facts = await this.#workers.ask({ type: "facts", id: 0 });
    return typeof facts === "string" ? facts : "";
  }

  /** What the user's program answers: speeds of both wheels, mm/s; NaN if it is done. @param {number} left @param {number} right */
  answer(left, right) {
    this.#workers.tell({ type: "answer", left, right });
  }

  /** Stops the robot and gives control up. @param {string} why A sentence for a returning user. */
  leave(why) {
    this.#workers.tell({ type: "leave", why });
  }

  /** An action of a person on the virtual robot. @param {import("./types").Touch} touch */
  virtual(touch) {
    this.#workers.tell({ type: "virtual", touch });
  }

  /** All traffic so far, as a recording. @returns {Promise<string>} */
  async recording() {
    return String(await this.#workers.ask({ type: "recording", id: 0 }));
  }

  /** Closes, and ends the workers. It can't be used any more. */
  async end() {
    await this.close();
    this.#release();
    this.#workers.end();
  }

  /** @param {Parameters<ConnectionWorkers["onreport"]>[0]} message */
  #heard(message) {
    if (message.type === "view") {
      this.#view = message.view;
      this.onview(message.view);
    } else if (message.type === "traffic") this.ontraffic(message.traffic);
    else if (message.type === "trace") this.ontrace(message.trace);
    else if (message.type === "readings") this.onreadings(message.readings);
    else this.onfailed(message.failure);
  }

  #rest() {
    clearInterval(this.#beats);
    this.#beats = 0;
  }

  /** Whether the robot moves, or can by requests since the latest view. */
  #mayMove() {
    if (!this.isOpen) return false;
    const { mode, ride, transport } = this.#view ?? { mode: "", ride: null };
    if (transport?.is_watching) return false;
    return mode === "Safe" || mode === "Full" || ride?.done === false || performance.now() < this.#movesUntil;
  }
}
