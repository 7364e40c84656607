// @ts-check
// A program and the simulation that it drives: step by step, and back in time.

/**
 * @typedef {import("../../../program.js").ProgramRunner} Runner
 * @typedef {import("../../../programs/javascript/runtime.js").Program} Program
 */

/** Steps between looks at the clock. */
const BATCH = 16;
/** Steps between key frames at first: a minute. */
const KEY_FRAME_EVERY = 4000;
/** Most key frames, and most memory for the program's part of them, bytes; beyond, every second one is dropped. */
const MOST_FRAMES = 48;
const MOST_BYTES = 64 << 20;

export class Drive {
  #runner;
  #program;
  #memory;
  #clock;
  #output;
  #readings = new Float64Array();
  /** Of both, by their steps. @type {{ step: number, state: any }[]} */
  #frames = [];
  #every = KEY_FRAME_EVERY;
  /** The program has ended, or its robot has no charge left. */
  isOver = false;

  /** @param {Runner} runner @param {Program} program @param {WebAssembly.Memory} memory @param {() => number} clock @param {import("./output.js").Output} output */
  constructor(runner, program, memory, clock, output) {
    this.#runner = runner;
    this.#program = program;
    this.#memory = memory;
    this.#clock = clock;
    this.#output = output;
  }

  get steps() {
    return this.#runner.steps();
  }

  /** Drives until that step, or that time, ms. @param {number} until @param {number} end @param {boolean} keeps Whether to go back later. */
  advance(until, end, keeps) {
    const runner = this.#runner;
    for (let steps = runner.steps(); !this.isOver && steps < until && this.#clock() < end; ) {
      if (keeps) this.#keep(steps);
      const stop = Math.min(steps + BATCH, until);
      for (; steps < stop && !this.isOver; steps += 1) this.#step(steps);
    }
  }

  /** @param {number} steps */
  #step(steps) {
    const [runner, program] = [this.#runner, this.#program];
    // Growing memory takes its views away.
    if (this.#readings.length === 0) this.#readings = new Float64Array(this.#memory.buffer, runner.readings_ptr(), runner.readings_len());
    const goesOn = program.step(this.#readings);
    if (program.output.length) this.#output.take(program.output, steps);
    if (!goesOn) this.finish(false);
    else if (!runner.step(program.left, program.right)) this.isOver = true;
  }

  /** The program ends here. @param {boolean} hasFailed */
  finish(hasFailed) {
    this.isOver = true;
    this.#runner.finish(hasFailed);
  }

  /** Keeps the present state, if it is time to. @param {number} step */
  #keep(step) {
    const frames = this.#frames;
    if (step < (frames.at(-1)?.step ?? -Infinity) + this.#every) return;
    const state = this.#program.save();
    // JavaScript's state can't be copied: such programs are run again.
    if (!state) return void (this.#every = Infinity);
    this.#runner.snapshot();
    frames.push({ step, state });
    const bytes = frames.reduce((sum, { state }) => sum + state.bytes, 0);
    if (frames.length <= MOST_FRAMES && bytes <= MOST_BYTES) return;
    this.#every *= 2;
    for (const [index, { step }] of frames.entries()) if (index % 2) this.#runner.forget(step);
    this.#frames = frames.filter((_, index) => index % 2 === 0);
  }

  /** Goes back to the last key frame at or before that step. @param {number} step @returns {boolean} Whether there is one. */
  goBack(step) {
    const last = this.#frames.findLastIndex((frame) => frame.step <= step);
    if (last < 0) return false;
    this.#frames.length = last + 1;
    const frame = this.#frames[last];
    this.#runner.rewind(frame.step);
    this.#program.restore(frame.state);
    this.isOver = false;
    return true;
  }
}
