// @ts-check
// One worker at a time, for one user's program after the other.
import { kitFor } from "./kit.js";
import { Inmate } from "./sandbox.js";

/**
 * @typedef {import("./types").FromWorker} FromWorker
 * @typedef {import("./sandbox.js").Why} Why
 */

export class Hired {
  /** @type {Inmate | undefined} */
  #inmate;
  /** What it can run besides JavaScript. */
  #hasPython = false;
  #hear;
  #ended;

  /** @param {(message: FromWorker) => void} hear @param {(why: Why, text: string) => void} ended */
  constructor(hear, ended) {
    this.#hear = hear;
    this.#ended = ended;
  }

  /** The one that is there, if it lives. */
  get inmate() {
    return this.#inmate?.isAlive ? this.#inmate : undefined;
  }

  /** A new one if there is none that can run the language. @param {import("./editor.js").Language} language @returns {Promise<Inmate>} */
  async of(language) {
    const known = this.inmate;
    if (known && (this.#hasPython || language === "javascript")) return known;
    this.end();
    const kit = await kitFor(language);
    // Somebody else may have waited for the same.
    this.end();
    this.#hasPython = language === "python";
    return (this.#inmate = new Inmate(kit, this.#hear, this.#ended));
  }

  /** Ends it now. */
  end() {
    this.#inmate?.end();
  }
}
