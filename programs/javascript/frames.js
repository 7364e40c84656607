// @ts-check
// Many runs of a program in one process, for a host that speaks in frames: the twin of programs/python/robovac_program/frames.py,
// which says what is in them.
import fs from "node:fs";
import vm from "node:vm";
import { loadJavaScript } from "./javascript.js";
import { robotOf } from "./readings.js";

/** Bytes of a command in an answer. */
const COMMAND = 16;

/**
 * @typedef {import("./runtime.js").Program} Program
 * @typedef {object} Run
 * @property {Program} program
 * @property {number} at The step that comes next.
 * @property {Float64Array | undefined} own Its readings, if it has a laser: the ranges stay between scans.
 * @typedef {{ seeds: number[], layout: import("./robot.js").Layout }} Offer
 */

export class Framed {
  /** @type {Run[]} */
  #runs;
  #slots;
  /** @type {Record<string, unknown>[]} */
  #sayings = [];
  #bytes = new Uint8Array(1 << 16);
  /** Readings at their places in `#bytes`. @type {Float64Array[]} */
  #views = [];
  /** The last answer: filled again as long as as many runs are asked for. */
  #numbers = new Int32Array(1);
  #answerBytes = Buffer.from(this.#numbers.buffer);
  /** Its commands. @type {Int32Array[]} */
  #commands = [];

  /** The runs of all seeds that a host offers. @param {Offer} offer @param {Omit<import("./runtime.js").Options, "seed" | "layout">} options */
  constructor({ seeds, layout }, options) {
    this.#slots = layout.laser;
    const beams = options.facts.laser?.beams ?? 0;
    const Robot = robotOf(layout, options.facts);
    // They share it, and could put something into it for each other.
    if (seeds.length > 1) for (const kind of [Robot, Robot.prototype]) Object.preventExtensions(kind);
    this.#runs = seeds.map((seed) => {
      // What one run does to the language's own objects, no other one sees.
      const evaluate = seeds.length > 1 ? apart() : undefined;
      return { program: loadJavaScript({ ...options, seed, layout, Robot, evaluate }), at: 0, own: beams ? new Float64Array(layout.laser + beams).fill(Infinity) : undefined };
    });
    for (const number of this.#runs.keys()) this.#listen(number);
  }

  get kind() {
    return this.#runs[0]?.program.kind;
  }

  /** Takes what the program has said in a step. @param {number} number */
  #listen(number) {
    const { output } = this.#runs[number].program;
    const print = output.filter(({ kind }) => kind === "print").map(({ text }) => text);
    output.length = 0;
    if (print.length) this.#sayings.push({ run: number, print });
  }

  /** Answers until the host closes the connection. */
  serve() {
    for (let filled = 0; ; ) {
      const size = filled < 4 ? 4 : 4 + new DataView(this.#bytes.buffer).getUint32(0, true);
      if (filled < size || filled < 4) {
        if (size > this.#bytes.length) this.#grow(size);
        const got = fs.readSync(0, this.#bytes, filled, this.#bytes.length - filled, null);
        if (got === 0) return;
        filled += got;
        continue;
      }
      const answer = this.#answer();
      filled = 0;
      for (let sent = 0; sent < answer.length; ) sent += fs.writeSync(1, answer, sent);
    }
  }

  /** @param {number} size */
  #grow(size) {
    const bytes = new Uint8Array((size + 7) & ~7);
    bytes.set(this.#bytes);
    this.#bytes = bytes;
    this.#views = [];
  }

  /** The answer to a question. @returns {Uint8Array} */
  #answer() {
    const words = new Int32Array(this.#bytes.buffer);
    const count = words[1];
    if (count !== this.#commands.length) this.#makeRoom(count);
    let number = 0;
    try {
      for (let index = 0, place = 1; index < count; index += 1) {
        number = words[2 * place];
        const beams = words[2 * place + 1];
        this.#step(this.#runs[number], place + 1, beams, this.#commands[index]);
        if (this.#runs[number].program.output.length) this.#listen(number);
        place += 1 + this.#slots + beams;
      }
    } catch (/** @type {any} */ error) {
      this.#sayings.push({ run: number, error: String(error?.message ?? error), line: error?.line });
    }
    const said = this.#sayings.length ? Buffer.from(JSON.stringify(this.#sayings)) : undefined;
    this.#sayings = [];
    this.#numbers[0] = COMMAND * count + (said?.length ?? 0);
    return said ? Buffer.concat([this.#answerBytes, said]) : this.#answerBytes;
  }

  /** @param {number} count */
  #makeRoom(count) {
    const numbers = (this.#numbers = new Int32Array(1 + (COMMAND / 4) * count));
    this.#answerBytes = Buffer.from(numbers.buffer);
    this.#commands = Array.from({ length: count }, (_, index) => numbers.subarray(1 + (COMMAND / 4) * index));
  }

  /** @param {Run} run @param {number} place Where its readings are, in numbers. @param {number} beams @param {Int32Array} command */
  #step(run, place, beams, command) {
    const { program, own } = run;
    let readings = (this.#views[place] ??= new Float64Array(this.#bytes.buffer, 8 * place, this.#slots));
    if (own) {
      own.set(readings);
      if (beams) own.set(new Float64Array(this.#bytes.buffer, 8 * (place + this.#slots), beams), this.#slots);
      readings = own;
    }
    const step = readings[0];
    if (step > run.at) program.skip?.(step - run.at);
    run.at = step + 1;
    const goesOn = program.step(readings);
    command[0] = program.left;
    command[1] = program.right;
    command[2] = goesOn ? (program.hold?.() ?? 0) : 0;
    command[3] = goesOn ? 0 : 1;
  }
}

/** A world of its own for a program. Node asks its own code for each global name there, so that those of the language are parameters. */
function apart() {
  const context = vm.createContext({});
  const names = vm.runInContext("Object.getOwnPropertyNames(globalThis)", context).filter((/** @type {string} */ name) => /^[A-Z]\w+$/.test(name));
  return (/** @type {string} */ text) => vm.runInContext(`((${names}) => ${text}\n)(${names})`, context);
}
