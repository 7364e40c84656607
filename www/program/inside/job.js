// @ts-check
// A program at work for the page: what it asks for, and what it is told.
import { cellsOf } from "./cells.js";
import { Drive } from "./drive.js";
import { refuseImports } from "./imports.js";
import { Output } from "./output.js";

/**
 * @typedef {import("../types").ToWorker} ToWorker
 * @typedef {import("../types").FromWorker} FromWorker
 * @typedef {Extract<ToWorker, { type: "load" }>} Order
 * @typedef {import("./drive.js").Runner} Runner
 * @typedef {import("./drive.js").Program} Program
 */

/** A slice, ms; the first ones are short, so that there is something to see at once. */
const SLICE = 20;
const FIRST_SLICE = 6;
/** Statements of a step, when lines are followed, after which it counts as endless. */
const BUDGET = 2_000_000;

export class Job {
  #kit;
  #order;
  #send;
  #soon;
  /** @type {Runner | undefined} */
  #runner;
  /** @type {Program | undefined} */
  #program;
  /** @type {Drive | undefined} There once the program is loaded. */
  #drive;
  #until = 0;
  #slices = 0;
  #isScheduled = false;
  #hasFailed = false;
  #output = new Output();
  /** The page looks into it, at a step: nothing else is told. */
  #inspects = false;

  /** @param {import("./kit").Kit} kit @param {Order} order @param {(message: FromWorker, transfer?: Transferable[]) => void} send @param {() => void} soon Calls `slice` soon. */
  constructor(kit, order, send, soon) {
    this.#kit = kit;
    this.#order = order;
    this.#send = send;
    this.#soon = soon;
  }

  async begin() {
    const { id, job, seed, facts, language, source, traced, breakpoints } = this.#order;
    const { ProgramRunner, rooms, load, parser, micropython, allowText, memory, clock } = this.#kit;
    this.close();
    this.#hasFailed = false;
    try {
      const runner = rooms.runner(job, seed);
      this.#runner = runner;
      if (language === "javascript") refuseImports(source, parser);
      allowText();
      const program = await load({
        language, source, traced, breakpoints, budget: traced ? BUDGET : undefined, seed: runner.seed(), parser, micropython,
        name: language === "python" ? "program.py" : "program.js",
        facts: JSON.parse(facts ?? runner.facts()),
        layout: JSON.parse(ProgramRunner.layout()),
        begins: () => this.#send({ type: "begins", id, more: true }),
      });
      if (this.#runner !== runner) return;
      this.#program = program;
      this.#drive = new Drive(runner, program, memory, clock, this.#output);
      this.#send({ type: "loaded", id, kind: program.kind });
    } catch (error) {
      this.#fail(error);
    }
  }

  /** @param {ToWorker} message @returns {boolean} Whether an answer will come. */
  hear(message) {
    const drive = this.#drive;
    if (message.id !== this.#order.id || !drive) return false;
    if (message.type === "go" && message.inspect) this.#visit(drive, message.until);
    else if (this.#hasFailed) return false;
    else if (message.type === "go") {
      this.#until = Math.max(message.until, this.#order.from + 1);
      this.#schedule();
    } else if (message.type === "sense") this.#answer(message.readings, message.before);
    else if (message.type === "plan" && this.#program?.kind === "plan") this.#plan();
    else return false;
    return true;
  }

  #schedule() {
    if (this.#isScheduled || !this.#drive) return;
    this.#isScheduled = true;
    this.#soon();
  }

  /** Runs for a while, then says how far it is. */
  slice() {
    this.#isScheduled = false;
    const [drive, { id, from }] = [this.#drive, this.#order];
    if (!drive) return;
    const end = this.#kit.clock() + (this.#slices < 4 ? FIRST_SLICE : SLICE);
    this.#slices += 1;
    try {
      const isBefore = drive.steps < from;
      drive.advance(isBefore ? from : this.#until, end, this.#inspects);
      if (isBefore && !drive.isOver) {
        // The page knows what is before.
        this.#runner?.take_log();
        this.#output.flush();
        this.#send({ type: "busy", id, more: true });
        return this.#schedule();
      }
    } catch (error) {
      return this.#fail(error);
    }
    const more = !drive.isOver && drive.steps < this.#until;
    if (!this.#inspects) this.#report(more);
    else if (more) this.#send({ type: "busy", id, more });
    else this.#inspect(drive);
    if (more) this.#schedule();
  }

  /** @param {boolean} more */
  #report(more) {
    const [runner, { id, isQuiet }] = [/** @type {Runner} */ (this.#runner), this.#order];
    if (isQuiet && more) return this.#send({ type: "busy", id, more: true });
    const log = isQuiet ? runner.log() : runner.take_log();
    const said = this.#output.flush();
    this.#send({ type: "ran", id, log, digest: more ? "" : runner.digest(), steps: runner.steps(), output: isQuiet ? [] : said, isOver: this.#drive?.isOver === true, more }, [log.buffer]);
  }

  /** Goes to a step, forward or back, to look into it. @param {Drive} drive @param {number} step */
  #visit(drive, step) {
    this.#inspects = true;
    this.#until = step;
    const isBehind = this.#hasFailed || step < drive.steps;
    if (isBehind && !drive.goBack(step)) return void this.begin().then(() => this.#schedule());
    this.#hasFailed = false;
    this.#schedule();
  }

  /** @param {Drive} drive */
  #inspect({ steps }) {
    this.#output.flush();
    const program = /** @type {Program} */ (this.#program);
    this.#send({ type: "state", id: this.#order.id, step: steps, line: program.line, variables: program.variables().slice(0, 200) });
  }

  /** A robot that isn't simulated asks. @param {Float64Array} readings @param {Float64Array[]} [before] */
  #answer(readings, before = []) {
    const program = /** @type {Program} */ (this.#program);
    try {
      for (const earlier of before) {
        program.step(earlier);
        program.output.length = 0;
      }
      const isDone = !program.step(readings);
      program.output.length = 0;
      this.#send({ type: "drive", id: this.#order.id, left: program.left, right: program.right, isDone });
    } catch (error) {
      this.#fail(error);
    }
  }

  #plan() {
    const [runner, program] = [/** @type {Runner} */ (this.#runner), /** @type {Program} */ (this.#program)];
    try {
      const cells = cellsOf(program, runner.room());
      this.#output.take(program.output, 0);
      this.#send({ type: "planned", id: this.#order.id, cells, output: this.#output.flush() });
    } catch (error) {
      this.#fail(error);
    }
  }

  /** @param {unknown} error */
  #fail(error) {
    if (this.#hasFailed) return;
    this.#hasFailed = true;
    const { message, line, column } = /** @type {{ message?: unknown, line?: unknown, column?: unknown }} */ (Object(error));
    const [text, step] = [String(message ?? error).slice(0, 2000), this.#runner?.steps() ?? 0];
    try {
      this.#drive?.finish(true);
      if (this.#drive && !this.#inspects) this.#report(true);
    } catch {
      // The simulation itself is broken; the message says it.
    }
    this.#send({ type: "failed", id: this.#order.id, step, message: text, line: Number(line) || 0, column: Number(column) || 0 });
  }

  close() {
    if (this.#runner) this.#kit.rooms.takeBack(this.#runner);
    this.#program = this.#runner = this.#drive = undefined;
  }
}
