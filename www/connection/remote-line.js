// @ts-check
// The driver's end of a line that another worker holds (line-worker.js). Each of the two watches the other.
import { STOP, Watch } from "./safety.js";
import { rescue } from "./rescue.js";

/** @typedef {import("./types").Transport} Transport */

/** @implements {Transport} */
export class RemoteLine {
  /** @type {import("./types").TransportView} */
  view;

  #port;
  #target;
  #events;
  #watch = new Watch();
  #asked = 0;
  /** @type {Map<number, (message: Extract<import("./types").FromLine, { type: "done" }>) => void>} */
  #waiting = new Map();

  /** @param {MessagePort} port @param {import("./types").LineTarget} target @param {import("./types").TransportEvents} events */
  constructor(port, target, events) {
    this.#port = port;
    this.#target = target;
    this.#events = events;
    const isSocket = target.kind === "socket";
    this.view = {
      kind: isSocket ? "socket" : "serial",
      state: "opening",
      name: isSocket ? target.url : "",
      text: "",
      baud: 115200,
      can_baud: !isSocket,
      is_own_usb: false,
      brc: "none",
      errors: { break: 0, framing: 0, parity: 0, overrun: 0 },
      returns: 0,
      is_watching: false,
    };
    port.onmessage = ({ data }) => this.#heard(data);
  }

  async open() {
    await this.#ask({ type: "open", id: 0, target: this.#target });
    this.#watch.heard();
  }

  /** @param {Uint8Array} bytes @param {boolean} [isActing] Whether the robot may move because of them. */
  write(bytes, isActing = false) {
    this.#post({ type: "write", bytes, isActing });
  }

  /** @param {number} baud */
  async setBaud(baud) {
    this.view.baud = baud;
    await this.#ask({ type: "baud", id: 0, baud });
  }

  /** @param {boolean} isLow */
  async setBrc(isLow) {
    await this.#ask({ type: "brc", id: 0, isLow });
  }

  take() {
    this.#post({ type: "take" });
  }

  stop() {
    this.#post({ type: "stop" });
  }

  left() {
    this.#post({ type: "left" });
  }

  async close() {
    this.view.state = "closed";
    // Who no longer answers can't be waited for.
    const late = new Promise((/** @type {(value: void) => void} */ resolve) => setTimeout(resolve, 1500));
    await Promise.race([this.#ask({ type: "close", id: 0 }).catch(() => {}), late]);
  }

  /**
   * Lets time pass: says that the driver is there, and whether the robot may be moving. Says whether the other worker is there.
   * @param {boolean} isActing
   */
  tick(isActing) {
    if (this.view.state !== "open") return true;
    this.#post({ type: "beat", isActing });
    this.#watch.tick();
    return !(isActing && this.#watch.isSilent);
  }

  /** Stops the robot past the worker that no longer answers, which has to be ended by then. Says whether a stop was sent. */
  rescue() {
    this.view.state = "closed";
    return rescue(this.#target, this.view.baud, STOP);
  }

  /** @param {import("./types").ToLine} message */
  #post(message) {
    this.#port.postMessage(message);
  }

  /** @param {Extract<import("./types").ToLine, { id: number }>} message @returns {Promise<void>} */
  #ask(message) {
    message.id = ++this.#asked;
    return new Promise((resolve, reject) => {
      this.#waiting.set(message.id, ({ failure }) => (failure ? reject(failure) : resolve()));
      this.#post(message);
    });
  }

  /** @param {import("./types").FromLine} message */
  #heard(message) {
    this.#watch.heard();
    if (message.type === "bytes") return this.#events.onbytes(message.bytes);
    if (message.view) this.view = message.view;
    if (message.type === "beat") return;
    if (message.type === "opened") this.#events.onopened();
    else if (message.type === "halted") this.#events.onhalted?.(message.why);
    else if (message.type === "lost") this.#events.onlost(message.why, message.forGood);
    else {
      this.#waiting.get(message.id)?.(message);
      this.#waiting.delete(message.id);
    }
  }
}
