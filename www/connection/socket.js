// @ts-check
// A line over a WebSocket, for bridges to the robot's serial line: `robovac bridge`, which watches this page and can set the
// baud rate; or an ESP's firmware, or websockify before ser2net. Binary messages hold the robot's bytes as they are.
import { closure, haltedBecause, isHello, misfit, wellFormed } from "./bridge-words.js";
import { dial } from "./dial.js";
import { takeLock } from "./lock.js";
import { failure } from "./ports.js";
import { within } from "./within.js";

/** Time limit for a bridge to take bytes, and time until a lost one is tried again, ms. */
const STALL_MS = 1500;
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
  /** The number of this page's turn to drive, until it is taken. */
  #turn = "";
  /** Whether the line hasn't been used by this page yet. */
  #isNew = true;

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
      [this.#unlock, this.#address] = [unlock, address];
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

  /** Takes the turn to drive: what is written from here on counts. To be called when all written before is outdated or sent. */
  take() {
    if (!this.#turn) return;
    this.#say(`take ${this.#turn}`);
    this.#turn = "";
    // The bridge may have been started at another rate.
    if (this.#isNew) void this.setBaud(115200);
    this.#isNew = false;
  }

  /** Has the bridge stop the robot, whoever drives it. */
  stop() {
    this.#say("stop");
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
    if (socket) await within(1000, new Promise((done) => (socket.addEventListener("close", done), socket.close()))).catch(() => {});
    this.#unlock();
  }

  async #connect() {
    const address = /** @type {URL} */ (this.#address);
    const { socket, early } = await dial(address);
    const refused = this.#isClosed ? "The connection was closed before it was established." : misfit(early[0]);
    if (refused) {
      socket.close();
      throw failure("failed", refused, "");
    }
    this.#isOurs = isHello(early[0]);
    [this.#turn, this.#isNew] = ["", true];
    // Until ours says that this page may drive, it doesn't.
    Object.assign(this.view, { can_baud: this.#isOurs, brc: this.#isOurs ? "high" : "none", baud: 115200, is_watching: this.#isOurs, state: "opening", text: "" });
    this.#socket = socket;
    for (const data of this.#isOurs ? early.slice(1) : early) this.#heard(data);
    this.view.state = "open";
    socket.onmessage = ({ data }) => this.#socket === socket && this.#heard(data);
    socket.onerror = null;
    socket.onclose = (event) => this.#socket === socket && this.#lose(closure(event).why);
  }

  /** @param {unknown} data */
  #heard(data) {
    if (typeof data !== "string") this.#events.onbytes(new Uint8Array(/** @type {ArrayBuffer} */ (data)));
    else if (this.#isOurs) this.#obey(data);
    else if (isHello(data)) this.#lose("The bridge answered too late.");
    else this.#events.onbytes(new TextEncoder().encode(data));
  }

  /** A message of `robovac bridge`. @param {string} text */
  #obey(text) {
    const [word, value = ""] = text.split(" ");
    // At once, and here: this is what shows that page and network are quick enough to drive.
    if (word === "beat") this.#say(`alive ${value}`);
    else if (word === "watch") this.#watches(true);
    else if (word === "drive") {
      this.#turn = value;
      if (!this.view.is_watching) return;
      this.#watches(false);
      // The robot is in this page's hands now, which begin as on any other line.
      if (this.view.state === "open") this.#events.onopened();
    } else if (word === "halted" && !this.view.is_watching) this.#events.onhalted?.(haltedBecause(value));
  }

  /** @param {boolean} isWatching */
  #watches(isWatching) {
    this.view.is_watching = isWatching;
    this.view.text = isWatching ? "Another client drives this robot. You are watching, and can stop it." : "";
  }

  /** @param {string} why */
  #lose(why) {
    this.#socket?.close();
    this.#socket = undefined;
    if (this.#isClosed) return;
    Object.assign(this.view, { state: "lost", is_watching: false, text: `${why} Retrying every ${AGAIN_MS / 1000} s.` });
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
        if (this.#isClosed || (kind !== "denied" && kind !== "failed")) continue;
        this.view.text = what;
        return this.#events.onlost(what, true);
      }
      this.view.returns += 1;
      this.#events.onopened();
    }
  }
}
