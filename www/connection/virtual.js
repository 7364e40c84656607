// @ts-check
// A line to a robot that isn't there: it lives in this worker, by the worker's clock.
import { VirtualRobot } from "../../workshop.js";
import { failure } from "./ports.js";

/** Time that is caught up at most after the worker was held up, s: the robot doesn't make leaps. */
const CATCH_UP_S = 0.1;

/** @typedef {import("./types").Transport} Transport */

/** @implements {Transport} */
export class VirtualLine {
  /** @type {import("./types").TransportView} */
  view;

  #robot;
  #events;
  #time = 0;

  /** @param {import("../../workshop.js").SessionMirror} mirror @param {string} personality @param {import("./types").TransportEvents} events */
  constructor(mirror, personality, events) {
    try {
      this.#robot = new VirtualRobot(mirror, personality);
    } catch (error) {
      throw failure("failed", String(error), "");
    }
    this.#events = events;
    this.view = {
      kind: "virtual",
      state: "closed",
      name: "Virtual robot",
      text: "",
      baud: 115200,
      can_baud: true,
      is_own_usb: false,
      brc: "high",
      errors: { break: 0, framing: 0, parity: 0, overrun: 0 },
      returns: 0,
      is_watching: false,
    };
  }

  async open() {
    this.view.state = "open";
  }

  /** Lets it live until `now`, s. @param {number} now */
  tick(now) {
    const step = Math.min(now - (this.#time || now), CATCH_UP_S);
    this.#time = now;
    this.#robot.advance(step);
    const bytes = this.#robot.transmit(this.view.baud);
    if (bytes.length && this.view.state === "open") this.#events.onbytes(bytes);
  }

  /** @param {Uint8Array} bytes */
  write(bytes) {
    this.#robot.receive(bytes, this.view.baud);
  }

  /** @param {number} baud */
  async setBaud(baud) {
    this.view.baud = baud;
  }

  /** @param {boolean} isLow */
  async setBrc(isLow) {
    this.#robot.set_brc(isLow);
    this.view.brc = isLow ? "low" : "high";
  }

  async close() {
    this.view.state = "closed";
  }

  /** @param {import("./types").Touch} touch */
  touch(touch) {
    if (touch.do === "lift") this.#robot.lift();
    else if (touch.do === "put_down" || touch.do === "put_at_start") this.#robot.put_down(touch.x, touch.y, touch.heading);
    else if (touch.do === "press") this.#robot.press(touch.buttons);
    else this.#robot.plug_charger(touch.plugged);
  }

  /** Its true pose: x, y in m, heading in rad. */
  pose() {
    return this.#robot.pose();
  }

  /** Its visible and audible state. @returns {import("./types").VirtualView} */
  look() {
    return this.#robot.view();
  }

  /** Gives its memory back. */
  free() {
    this.#robot.free();
  }
}
