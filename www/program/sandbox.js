// @ts-check
// Workers in the sandbox, and the watch over them: one that is silent for a second while it owes an answer is ended, and so
// is one that talks too much. What they say is as little to be trusted as the programs that they run.
import { answers, openFrame } from "./frame.js";

/** Longest silence of a worker that owes an answer, ms. */
export const PATIENCE = 1000;
/** Until the first line of a program runs, ms: MicroPython, the simulator and the room take their time, which isn't its own. */
const START_PATIENCE = 20_000;
/** Most messages of one worker in a tenth of a second: it sends one for each slice of about 20 ms. */
const MOST_MESSAGES = 100;
const TICK = 50;
/** Longest time in which the frame answers, ms: it has nothing else to do. */
const FRAME_PATIENCE = 2000;

/** Why a worker was ended. @typedef {"silent" | "loud" | "broken" | "memory"} Why */
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
/** Puts another frame in the place of one that a program's memory has broken. @returns {Promise<boolean>} Whether it had to. */
async function mendFrame() {
  const before = frame();
  coming = before.then(async (it) => {
    if (await answers(it, FRAME_PATIENCE)) return it;
    it.remove();
    return (home = await openFrame());
  });
  return (await before) !== (await coming);
}
let lastId = 0;

/** A worker in the sandbox; it is there before its script has run. */
export class Inmate {
  #id = (lastId += 1);
  #channel = new MessageChannel();
  /** Since when it owes an answer, ms; 0 if it owes none. */
  #owes = 0;
  /** Number of requests. */
  #asked = 0;
  #patience = PATIENCE;
  /** Whether no line of the program has run yet. */
  #isStarting = true;
  #count = 0;
  #timer = 0;
  isAlive = true;

  /**
   * @param {Kit} kit
   * @param {(message: FromWorker) => void} tell
   * @param {(why: Why, text: string) => void} ended
   */
  constructor(kit, tell, ended) {
    const port = this.#channel.port1;
    const end = (/** @type {Why} */ why, text = "") => {
      if (!this.isAlive) return;
      this.end();
      ended(why, text);
    };
    const silent = async () => {
      this.#silence();
      end((await mendFrame()) ? "memory" : "silent");
    };
    let lastTick = performance.now();
    /** How long the page itself was busy or asleep before, ms: what was said meanwhile comes all at once. */
    let slept = 0;
    port.onmessage = ({ data }) => {
      if (!this.isAlive) return;
      const now = performance.now();
      this.#count += 1;
      if (this.#count > MOST_MESSAGES * Math.max(1, (slept + now - lastTick) / (2 * TICK))) return end("loud");
      if (data?.type === "begins") this.#isStarting = false;
      this.#owes = data?.more === true || data?.heard !== this.#asked ? now : 0;
      tell(data);
    };
    this.#owes = performance.now();
    let ticks = 0;
    this.#timer = setInterval(() => {
      const now = performance.now();
      const gap = now - lastTick;
      lastTick = now;
      if (gap > 4 * TICK) {
        slept = gap;
        if (this.#owes) this.#owes += gap;
      } else if ((ticks += 1) % 2 === 0) this.#count = slept = 0;
      if (this.#owes && now - this.#owes > (this.#isStarting ? START_PATIENCE : this.#patience)) void silent();
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

  /** Asks for something that is answered. @param {ToWorker} message @param {number} patience Longest silence of the program from now on, ms. */
  ask(message, patience = PATIENCE) {
    if (!this.isAlive) return;
    this.#owes ||= performance.now();
    this.#asked += 1;
    this.#patience = patience;
    if (message.type === "load") this.#isStarting = true;
    this.#channel.port1.postMessage(message);
  }

  /** Ends it at once, whatever it does. */
  end() {
    if (!this.isAlive) return;
    this.isAlive = false;
    this.#silence();
  }

  /** Its worker ends, and is no longer heard. */
  #silence() {
    clearInterval(this.#timer);
    removeEventListener("message", this.#heard);
    this.#channel.port1.close();
    void coming?.then((it) => it.contentWindow?.postMessage({ id: this.#id }, "*"));
  }
}
