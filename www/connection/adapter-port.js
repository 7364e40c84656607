// @ts-check
// What openings of all adapters have in common: bytes out until the adapter is closed or lost.
import { within } from "./within.js";

/** Time limit for closing, opening and writing, ms. */
export const CLOSE_MS = 1000;
export const OPEN_MS = 15_000;
export const WRITE_MS = 1000;
/** Time for the last bytes to be transmitted before the port is closed, ms. */
const LAST_WORDS_MS = 60;

/** An opening of an adapter. Subclasses read, and say how bytes leave and how the adapter closes. */
export class AdapterPort {
  /** Whether it is closed or lost. */
  isOver = false;
  /** Whether the adapter has control lines; BRC can be wired to one. */
  hasSignals = false;
  /** When the writes began that aren't done yet. @type {number[]} */
  #writes = [];

  /** @param {import("./types").PortEvents} events */
  constructor(events) {
    this.events = events;
  }

  /** Sends bytes of its own; nothing if it isn't open yet. @param {Uint8Array<ArrayBuffer>} _bytes @returns {Promise<void> | undefined} */
  send(_bytes) {
    return undefined;
  }

  /** Closes the adapter, once what was written had time to leave. */
  async shut() {}

  /** Why it failed, for users. @param {unknown} error */
  said(error) {
    const { name, message } = /** @type {Error} */ (error);
    return name === "NetworkError" ? "The adapter was unplugged." : `The adapter failed (${message}).`;
  }

  /** @param {Uint8Array} bytes */
  write(bytes) {
    if (this.isOver || !bytes.length) return;
    const now = performance.now();
    if (this.#writes.length && now - this.#writes[0] > WRITE_MS) return this.lose("The adapter no longer accepts data.");
    const sent = this.send(Uint8Array.from(bytes));
    if (!sent) return;
    this.#writes.push(now);
    sent.then(
      () => this.#writes.shift(),
      (error) => this.lose(this.said(error)),
    );
  }

  /** Sends what was written and closes, or gives up after a second: a dead adapter may never answer. */
  async close() {
    this.isOver = true;
    const shut = async () => {
      await new Promise((later) => setTimeout(later, LAST_WORDS_MS));
      await this.shut();
    };
    await within(CLOSE_MS, shut()).catch(() => {});
  }

  /** @param {string} why */
  lose(why) {
    if (this.isOver) return;
    void this.close();
    this.events.onlost(why);
  }
}
