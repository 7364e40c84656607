// @ts-check
// One opening of a serial port: bytes both ways until it is closed or lost.
import { failure } from "./ports.js";

/** Room for what arrives while this worker is busy: 1.4 s at 115200 baud. Browsers' default of 255 bytes is 22 ms. */
const BUFFER_BYTES = 16384;

/** Time limit for closing, opening and writing, ms. */
export const CLOSE_MS = 1000;
/** Time for the last bytes to be transmitted before the port is closed, ms. */
export const LAST_WORDS_MS = 60;
export const OPEN_MS = 15_000;
export const WRITE_MS = 1000;

/** Errors that adapters recover from: the stream ends, and there is a new one. */
const RECOVERABLE = /** @type {const} */ ({ BreakError: "break", FramingError: "framing", ParityError: "parity", BufferOverrunError: "overrun" });

/** @typedef {import("./types").OpenablePort} OpenablePort */

/** @implements {OpenablePort} */
export class OpenPort {
  #port;
  #events;
  /** @type {WritableStreamDefaultWriter<Uint8Array> | undefined} */
  #writer;
  /** @type {ReadableStreamDefaultReader<Uint8Array> | undefined} */
  #reader;
  #isOver = false;
  /** When the writes began that aren't done yet. @type {number[]} */
  #writes = [];

  /** @param {SerialPort} port @param {import("./types").PortEvents} events */
  constructor(port, events) {
    this.#port = port;
    this.#events = events;
  }

  /** Whether the adapter has control lines; BRC can be wired to one. */
  hasSignals = false;

  /** Opens it; throws a `Failure`. @param {number} baudRate */
  async open(baudRate) {
    try {
      await within(OPEN_MS, this.#port.open({ baudRate, bufferSize: BUFFER_BYTES }));
    } catch (error) {
      throw cantOpen(/** @type {Error} */ (error));
    }
    // Opening can have changed the lines in either direction, depending on the system. BRC is wired to RTS, which is
    // released to be in a known state. DTR stays on, since adapters with a processor of their own send nothing without.
    this.hasSignals = await this.setBrc(false);
    this.#writer = this.#port.writable?.getWriter();
    this.#read();
  }

  /** Pulls RTS, and with it BRC, low (`true`), or lets go of it; says whether the adapter can. @param {boolean} isLow */
  async setBrc(isLow) {
    try {
      await within(CLOSE_MS, this.#port.setSignals({ dataTerminalReady: true, requestToSend: isLow }));
      return true;
    } catch {
      return false;
    }
  }

  /** @param {Uint8Array} bytes */
  write(bytes) {
    if (this.#isOver || !this.#writer || !bytes.length) return;
    const now = performance.now();
    if (this.#writes.length && now - this.#writes[0] > WRITE_MS) return this.#lose("The adapter no longer accepts data.");
    this.#writes.push(now);
    // Anything else than bytes would break the stream for good, and then closing hangs.
    this.#writer.write(Uint8Array.from(bytes)).then(
      () => this.#writes.shift(),
      (error) => this.#lose(said(error)),
    );
  }

  /** Sends what was written and closes, or gives up after a second: a dead adapter may never answer. */
  async close() {
    this.#isOver = true;
    await within(CLOSE_MS, this.#close()).catch(() => {});
  }

  async #close() {
    // Closing the writer should wait for what was written, but Chromium drops some of it, and the stop may be among that:
    // in 6 of 15 closings on a busy computer the robot didn't hear all, and in none of 15 with this pause.
    await new Promise((later) => setTimeout(later, LAST_WORDS_MS));
    await this.#writer?.close().catch(() => {});
    this.#writer?.releaseLock();
    await this.#reader?.cancel().catch(() => {});
    this.#reader?.releaseLock();
    await this.#port.close();
  }

  async #read() {
    let inVain = 0;
    let why = "The adapter no longer sends data.";
    while (!this.#isOver && this.#port.readable) {
      const reader = (this.#reader = this.#port.readable.getReader());
      try {
        for (;;) {
          const { value, done } = await reader.read();
          if (done) break;
          inVain = 0;
          if (!this.#isOver) this.#events.onbytes(value);
        }
      } catch (error) {
        const { name } = /** @type {Error} */ (error);
        const kind = RECOVERABLE[/** @type {keyof typeof RECOVERABLE} */ (name)];
        if (kind && !this.#isOver) this.#events.onerror(kind);
        why = said(error);
      }
      if (this.#isOver) return;
      reader.releaseLock();
      // A line that is held low reports breaks for ever.
      if (++inVain > 3) await new Promise((later) => setTimeout(later, 10));
    }
    this.#lose(why);
  }

  /** @param {string} why */
  #lose(why) {
    if (this.#isOver) return;
    void this.close();
    this.#events.onlost(why);
  }
}

/** @param {unknown} error */
function said(error) {
  const { name, message } = /** @type {Error} */ (error);
  return name === "NetworkError" ? "The adapter was unplugged." : `The adapter failed (${message}).`;
}

/** @param {Error} error */
function cantOpen({ name, message }) {
  if (name === "InvalidStateError") return failure("busy", "This page already has that port open.", "Disconnect first.");
  if (name === "SecurityError" || name === "NotAllowedError") {
    return failure("denied", "The browser no longer lets this page use that port.", "Connect again and choose it from the list.");
  }
  // Browsers don't say more than that it didn't work.
  if (name === "NetworkError") {
    return failure(
      "busy",
      "The port could not be opened: another program probably uses it.",
      "Close other programs that may use it, such as a serial monitor, a terminal or another browser. On Linux, your user also needs permission: sudo usermod -a -G dialout $USER, then log in again.",
    );
  }
  return failure("failed", `The port could not be opened (${message}).`, "Unplug the adapter, plug it in again, and connect.");
}

/** @template T @param {number} ms @param {Promise<T>} what @returns {Promise<T>} */
export function within(ms, what) {
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => reject(new Error(`no answer within ${ms / 1000} s`)), ms);
    what.then(resolve, reject).finally(() => clearTimeout(late));
  });
}
