// @ts-check
// Workers in the sandbox, and the watch over them: one that is silent for a second while it owes an answer is ended, and so
// is one that talks too much. What they say is as little to be trusted as the programs that they run.
import { openFrame } from "./frame.js";

/** Longest silence of a worker that owes an answer, ms. */
const PATIENCE = 1000;
/** Until MicroPython and the simulator are there, before any line of a program runs, ms. */
const START_PATIENCE = 20_000;
/** Most messages of one worker in a tenth of a second: it sends one for each slice of about 20 ms. */
const MOST_MESSAGES = 100;
const TICK = 50;

/**
 * @typedef {import("./types").ToWorker} ToWorker
 * @typedef {import("./types").FromWorker} FromWorker
 * @typedef {{ script: string, parts: Record<string, unknown> }} Kit What a worker is made of.
 */

/** The frame of all workers, once it is there. @type {HTMLIFrameElement | undefined} */
let home;
/** @type {Promise<HTMLIFrameElement> | undefined} */
let coming;
const frame = () => (coming ??= openFrame().then((it) => (home = it)));
let lastId = 0;

/** A worker in the sandbox; it is there before its script has run. */
export class Inmate {
  #id = (lastId += 1);
  #channel = new MessageChannel();
  /** Since when it owes an answer, ms; 0 if it owes none. */
  #owes = 0;
  /** Number of requests. */
  #asked = 0;
  #patience = START_PATIENCE;
  #count = 0;
  #isReady = false;
  #timer = 0;
  isAlive = true;

  /**
   * @param {Kit} kit
   * @param {(message: FromWorker) => void} tell
   * @param {(why: "silent" | "loud" | "broken", text: string) => void} ended
   */
  constructor(kit, tell, ended) {
    const port = this.#channel.port1;
    const end = (/** @type {"silent" | "loud" | "broken"} */ why, text = "") => {
      if (!this.isAlive) return;
      this.end();
      ended(why, text);
    };
    port.onmessage = ({ data }) => {
      if (!this.isAlive) return;
      this.#count += 1;
      if (this.#count > MOST_MESSAGES) return end("loud");
      if (data?.type === "ready") [this.#isReady, this.#patience] = [true, PATIENCE];
      this.#owes = data?.more === true || data?.heard !== this.#asked ? performance.now() : 0;
      tell(data);
    };
    this.#owes = performance.now();
    let ticks = 0;
    let lastTick = performance.now();
    this.#timer = setInterval(() => {
      const now = performance.now();
      // The page itself was busy or asleep: no fault of the worker's.
      if (now - lastTick > 4 * TICK && this.#owes) this.#owes += now - lastTick;
      lastTick = now;
      if ((ticks += 1) % 2 === 0) this.#count = 0;
      if (this.#owes && now - this.#owes > this.#patience) end("silent");
    }, TICK);
    this.#heard = ({ source, data }) => {
      if (data?.id === this.#id && data.broken && source === home?.contentWindow) end("broken", String(data.broken).slice(0, 300));
    };
    addEventListener("message", this.#heard);
    void frame().then((it) => {
      if (this.isAlive) it.contentWindow?.postMessage({ id: this.#id, ...kit }, "*", [this.#channel.port2]);
    });
  }

  /** @type {(event: MessageEvent) => void} */
  #heard;

  /** Asks for something that is answered. @param {ToWorker} message @param {number} patience Longest silence from now on, ms. */
  ask(message, patience = PATIENCE) {
    if (!this.isAlive) return;
    this.#owes ||= performance.now();
    this.#asked += 1;
    if (this.#isReady) this.#patience = patience;
    this.#channel.port1.postMessage(message);
  }

  /** Ends it at once, whatever it does. */
  end() {
    if (!this.isAlive) return;
    this.isAlive = false;
    clearInterval(this.#timer);
    removeEventListener("message", this.#heard);
    this.#channel.port1.close();
    void coming?.then((it) => it.contentWindow?.postMessage({ id: this.#id }, "*"));
  }
}
