// @ts-check
// The run of a program: the sandbox runs ahead, and the playground drives what it has logged.
import { kitFor } from "./kit.js";
import { Inmate } from "./sandbox.js";
import { textOf } from "../messages.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("./own-programs.js").Program} Program
 * @typedef {import("./types").Output} Output
 * @typedef {import("./types").FromWorker} FromWorker
 * @typedef {{ message: string, line: number, column?: number, step: number }} Fault
 * @typedef {"idle" | "loading" | "running" | "stopped" | "failed"} State
 */

/** Length of a step, s. */
export const STEP = 0.015;
/** How far the sandbox runs ahead of what is shown, steps: half an hour. */
const AHEAD = 120_000;
/** Most output that is kept, and read of one message. */
const MOST_OUTPUT = 25_000;
const MOST_AT_ONCE = 25_000;
/** Longest silence of a planner, ms: it may think. */
const PLANNING = 10_000;

export class ProgramRun {
  #app;
  #tell;
  /** @type {Inmate | undefined} */
  #inmate;
  /** What the worker can run besides JavaScript. */
  #hasPython = false;
  #order = 0;
  #version = -1;
  #asked = 0;
  #isOver = false;
  /** @type {(() => void) | undefined} Called once the program is loaded. */
  #loaded;
  /** Where an endless loop is looked for. */
  #isSearching = false;
  #met = 0;
  /** The request that a planner works for, and when it began; -1 for none. */
  #planId = -1;
  #began = 0;
  /** @type {Program | undefined} */
  program;
  /** @type {{ line: number, condition?: string }[]} */
  breakpoints = [];
  /** @type {State} */
  state = "idle";
  /** @type {Fault | undefined} */
  fault;
  /** What it printed and drew, in the order of time. @type {Output[]} */
  output = [];
  /** Changes with the output. */
  outputVersion = 0;

  /** @param {App} app @param {() => void} tell Called when state or fault have changed. */
  constructor(app, tell) {
    this.#app = app;
    this.#tell = tell;
    const frame = () => {
      requestAnimationFrame(frame);
      this.#frame();
    };
    requestAnimationFrame(frame);
  }

  /** Runs a program from the start of the room. @param {Program} program @param {boolean} plays */
  async start(program, plays) {
    this.program = program;
    this.#set("loading", undefined);
    this.#version = this.#planId = -1;
    this.#loaded = () => {
      this.#app.act((p) => p.reset());
      if (plays) this.#app.act((p) => p.play());
    };
    await this.#launch(0);
  }

  /** A program that the session has chosen already: it runs as soon as it is asked for. @param {Program} program */
  adopt(program) {
    this.program = program;
    this.#version = -1;
    this.#set("running", undefined);
  }

  /** Ends it now; what was simulated stays. */
  stop() {
    this.#inmate?.end();
    this.#order += 1;
    this.#app.act((p) => p.pause());
    if (this.state !== "failed") this.#set("stopped", undefined);
  }

  /** @param {State} state @param {Fault | undefined} fault */
  #set(state, fault) {
    this.state = state;
    this.fault = fault;
    this.#tell();
  }

  /** The worker, a new one if there is none that can run the language. @param {boolean} isPython */
  async #hire(isPython) {
    if (this.#inmate?.isAlive && (this.#hasPython || !isPython)) return this.#inmate;
    this.#inmate?.end();
    const kit = await kitFor(isPython ? "python" : "javascript");
    this.#hasPython = isPython;
    this.#inmate = new Inmate(kit, (message) => this.#hear(message), (why, text) => this.#ended(why, text));
    return this.#inmate;
  }

  /** @param {number} from Step before which everything is known. @param {boolean} [traced] */
  async #launch(from, traced = this.breakpoints.length > 0) {
    const program = this.program;
    if (!program) return;
    const order = (this.#order += 1);
    this.#isOver = false;
    this.#asked = 0;
    this.output = this.output.filter(({ step = 0 }) => step < from);
    this.outputVersion += 1;
    try {
      const inmate = await this.#hire(program.language === "python");
      if (order !== this.#order) return;
      const { playground } = this.#app;
      const { language, source } = program;
      inmate.ask({ type: "load", id: order, language, source, job: playground.program_job(), traced, breakpoints: this.breakpoints, from });
    } catch (error) {
      if (order === this.#order) this.#set("failed", { message: `The program could not be started (${textOf(error)}). Check the connection, then press Run.`, line: 0, step: 0 });
    }
  }

  /** @param {FromWorker} message */
  #hear(message) {
    if (message?.type === "ready" || !("id" in Object(message)) || message.id !== this.#order) return;
    switch (message.type) {
      case "loaded":
        return this.#begin(message.kind);
      case "ran":
        return this.#take(message);
      case "planned":
        return this.#planned(message);
      case "failed": {
        const fault = { message: String(message.message).slice(0, 2000), line: Number(message.line) || 0, column: Number(message.column) || 0, step: Number(message.step) || 0 };
        this.#isOver = true;
        this.#isSearching = false;
        if (this.#planId >= 0) this.#app.act((p) => p.plan_failed(this.#planId, fault.message));
        return this.#set("failed", fault);
      }
    }
  }

  /** It is loaded: the playground takes it. @param {"step" | "run" | "plan"} kind */
  #begin(kind) {
    const { program } = this;
    if (!program) return;
    if (this.#planId >= 0 && kind === "plan") {
      this.#began = performance.now();
      return this.#inmate?.ask({ type: "plan", id: this.#order }, PLANNING);
    }
    if (this.#isSearching) return this.#goOn();
    if (this.#loaded) {
      const { name, language, source } = program;
      const worked = this.#app.act((p) => p.set_program(name, language, kind === "plan" ? "planner" : "behaviour", source, true));
      const start = this.#loaded;
      this.#loaded = undefined;
      if (!worked) return this.stop();
      start();
      this.#app.view = this.#app.playground.view();
      this.#version = this.#app.view.program?.version ?? -1;
    }
    this.#set("running", undefined);
    if (kind !== "plan") this.#goOn();
  }

  /** The session wants the plan of the program for its room. @param {import("../worker-types").PlanRequest} request */
  plan({ id }) {
    this.#planId = id;
    void this.#launch(0);
  }

  /** @param {Extract<FromWorker, { type: "planned" }>} message */
  #planned({ cells, output }) {
    const id = this.#planId;
    this.#planId = -1;
    if (!(cells instanceof Uint32Array) || id < 0) return;
    this.#keep(output);
    this.#app.act((p) => p.plan_finished(id, cells, (performance.now() - this.#began) / 1000, [], undefined));
  }

  /** @param {Extract<FromWorker, { type: "ran" }>} message */
  #take({ log, output, isOver }) {
    this.#isOver = isOver === true;
    if (this.#isSearching || !(log instanceof Uint8Array)) return;
    if (log.length) this.#app.act((p) => void p.extend_program(this.#version, log));
    this.#keep(output);
  }

  /** @param {unknown} output What the worker says that was printed and drawn. */
  #keep(output) {
    if (!Array.isArray(output) || !output.length) return;
    const room = Math.max(0, Math.min(MOST_AT_ONCE, MOST_OUTPUT - this.output.length));
    this.output.push(...output.slice(0, room).filter((one) => typeof one?.kind === "string" && Number.isFinite(one.step)));
    this.outputVersion += 1;
  }

  /** Lets it run on, if what is ahead is used up. */
  #goOn() {
    if (this.#isOver || this.state === "loading") return;
    const shown = Math.round(this.#app.view.time_s / STEP);
    if (this.#asked && this.#asked - shown > AHEAD / 2) return;
    // An endless loop is looked for as far as it was met.
    this.#asked = Math.max(shown + AHEAD, this.#isSearching ? this.#met : 0);
    this.#inmate?.ask({ type: "go", id: this.#order, until: this.#asked });
  }

  /** The worker was ended. @param {"silent" | "loud" | "broken"} why @param {string} text */
  #ended(why, text) {
    const shown = this.#app.view.program?.reach_steps ?? 0;
    const message = {
      silent: "This line never lets go: a step of the program took longer than 1 s and was ended. Drive a little in each step, and let loops end.",
      loud: "The program sent too much at a time and was ended.",
      broken: `The program's worker broke down (${text}). It may have used too much memory. Press Run to start again.`,
    }[why];
    this.#isOver = true;
    // The line is looked for once, by running the same again and following each line.
    const isKnown = why !== "silent" || this.#isSearching;
    if (!isKnown) {
      this.#set("failed", { message: message.replace("This line", "A line of the program"), line: 0, step: shown });
      this.#isSearching = true;
      this.#met = this.#asked;
      void this.#launch(0, true);
      return;
    }
    this.#isSearching = false;
    if (this.#planId >= 0) this.#app.act((p) => p.plan_failed(this.#planId, "it took too long"));
    if (this.state !== "failed") this.#set("failed", { message, line: 0, step: shown });
  }

  #frame() {
    const { program } = this.#app.view;
    if (!program || program.reach_steps === null || this.#isSearching || this.state === "loading" || this.state === "idle") return;
    if (program.version !== this.#version && this.state !== "stopped") {
      // Another room, seed or robot, or somebody's hand: the same program, from there on.
      this.#version = program.version;
      this.#set("running", undefined);
      void this.#launch(program.reach_steps ?? 0);
      return;
    }
    if (this.state === "running") this.#goOn();
  }
}
