// @ts-check
// A line over a serial adapter, in this worker, which comes back when the adapter is plugged in again.
import { takeLock } from "./lock.js";
import { failure, findPort, isOwnUsb, portName } from "./ports.js";

/** Interval of searches for a lost port if the browser doesn't report it, ms. */
const LOOK_MS = 1000;

/** @typedef {import("./types").Transport} Transport */

/**
 * @template P A port.
 * @implements {Transport}
 */
export class SerialLine {
  /** @type {import("./types").TransportView} */
  view;

  #access;
  #address;
  #events;
  #id;
  /** @type {import("./types").OpenablePort | undefined} */
  #line;
  /** @type {P | undefined} */
  #port;
  #isClosed = false;
  #unlock = () => {};
  /** Ports that were there besides: when ours comes back, it is none of them. @type {P[]} */
  #others = [];
  #wake = () => {};

  /** @param {import("./types").PortAccess<P>} access @param {import("./types").PortAddress} address @param {import("./types").TransportEvents} events */
  constructor(access, address, events) {
    this.#access = access;
    this.#address = address;
    this.#events = events;
    this.#id = address.ids[address.index];
    this.view = {
      kind: "serial",
      state: "closed",
      name: portName(this.#id),
      text: "",
      baud: 115200,
      can_baud: !isOwnUsb(this.#id),
      is_own_usb: isOwnUsb(this.#id),
      brc: "none",
      errors: { break: 0, framing: 0, parity: 0, overrun: 0 },
      returns: 0,
      is_watching: false,
    };
  }

  async open() {
    this.view.state = "opening";
    try {
      const { ids, index } = this.#address;
      const place = ids.slice(0, index).filter((id) => id === this.#id).length;
      const unlock = await takeLock(`${this.#access.kind} port ${this.#id} ${place}`);
      if (!unlock) throw failure("busy", "Another tab of this page is connected to that robot.", "Disconnect there, or close that tab.");
      this.#unlock = unlock;
      this.#port = await findPort(this.#access, this.#address);
      this.#others = (await this.#access.list()).filter((port) => port !== this.#port);
      await this.#openPort(this.#port);
    } catch (error) {
      await this.close();
      throw error;
    }
  }

  /** @param {Uint8Array} bytes */
  write(bytes) {
    this.#line?.write(bytes);
  }

  /** Ports of Web Serial can't change their rate while they are open. @param {number} baud */
  async setBaud(baud) {
    this.view.baud = baud;
    const line = this.#line;
    if (!line || !this.#port) return;
    this.#line = undefined;
    await line.close();
    try {
      if (!this.#isClosed) await this.#openPort(this.#port);
    } catch (error) {
      this.#lose(/** @type {import("./types").Failure} */ (error).what);
    }
  }

  /** @param {boolean} isLow */
  async setBrc(isLow) {
    if (!this.view.is_own_usb && (await this.#line?.setBrc(isLow))) this.view.brc = isLow ? "low" : "high";
  }

  async close() {
    this.#isClosed = true;
    this.#wake();
    this.view.state = "closed";
    const line = this.#line;
    this.#line = undefined;
    await line?.close();
    this.#unlock();
  }

  /** @param {P} port */
  async #openPort(port) {
    const line = this.#access.open(port, {
      onbytes: this.#events.onbytes,
      onerror: (kind) => (this.view.errors[kind] += 1),
      onlost: (why) => this.#line === line && this.#lose(why),
    });
    await line.open(this.view.baud);
    if (this.#isClosed) {
      await line.close();
      throw failure("failed", "The connection was closed before it was established.", "");
    }
    this.#line = line;
    this.#port = port;
    this.view.brc = line.hasSignals && !this.view.is_own_usb ? "high" : "none";
    this.view.state = "open";
    this.view.text = "";
  }

  /** @param {string} why */
  #lose(why) {
    if (this.#isClosed) return;
    this.#line = undefined;
    this.view.state = "lost";
    this.view.text = `${why} Plug it in again. If it isn't found, connect again: browsers forget adapters without a serial number.`;
    this.#events.onlost(why, false);
    void this.#comeBack();
  }

  /** Reopens the port as soon as it is back, which is another object by then; without asking, as nothing moves by that.
   */
  async #comeBack() {
    const connected = () => this.#wake();
    const source = this.#access.source();
    source.addEventListener("connect", connected);
    try {
      while (!this.#isClosed && this.view.state === "lost") {
        await new Promise((/** @type {(value: void) => void} */ resolve) => {
          this.#wake = () => resolve();
          setTimeout(resolve, LOOK_MS);
        });
        const ports = await this.#access.list();
        const port = ports.find((port) => this.#access.id(port) === this.#id && !this.#others.includes(port));
        if (!port || this.#isClosed) continue;
        // A robot that was lost can be at any rate, so the diagnosis starts again.
        this.view.baud = 115200;
        try {
          await this.#openPort(port);
        } catch {
          // Right after plugging in, the system can still be busy with it.
          continue;
        }
        this.view.returns += 1;
        this.#events.onopened();
      }
    } finally {
      source.removeEventListener("connect", connected);
    }
  }
}
