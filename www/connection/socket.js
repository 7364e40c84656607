// @ts-check
// A line over a WebSocket, for bridges to the robot's serial line: an ESP's firmware, or websockify before ser2net. Binary
// frames hold the robot's bytes as they are.
import { takeLock } from "./lock.js";
import { failure } from "./ports.js";
import { within } from "./serial-port.js";

/** Time limit for a bridge to answer, and to take bytes, ms. */
const OPEN_MS = 8000;
const STALL_MS = 1500;

/** When a bridge that was lost is tried again, ms. */
const AGAIN_MS = 2000;

/** @typedef {import("./types").Transport} Transport */

/** @implements {Transport} */
export class SocketLine {
  /** @type {import("./types").TransportView} */
  view;

  #url;
  #events;
  /** @type {WebSocket | undefined} */
  #socket;
  #isClosed = false;
  #unlock = () => {};
  /** Since when bytes wait to be sent. */
  #stalledAt = Infinity;

  /** @param {string} url @param {import("./types").TransportEvents} events */
  constructor(url, events) {
    this.#url = url;
    this.#events = events;
    this.view = {
      kind: "socket",
      state: "closed",
      name: url,
      text: "",
      baud: 115200,
      can_baud: false,
      is_own_usb: false,
      brc: "none",
      errors: { break: 0, framing: 0, parity: 0, overrun: 0 },
      returns: 0,
    };
  }

  async open() {
    this.view.state = "opening";
    try {
      const address = wellFormed(this.#url);
      const unlock = await takeLock(`bridge ${address.host}${address.pathname}`);
      if (!unlock) throw failure("busy", "Another tab of this page is connected to that robot.", "Disconnect there, or close that tab.");
      this.#unlock = unlock;
      await this.#connect();
    } catch (error) {
      await this.close();
      throw error;
    }
  }

  /** @param {Uint8Array} bytes */
  write(bytes) {
    const socket = this.#socket;
    if (socket?.readyState !== WebSocket.OPEN || !bytes.length) return;
    const now = performance.now();
    if (socket.bufferedAmount === 0) this.#stalledAt = now;
    else if (now - this.#stalledAt > STALL_MS) return this.#lose("The bridge no longer accepts data.");
    socket.send(Uint8Array.from(bytes));
  }

  /** The bridge's baud rate is its own affair. */
  async setBaud() {}

  /** Bridges have no way to say it. */
  async setBrc() {}

  async close() {
    this.#isClosed = true;
    this.view.state = "closed";
    const socket = this.#socket;
    this.#socket = undefined;
    if (socket) await within(1000, new Promise((done) => (socket.addEventListener("close", done), socket.close()))).catch(() => {});
    this.#unlock();
  }

  async #connect() {
    const socket = new WebSocket(this.#url);
    socket.binaryType = "arraybuffer";
    try {
      await within(OPEN_MS, new Promise((resolve, reject) => ((socket.onopen = resolve), (socket.onerror = socket.onclose = reject))));
    } catch {
      socket.close();
      // Browsers don't report the reason to pages.
      throw failure("unreachable", `The bridge at ${this.#url} doesn't answer.`, "Check that it is on and on the same network, and that address, port and path are right.");
    }
    if (this.#isClosed) {
      socket.close();
      throw failure("failed", "The connection was closed before it was established.", "");
    }
    const text = new TextEncoder();
    socket.onmessage = ({ data }) => this.#socket === socket && this.#events.onbytes(typeof data === "string" ? text.encode(data) : new Uint8Array(data));
    socket.onerror = null;
    socket.onclose = () => this.#socket === socket && this.#lose("The bridge closed the connection.");
    this.#socket = socket;
    this.view.state = "open";
    this.view.text = "";
  }

  /** @param {string} why */
  #lose(why) {
    this.#socket?.close();
    this.#socket = undefined;
    if (this.#isClosed) return;
    this.view.state = "lost";
    this.view.text = `${why} Retrying every ${AGAIN_MS / 1000} s.`;
    this.#events.onlost(why, false);
    void this.#comeBack();
  }

  async #comeBack() {
    while (!this.#isClosed && this.view.state === "lost") {
      await new Promise((later) => setTimeout(later, AGAIN_MS));
      if (this.#isClosed) return;
      try {
        await this.#connect();
      } catch {
        continue;
      }
      this.view.returns += 1;
      this.#events.onopened();
    }
  }
}

/** @param {string} text */
function wellFormed(text) {
  const url = URL.canParse(text) ? new URL(text) : null;
  if (!url || !/^wss?:$/.test(url.protocol)) {
    throw failure("failed", `"${text}" isn't the address of a bridge.`, "The address must begin with ws:// or wss://, as in ws://192.168.1.50:81/.");
  }
  // Browsers count this computer as safe.
  const isHere = /^(localhost|127\..*|\[::1\])$/.test(url.hostname);
  if (self.location.protocol === "https:" && url.protocol === "ws:" && !isHere) {
    throw failure(
      "mixed",
      "A page loaded over https:// can't connect to a bridge at ws://.",
      "Use a bridge with wss://, or open a copy of this page over http:// in your own network: for a bridge, that is enough.",
    );
  }
  return url;
}
