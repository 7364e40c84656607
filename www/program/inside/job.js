// @ts-check
// A program at work: step after step of its simulation, as far as the page has asked for.

import { refuseImports } from "./imports.js";
import { Output } from "./output.js";

/**
 * @typedef {import("../types").ToWorker} ToWorker
 * @typedef {import("../types").FromWorker} FromWorker
 * @typedef {Extract<ToWorker, { type: "load" }>} Order
 * @typedef {object} Kit
 * @property {typeof import("../../../programs/javascript/runtime.js").load} load
 * @property {typeof import("@lezer/javascript").parser} parser
 * @property {{ wasm: WebAssembly.Module, files: Record<string, string> } | undefined} micropython
 * @property {() => void} allowText Lets the next text be evaluated.
 * @property {WebAssembly.Memory} memory
 * @property {typeof import("../../../program.js").ProgramRunner} ProgramRunner
 * @property {() => number} clock
 * @typedef {import("../../../program.js").ProgramRunner} Runner
 * @typedef {Awaited<ReturnType<Kit["load"]>>} Running
 */

/** A slice, ms; the first ones are short, so that there is something to see at once. */
const SLICE = 20;
const FIRST_SLICE = 6;
/** Steps between looks at the clock. */
const BATCH = 16;
/** Statements of a step, when lines are followed, after which it counts as endless. */
const BUDGET = 2_000_000;
/** Longest plan, twice its cells. */
const MOST_CELLS = 4_000_000;

export class Job {
  #kit;
  #order;
  #send;
  #again;
  /** @type {Runner | undefined} */
  #runner;
  /** @type {Running | undefined} */
  #program;
  #readings = new Float64Array();
  #until = 0;
  #slices = 0;
  #isScheduled = false;
  #isOver = false;
  #hasFailed = false;
  #output = new Output();
  /** Asked for: the state at a step. */
  #wanted = -1;

  /** @param {Kit} kit @param {Order} order @param {(message: FromWorker, transfer?: Transferable[]) => void} send @param {() => void} again Calls `slice` soon. */
  constructor(kit, order, send, again) {
    this.#kit = kit;
    this.#order = order;
    this.#send = send;
    this.#again = again;
  }

  async begin() {
    const { id, job, seed, facts, language, source, traced, breakpoints } = this.#order;
    try {
      const runner = new this.#kit.ProgramRunner(job, seed);
      this.#runner = runner;
      const { load, parser, micropython, allowText } = this.#kit;
      if (language === "javascript") refuseImports(source, parser);
      allowText();
      this.#program = await load({
        language, source, traced, breakpoints, budget: traced ? BUDGET : undefined, seed: runner.seed(), parser, micropython,
        name: language === "python" ? "program.py" : "program.js",
        facts: JSON.parse(facts ?? runner.facts()),
        layout: JSON.parse(this.#kit.ProgramRunner.layout()),
      });
      this.#send({ type: "loaded", id, kind: this.#program.kind });
    } catch (error) {
      this.#fail(error);
    }
  }

  /** @param {ToWorker} message @returns {boolean} Whether an answer will come. */
  hear(message) {
    if (message.type === "sense" && message.id === this.#order.id && this.#program && !this.#hasFailed) {
      this.#answer(message.readings);
      return true;
    }
    if (message.type === "plan" && message.id === this.#order.id && this.#program?.kind === "plan" && !this.#hasFailed) {
      try {
        this.#plan();
      } catch (error) {
        this.#fail(error);
      }
      return true;
    }
    if (message.type === "go" && message.id === this.#order.id && this.#program && !this.#hasFailed) {
      this.#until = Math.max(message.until, this.#order.from + 1);
      if (message.inspect) this.#wanted = message.until;
      this.#schedule();
      return true;
    }
    return false;
  }

  #schedule() {
    if (this.#isScheduled || !this.#program) return;
    this.#isScheduled = true;
    this.#again();
  }

  /** Runs for a while, then says how far it is. */
  slice() {
    this.#isScheduled = false;
    const [runner, program] = [this.#runner, this.#program];
    if (!runner || !program) return;
    const { clock } = this.#kit;
    const end = clock() + (this.#slices < 4 ? FIRST_SLICE : SLICE);
    this.#slices += 1;
    try {
      const { from } = this.#order;
      const until = runner.steps() < from ? from : this.#until;
      while (!this.#isOver && runner.steps() < until && clock() < end) {
        for (let n = 0; n < BATCH && !this.#isOver && runner.steps() < until; n += 1) this.#step(runner, program);
      }
      if (runner.steps() <= from && from > 0 && !this.#isOver) {
        // The page knows what is before.
        runner.take_log();
        this.#output.flush();
        this.#send({ type: "busy", id: this.#order.id, more: true });
        return this.#schedule();
      }
    } catch (error) {
      return this.#fail(error);
    }
    const more = !this.#isOver && runner.steps() < this.#until;
    this.#report(more);
    if (more) return this.#schedule();
    if (this.#wanted >= 0) this.#inspect(runner.steps());
  }

  /** @param {Runner} runner @param {Running} program */
  #step(runner, program) {
    const goesOn = program.step(this.#sensed(runner));
    if (program.output.length) this.#output.take(program.output, runner.steps());
    if (!goesOn) {
      runner.finish(false);
      this.#isOver = true;
    } else if (!runner.step(program.left, program.right)) this.#isOver = true;
  }

  /** The readings, where they are in memory. @param {Runner} runner */
  #sensed(runner) {
    if (this.#readings.length === 0) this.#readings = new Float64Array(this.#kit.memory.buffer, runner.readings_ptr(), runner.readings_len());
    return this.#readings;
  }

  /** @param {boolean} more */
  #report(more) {
    const runner = /** @type {Runner} */ (this.#runner);
    if (this.#order.isQuiet && more) return this.#send({ type: "busy", id: this.#order.id, more: true });
    const log = this.#order.isQuiet ? runner.log() : runner.take_log();
    const said = this.#output.flush();
    const output = this.#order.isQuiet ? [] : said;
    this.#send({ type: "ran", id: this.#order.id, log, steps: runner.steps(), output, isOver: this.#isOver, more: more || this.#wanted >= 0 }, [log.buffer]);
  }

  /** @param {number} step */
  #inspect(step) {
    this.#wanted = -1;
    const program = /** @type {Running} */ (this.#program);
    this.#send({ type: "state", id: this.#order.id, step, line: program.line, variables: program.variables().slice(0, 200) });
  }

  /** A robot that isn't simulated asks. @param {Float64Array} readings */
  #answer(readings) {
    const program = /** @type {Running} */ (this.#program);
    try {
      const isDone = !program.step(readings);
      program.output.length = 0;
      this.#send({ type: "drive", id: this.#order.id, left: program.left, right: program.right, isDone });
    } catch (error) {
      this.#fail(error);
    }
  }

  #plan() {
    const [runner, program] = [/** @type {Runner} */ (this.#runner), /** @type {Running} */ (this.#program)];
    /** @type {number[]} */
    const cells = [];
    for (const [x, y] of program.plan(JSON.parse(runner.room()))) {
      cells.push(x, y);
      if (cells.length > MOST_CELLS) throw { message: `The plan has more than ${MOST_CELLS / 2} cells. Let it end.`, line: program.line };
    }
    this.#output.take(program.output, 0);
    this.#isOver = true;
    this.#send({ type: "planned", id: this.#order.id, cells: new Uint32Array(cells), output: this.#output.flush() });
  }

  /** @param {unknown} error */
  #fail(error) {
    const runner = this.#runner;
    if (this.#isOver) return;
    this.#isOver = this.#hasFailed = true;
    const { message, line, column } = /** @type {{ message?: unknown, line?: unknown, column?: unknown }} */ (Object(error));
    const text = String(message ?? error).slice(0, 2000);
    try {
      if (runner && this.#program) {
        runner.finish(true);
        this.#report(true);
      }
    } catch {
      // The simulation itself is broken; the message says it.
    }
    this.#send({ type: "failed", id: this.#order.id, step: runner?.steps() ?? 0, message: text, line: Number(line) || 0, column: Number(column) || 0 });
  }

  close() {
    this.#runner?.free();
    this.#program = this.#runner = undefined;
  }
}
