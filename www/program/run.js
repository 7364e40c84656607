// @ts-check
// The run of a program: the sandbox runs ahead, and the playground drives what it has logged.
import { textOf } from "../messages.js";
import { Doubt, THINKING } from "./doubt.js";
import { endOf, faultOf } from "./faults.js";
import { Hired } from "./hired.js";
import { Said } from "./said.js";
import { Stage } from "./stage.js";

/**
 * @typedef {import("./own-programs.js").Program} Program
 * @typedef {import("./types").FromWorker} FromWorker
 * @typedef {import("./faults.js").Fault} Fault
 * @typedef {"idle" | "loading" | "running" | "stopped" | "failed"} State
 */

/** How far the sandbox runs ahead of what is shown, steps: half an hour. */
const AHEAD = 120_000;

export class ProgramRun {
  #app;
  #tell;
  #stage;
  #hired = new Hired((message) => this.#hear(message), (why, text) => this.#ended(why, text));
  #doubt = new Doubt();
  #order = 0;
  #asked = 0;
  #isOver = false;
  /** The program isn't on the floor yet: whether it then plays. @type {boolean | undefined} */
  #plays;
  /** @type {Program | undefined} */
  program;
  /** @type {{ line: number, condition?: string }[]} */
  breakpoints = [];
  /** @type {State} */
  state = "idle";
  /** @type {Fault | undefined} */
  fault;
  said = new Said();

  /** @param {import("../main.js").App} app @param {() => void} tell Called when state or fault have changed. */
  constructor(app, tell) {
    this.#app = app;
    this.#tell = tell;
    this.#stage = new Stage(app);
  }

  /** Runs a program from the start of the room. @param {Program} program @param {boolean} plays */
  async start(program, plays) {
    // What one program has done to its worker is none of another's business, nor is a loop whose line is looked for.
    if (program.id !== this.program?.id || this.#doubt.until) this.#hired.end();
    this.program = program;
    this.#set("loading", undefined);
    this.#doubt.reset();
    this.#plays = plays;
    await this.#launch(0);
  }

  /** A program that the session has chosen already: it runs as soon as it is asked for. @param {Program} program */
  adopt(program) {
    this.program = program;
    this.#stage.forget();
    this.#set("running", undefined);
  }

  /** Ends it now; what was simulated stays. */
  stop() {
    this.#hired.end();
    this.#order += 1;
    this.#doubt.reset();
    this.#plays = undefined;
    this.#stage.fail("it was stopped");
    this.#stage.pause();
    if (this.state !== "failed") this.#set("stopped", undefined);
  }

  /** @param {State} state @param {Fault | undefined} fault */
  #set(state, fault) {
    this.state = state;
    this.fault = fault;
    this.#tell();
  }

  /** @param {number} from Step before which everything is known. @param {boolean} [traced] */
  async #launch(from, traced = this.breakpoints.length > 0) {
    const program = this.program;
    if (!program) return;
    const order = (this.#order += 1);
    [this.#isOver, this.#asked] = [false, 0];
    this.said.cut(from);
    try {
      const inmate = await this.#hired.of(program.language);
      if (order !== this.#order) return;
      const { language, source } = program;
      inmate.ask({ type: "load", id: order, language, source, job: this.#stage.job, traced, breakpoints: this.breakpoints, from }, this.#doubt.limit);
    } catch (error) {
      if (order === this.#order) this.#fail({ message: `The program could not be started (${textOf(error)}). Check the connection, then press Run.`, line: 0, step: 0 });
    }
  }

  /** @param {FromWorker} message */
  #hear(message) {
    if (message?.type === "ready" || !("id" in Object(message)) || message.id !== this.#order) return;
    if (message.type === "loaded") this.#begin(message.kind);
    else if (message.type === "ran") this.#take(message);
    else if (message.type === "planned") this.#planned(message);
    else if (message.type === "failed") this.#fail(faultOf(message));
  }

  /** @param {Fault} fault */
  #fail(fault) {
    const isEarly = this.#plays !== undefined;
    this.#isOver = true;
    this.#doubt.until = 0;
    this.#plays = undefined;
    this.#stage.fail(fault.message, isEarly);
    this.#set("failed", { ...fault, isEarly });
  }

  /** It is loaded: the playground takes it. @param {"step" | "run" | "plan"} kind */
  #begin(kind) {
    const program = /** @type {Program} */ (this.program);
    if (this.#plays !== undefined) {
      // It took long to load, but does.
      if (this.#doubt.until) return this.#acquit();
      const plays = this.#plays;
      this.#plays = undefined;
      if (!this.#stage.enter(program, kind, plays)) return this.stop();
    } else if (this.#stage.wantsPlan && kind === "plan") {
      this.#stage.planning();
      return this.#hired.inmate?.ask({ type: "plan", id: this.#order }, THINKING);
    }
    if (!this.#doubt.until) this.#set("running", undefined);
    if (kind !== "plan") this.#goOn();
  }

  /** The session wants the plan of the program for its room. @param {import("../worker-types").PlanRequest} request */
  plan(request) {
    this.#stage.ask(request);
    // A start that is under way comes first; the session then asks again.
    if (this.#plays === undefined) void this.#launch(0);
  }

  /** @param {Extract<FromWorker, { type: "planned" }>} message */
  #planned({ cells, output }) {
    if (!(cells instanceof Uint32Array) || !this.#stage.wantsPlan) return;
    this.#doubt.until = 0;
    this.#set("running", undefined);
    this.said.keep(output);
    this.#stage.planned(cells);
  }

  /** @param {Extract<FromWorker, { type: "ran" }>} message */
  #take({ log, output, isOver, more }) {
    this.#isOver = isOver === true;
    if (this.#doubt.until) return more === true ? undefined : this.#acquit();
    if (!(log instanceof Uint8Array)) return;
    this.#stage.extend(log);
    this.said.keep(output);
  }

  /** Lets it run on, if what is ahead is used up. */
  #goOn() {
    if (this.#isOver || this.state === "loading") return;
    const { shown } = this.#stage;
    if (this.#asked && (this.#doubt.until || this.#asked - shown > AHEAD / 2)) return;
    this.#asked = this.#doubt.until || shown + AHEAD;
    this.#hired.inmate?.ask({ type: "go", id: this.#order, until: this.#asked }, this.#doubt.limit);
  }

  /** The worker was ended. @param {import("./hired.js").Why} why @param {string} text */
  #ended(why, text) {
    const end = endOf(why, text, this.#stage.reach);
    if (why !== "silent" || this.#doubt.until) return this.#fail(end);
    this.#doubt.begin(end.step, this.#asked);
    if (this.#plays === undefined) this.#set("failed", { ...end, message: "A step of the program took too long and was ended. Looking for its line…" });
    void this.#launch(0, true);
  }

  /** No step is endless: it goes on with more time. */
  #acquit() {
    const [message, step] = [this.#doubt.end(), this.#stage.reach];
    if (message) return this.#fail({ message, line: 0, step });
    if (this.#plays !== undefined) return void this.#launch(0);
    this.#set("running", undefined);
    void this.#launch(step);
  }

  /** In every frame. */
  frame() {
    const { program } = this.#app.view;
    if (!program || program.reach_steps === null || this.#doubt.until || this.state === "loading" || this.state === "idle") return;
    const isNew = this.state === "stopped" ? this.#stage.isResumed() : this.#stage.changes();
    if (isNew) {
      this.#set("running", undefined);
      void this.#launch(program.reach_steps);
    } else if (this.state === "running") this.#goOn();
    else if (program.waits && this.#app.view.state === "playing") this.#stage.pause();
  }
}
