// @ts-check
// What openings of all adapters have in common: bytes out until the adapter is closed or lost.
import { within } from "./within.js";

/** Time limit for closing, opening and writing, ms. */
export const CLOSE_MS = 1000;
export const OPEN_MS = 15_000;
export const WRITE_MS = 1000;
/** A robot that heard the goodbye falls silent. Until it has been for so many steps, the port stays open. */
const SILENT_STEPS = 4;
const STEP_MS = 15;
/** A robot that goes on sending isn't waited for any longer than this, ms. */
const LAST_WORDS_MS = 800;

/** An opening of an adapter. Subclasses read, and say how bytes leave and how the adapter closes. */
export class AdapterPort {
  /** Whether it is closed or lost. */
  isOver = false;
  /** Whether the adapter has control lines; BRC can be wired to one. */
  hasSignals = false;
  /** When the writes began that aren't done yet. @type {number[]} */
  #writes = [];
  /** How often bytes arrived. */
  #arrivals = 0;

  /** @param {import("./types").PortEvents} events */
  constructor(events) {
    this.events = events;
  }

  /** Sends bytes of its own; nothing if it isn't open yet. @param {Uint8Array<ArrayBuffer>} _bytes @returns {Promise<void> | undefined} */
  send(_bytes) {
    return undefined;
  }

  /** Returns when the browser has done something for this port: it may be slower than this worker. */
  async proceed() {}

  /** Closes the adapter, once what was written had time to leave. */
  async shut() {}

  /** Why it failed, for users. @param {unknown} error */
  said(error) {
    const { name, message } = /** @type {Error} */ (error);
    return name === "NetworkError" ? "The adapter was unplugged." : `The adapter failed (${message}).`;
  }

  /** Passes on what the robot sent, unless this is over. @param {Uint8Array} bytes */
  arrived(bytes) {
    this.#arrivals += 1;
    if (!this.isOver) this.events.onbytes(bytes);
  }

  /** @param {Uint8Array} bytes */
  write(bytes) {
    if (this.isOver || !bytes.length) return;
    const now = performance.now();
    if (this.#writes.length && now - this.#writes[0] > WRITE_MS) return this.lose("The adapter no longer accepts data.");
    const sent = this.send(Uint8Array.from(bytes));
    if (!sent) return;
    this.#writes.push(now);
    sent.catch((error) => this.lose(this.said(error))).finally(() => this.#writes.shift());
  }

  /** Sends what was written and closes; gives up each of the two after a second, as a dead adapter may never answer. */
  async close() {
    this.isOver = true;
    await within(CLOSE_MS, this.#silence()).catch(() => {});
    await this.#end();
  }

  async #end() {
    await within(CLOSE_MS, this.shut()).catch(() => {});
  }

  /** Waits until the robot is silent. */
  async #silence() {
    const end = performance.now() + LAST_WORDS_MS;
    let [arrivals, silent] = [this.#arrivals, 0];
    while ((silent < SILENT_STEPS || this.#writes.length) && performance.now() < end) {
      await Promise.all([this.proceed(), new Promise((later) => setTimeout(later, STEP_MS))]);
      silent = arrivals === this.#arrivals ? silent + 1 : 0;
      arrivals = this.#arrivals;
    }
  }

  /** @param {string} why */
  lose(why) {
    if (this.isOver) return;
    this.isOver = true;
    void this.#end();
    this.events.onlost(why);
  }
}
