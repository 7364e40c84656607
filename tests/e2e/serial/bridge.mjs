// `robovac bridge` as a program of its own, between a page and an emulated robot.
import { spawn } from "node:child_process";
import { robovac } from "./robot.mjs";

export class Bridge {
  /** Where it listens, with its token if there is one. */
  address = "";
  #child;
  #ended;

  /** Starts one for the test `t`, on an address other than the page's. Options are those of `robovac bridge`. */
  static async start(t, robot, ...options) {
    const bridge = new Bridge();
    const where = options.includes("--listen") ? [] : ["--listen", "127.0.0.2:0"];
    bridge.#child = spawn(robovac(), ["bridge", "--port", robot.pty, ...where, ...options], { stdio: ["ignore", "pipe", "inherit"] });
    bridge.#ended = new Promise((resolve) => bridge.#child.once("exit", resolve));
    t.after(() => bridge.end("SIGKILL"));
    let said = "";
    await new Promise((resolve, reject) => {
      bridge.#child.stdout.on("data", (text) => {
        said += text;
        const ready = /^ready (\S+)\n[^]*woken/m.exec(said);
        if (ready) resolve((bridge.address = ready[1]));
      });
      bridge.#ended.then((code) => reject(new Error(`the bridge ended with ${code}`)));
    });
    return bridge;
  }

  /** Ends it by a signal, and waits for that. */
  async end(signal) {
    this.#child.kill(signal);
    await this.#ended;
  }
}
