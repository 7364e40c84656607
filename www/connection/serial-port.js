// @ts-check
// One opening of a serial port: bytes both ways until it is closed or lost.
import { AdapterPort, CLOSE_MS, OPEN_MS } from "./adapter-port.js";
import { failure } from "./ports.js";
import { within } from "./within.js";

/** Room for what arrives while this worker is busy: 1.4 s at 115200 baud. Browsers' default of 255 bytes is 22 ms. */
const BUFFER_BYTES = 16384;

/** Errors that adapters recover from: the stream ends, and there is a new one. */
const RECOVERABLE = /** @type {const} */ ({ BreakError: "break", FramingError: "framing", ParityError: "parity", BufferOverrunError: "overrun" });

/** @typedef {import("./types").OpenablePort} OpenablePort */

/** @implements {OpenablePort} */
export class OpenPort extends AdapterPort {
  #port;
  /** @type {WritableStreamDefaultWriter<Uint8Array> | undefined} */
  #writer;
  /** @type {ReadableStreamDefaultReader<Uint8Array> | undefined} */
  #reader;
  /** @param {SerialPort} port @param {import("./types").PortEvents} events */
  constructor(port, events) {
    super(events);
    this.#port = port;
  }

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

  /** @override @param {Uint8Array<ArrayBuffer>} bytes */
  send(bytes) {
    // Anything else than bytes would break the stream for good, and then closing hangs.
    return this.#writer?.write(bytes);
  }

  /** @override */
  async proceed() {
    await this.#port.getSignals().catch(() => {});
  }

  /** @override */
  async shut() {
    // Closing the writer should wait for what was written, but a busy Chromium may drop all of it, the stop too: without a pause the
    // robot heard nothing in 6 of 10 rounds of five closings. Therefore the robot's silence comes first.
    await this.#writer?.close().catch(() => {});
    this.#writer?.releaseLock();
    await this.#reader?.cancel().catch(() => {});
    this.#reader?.releaseLock();
    await this.#port.close();
  }

  async #read() {
    let inVain = 0;
    let why = "The adapter no longer sends data.";
    while (!this.isOver && this.#port.readable) {
      const reader = (this.#reader = this.#port.readable.getReader());
      try {
        for (;;) {
          const { value, done } = await reader.read();
          if (done) break;
          inVain = 0;
          this.arrived(value);
        }
      } catch (error) {
        const { name } = /** @type {Error} */ (error);
        const kind = RECOVERABLE[/** @type {keyof typeof RECOVERABLE} */ (name)];
        if (kind && !this.isOver) this.events.onerror(kind);
        why = this.said(error);
      }
      if (this.isOver) return;
      reader.releaseLock();
      // A line that is held low reports breaks for ever.
      if (++inVain > 3) await new Promise((later) => setTimeout(later, 10));
    }
    this.lose(why);
  }
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
