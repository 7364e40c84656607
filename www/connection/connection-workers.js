// @ts-check
// The two workers of a connection, seen from the page: one drives, the other holds the line, and each watches the other.

/** @typedef {import("./types").FromConnection} FromConnection */

export class ConnectionWorkers {
  /** What they report by themselves. @type {(message: Exclude<FromConnection, { type: "answer" | "line-gone" | "driver-gone" | "line-broke" }>) => void} */
  onreport = () => {};
  /** They can't be used any more, and requests are answered by `false`. */
  onbroke = () => {};

  #module;
  /** @type {Worker} */
  #driver;
  /** @type {Worker} */
  #holder;
  #isBroken = false;
  #asked = 0;
  /** Pending requests by id. @type {Map<number, (value: boolean | string) => void>} */
  #waiting = new Map();

  /** @param {WebAssembly.Module} module workshop_bg.wasm, compiled */
  constructor(module) {
    this.#module = module;
    [this.#driver, this.#holder] = this.#start();
  }

  /** @returns {[driver: Worker, holder: Worker]} */
  #start() {
    const driver = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    const holder = new Worker(new URL("./line-worker.js", import.meta.url), { type: "module" });
    for (const either of [driver, holder]) {
      either.addEventListener("message", ({ data }) => this.#heard(data));
      either.addEventListener("error", (event) => this.#broke(event.message || "it could not be started"));
    }
    const { port1, port2 } = new MessageChannel();
    driver.postMessage({ type: "init", module: this.#module, holder: port1 }, [port1]);
    holder.postMessage({ type: "init", driver: port2 }, [port2]);
    return [driver, holder];
  }

  /** After an error of the program, the next connection has workers of its own. */
  revive() {
    if (!this.#isBroken) return;
    this.end();
    this.#isBroken = false;
    [this.#driver, this.#holder] = this.#start();
  }

  /** @param {import("./types").ToConnection} message */
  tell(message) {
    this.#driver.postMessage(message);
  }

  /** @param {Extract<import("./types").ToConnection, { id: number }>} message @returns {Promise<boolean | string>} */
  ask(message) {
    message.id = ++this.#asked;
    return new Promise((resolve) => {
      if (this.#isBroken) return resolve(false);
      this.#waiting.set(message.id, resolve);
      this.tell(message);
    });
  }

  /** Stops the robot past the driver. */
  stop() {
    this.#holder.postMessage({ type: "stop" });
  }

  end() {
    this.#driver.terminate();
    this.#holder.terminate();
  }

  /** @param {FromConnection} message */
  #heard(message) {
    if (message.type === "line-gone") this.#holder.terminate();
    else if (message.type === "driver-gone") {
      this.#driver.terminate();
      this.#broke("it stopped responding, and a stop command was sent");
    } else if (message.type === "line-broke") this.#broke(message.why);
    else if (message.type === "answer") {
      this.#waiting.get(message.id)?.(message.value);
      this.#waiting.delete(message.id);
    } else {
      if (message.type === "failed" && message.failure.kind === "broken") this.#broke();
      this.onreport(message);
    }
  }

  /** Nothing will be answered any more. @param {string} [why] */
  #broke(why) {
    this.#isBroken = true;
    this.onbroke();
    for (const answered of this.#waiting.values()) answered(false);
    this.#waiting.clear();
    if (why) this.onreport({ type: "failed", failure: { kind: "broken", what: `The connection's worker failed: ${why}.`, remedy: "Connect again, or reload the page." } });
  }
}
