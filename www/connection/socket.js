// @ts-check
// A line over a WebSocket, for bridges to the robot's serial line: `robovac bridge`, which watches this page and can set the
// baud rate; or an ESP's firmware, or websockify before ser2net. Binary messages hold the robot's bytes as they are.
import { ALIVE_MS, closure, haltedBecause, isHello, wellFormed } from "./bridge-words.js";
import { unreachable } from "./local-network.js";
import { takeLock } from "./lock.js";
import { failure } from "./ports.js";
import { within } from "./serial-port.js";

/** Time limit for a bridge to answer, and to take bytes, ms. */
const OPEN_MS = 8000;
const STALL_MS = 1500;

/** How long a bridge's first message is waited for: only ours sends one, or closes the connection, ms. */
const HELLO_MS = 150;

/** When a bridge that was lost is tried again, ms. */
const AGAIN_MS = 2000;

/** @typedef {import("./types").Transport} Transport */

/** @implements {Transport} */
export class SocketLine {
  /** @type {import("./types").TransportView} */
  view;

  #url;
  /** @type {URL | undefined} */
  #address;
  #events;
  /** @type {WebSocket | undefined} */
  #socket;
  #isClosed = false;
  #unlock = () => {};
  /** Since when bytes wait to be sent. */
  #stalledAt = Infinity;
  /** Whether it is `robovac bridge`. */
  #isOurs = false;
  /** Why this page can't speak to the bridge. */
  #refused = "";
  /** @type {ReturnType<typeof setInterval> | undefined} */
  #beating;

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
      is_watching: false,
    };
  }

  async open() {
    this.view.state = "opening";
    try {
      const address = wellFormed(this.#url);
      const unlock = await takeLock(`bridge ${address.host}${address.pathname}`);
      if (!unlock) throw failure("busy", "Another tab of this page is connected to that robot.", "Disconnect there, or close that tab.");
      this.#unlock = unlock;
      this.#address = address;
      // A token is nobody's business.
      this.view.name = `${address.origin}${address.pathname}`;
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

  /** Other bridges' baud rate is their own affair. @param {number} baud */
  async setBaud(baud) {
    this.#say(`baud ${baud}`);
    if (this.#isOurs) this.view.baud = baud;
  }

  /** Other bridges have no way to say it. @param {boolean} isLow */
  async setBrc(isLow) {
    this.#say(`brc ${isLow ? "low" : "high"}`);
    if (this.#isOurs) this.view.brc = isLow ? "low" : "high";
  }

  /** @param {string} word */
  #say(word) {
    if (this.#isOurs && this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(word);
  }

  async close() {
    this.#isClosed = true;
    this.view.state = "closed";
    const socket = this.#socket;
    this.#socket = undefined;
    clearInterval(this.#beating);
    if (socket) await within(1000, new Promise((done) => (socket.addEventListener("close", done), socket.close()))).catch(() => {});
    this.#unlock();
  }

  async #connect() {
    const address = /** @type {URL} */ (this.#address);
    const socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    /** What came before the line was open. @type {MessageEvent[]} */
    const early = [];
    /** @type {CloseEvent | undefined} */
    let closed;
    try {
      await within(OPEN_MS, new Promise((resolve, reject) => ((socket.onopen = resolve), (socket.onerror = socket.onclose = reject))));
      await within(HELLO_MS, new Promise((resolve) => ((socket.onmessage = (message) => resolve(early.push(message))), (socket.onclose = (event) => resolve((closed = event)))))).catch(() => {});
    } catch {
      socket.close();
      throw await unreachable(address);
    }
    if (closed) {
      const { why, isForGood } = closure(closed);
      throw failure(isForGood ? "denied" : "unreachable", why, "");
    }
    if (this.#isClosed) {
      socket.close();
      throw failure("failed", "The connection was closed before it was established.", "");
    }
    this.#isOurs = false;
    Object.assign(this.view, { can_baud: false, brc: "none", baud: 115200, is_watching: false, state: "open", text: "" });
    this.#socket = socket;
    socket.onmessage = ({ data }) => this.#socket === socket && this.#heard(data);
    socket.onerror = null;
    socket.onclose = (event) => this.#socket === socket && this.#lose(closure(event).why);
    for (const { data } of early) this.#heard(data);
    if (this.#refused) throw failure("failed", this.#refused, "");
  }

  /** The line of `robovac bridge`, as it is at the beginning. */
  #greet() {
    this.#isOurs = true;
    this.view.can_baud = true;
    // An earlier client may have left it otherwise.
    void this.setBaud(115200);
    void this.setBrc(false);
    clearInterval(this.#beating);
    this.#beating = setInterval(() => this.#say("alive"), ALIVE_MS);
  }

  /** @param {unknown} data */
  #heard(data) {
    if (typeof data !== "string") this.#events.onbytes(new Uint8Array(/** @type {ArrayBuffer} */ (data)));
    else if (!this.#isOurs) {
      try {
        if (isHello(data)) this.#greet();
        else this.#events.onbytes(new TextEncoder().encode(data));
      } catch (why) {
        this.#refused = String(why);
        this.#lose(this.#refused);
      }
    } else if (data === "watch") this.#watches(true);
    else if (data === "drive" && this.view.is_watching) {
      this.#watches(false);
      this.#greet();
      // The robot is in this page's hands now, which begin as on any other line.
      this.#events.onopened();
    } else if (data.startsWith("halted ") && !this.view.is_watching) this.#events.onhalted?.(haltedBecause(data.slice(7)));
  }

  /** @param {boolean} isWatching */
  #watches(isWatching) {
    this.view.is_watching = isWatching;
    this.view.text = isWatching ? "Another client drives this robot. You are watching." : "";
  }

  /** @param {string} why */
  #lose(why) {
    this.#socket?.close();
    this.#socket = undefined;
    clearInterval(this.#beating);
    if (this.#isClosed) return;
    this.view.state = "lost";
    this.view.is_watching = false;
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
      } catch (error) {
        const { kind, what } = /** @type {import("./types").Failure} */ (error);
        if (kind !== "denied") continue;
        this.view.text = what;
        return this.#events.onlost(what, true);
      }
      this.view.returns += 1;
      this.#events.onopened();
    }
  }
}
