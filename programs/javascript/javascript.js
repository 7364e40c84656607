// @ts-check
// A program in JavaScript: the twin of programs/python/robovac_program/program.py.
import { makeRobot } from "./readings.js";
import { Room } from "./room.js";
import { instrument, syntaxError } from "./trace-javascript.js";
import { KINDS, SourceError, atIdle, located, meant, missing, shown } from "./words.js";

/** @typedef {import("./robot.js").Robot} Robot */
/** @typedef {import("./runtime.js").Options} Options */
/** @typedef {import("./runtime.js").Program} Program */

/** The most characters that are printed in one step. */
export const MOST_PRINTED = 20000;

/** The command for a wheel, whole mm/s within the top speed: as the Open Interface takes it. @param {number} speed @param {number} topSpeed */
export function whole(speed, topSpeed) {
  if (speed !== speed) throw new SourceError("the wheel speed is not a number (NaN)");
  const limited = Math.max(-topSpeed, Math.min(topSpeed, speed)) * 1000;
  return limited >= 0 ? Math.trunc(limited + 0.5) : -Math.trunc(0.5 - limited);
}

/** @param {Options} options @returns {Program} */
export function loadJavaScript(options) {
  const { source, name = "program.js", facts, seed, layout, parser, traced = false, budget = Infinity, breakpoints = [], evaluate = eval } = options;
  const robot = makeRobot(facts, seed, layout, options.Robot);
  /** @type {Record<string, unknown>[]} */
  const output = [];
  let printed = 0;
  let isRunning = false;
  let line = 0;
  let left = budget;
  /** @type {Record<string, () => unknown>} */
  let locals = {};
  /** @type {Record<string, () => unknown>} */
  let globals = {};

  const print = (/** @type {unknown[]} */ ...values) => {
    const text = values.map((value) => (typeof value === "string" ? value : shown(value, MOST_PRINTED))).join(" ");
    printed += text.length;
    if (printed > MOST_PRINTED) throw new SourceError(`more than ${MOST_PRINTED} characters printed in one step`);
    output.push({ kind: "print", text });
  };
  const variables = () => [...Object.entries(globals), ...Object.entries(locals)].flatMap(([variable, get]) => {
    try {
      const value = get();
      return typeof value === "function" || value === robot ? [] : [[variable, shown(value), value === null ? "null" : Array.isArray(value) ? "array" : typeof value]];
    } catch {
      // Not yet declared.
      return [];
    }
  });
  const tracer = {
    at: (/** @type {number} */ now) => {
      line = now;
      if (--left < 0) throw new SourceError(isRunning ? `this line is run again and again: the ${kind === "plan" ? "plan" : "step"} never ends` : "this line is run again and again: the program never starts", now);
    },
    stop: (/** @type {number} */ now, /** @type {() => unknown} */ condition) => {
      try {
        if (!condition()) return;
      } catch {
        // A condition that fails is one to look at.
      }
      output.push({ kind: "break", line: now, variables: variables() });
    },
    locals: (/** @type {Record<string, () => unknown>} */ names) => { locals = names; },
    globals: (/** @type {Record<string, () => unknown>} */ names) => { globals = names; },
  };

  const tree = parser?.parse(source);
  if (tree) {
    const wrong = syntaxError(source, tree);
    if (wrong) throw wrong;
  }
  if (traced && !tree) throw new SourceError("a JavaScript program is traced by a parser, and none was given");
  const text = traced ? instrument(source, tree, breakpoints) : tidy(source);
  // The only clock is the robot's.
  const clock = { now: () => robot.time * 1000 };
  const Time = class extends Date {
    constructor(/** @type {any[]} */ ...parts) {
      // @ts-ignore: as Date takes them.
      super(...(parts.length > 0 ? parts : [clock.now()]));
    }
    static now = clock.now;
  };
  const console = { log: print, info: print, warn: print, error: print, debug: print };
  options.begins?.();
  /** @type {Record<string, any>} */
  let parts;
  try {
    // On one line with the program's first, so that the lines of errors are the program's own. Its `let` and `function`
    // are inside a function: programs can be loaded one after the other.
    const [make, math] = evaluate(`[(function (print, console, performance, Date, $trace) { "use strict"; ${text}\n;return {${KINDS.map((kind) => `${kind}: typeof ${kind} === "undefined" ? undefined : ${kind}`).join(", ")}}; }), Math]\n//# sourceURL=${name}`);
    // Chance is the seed's.
    math.random = robot.random;
    parts = make(print, console, clock, Time, tracer);
  } catch (error) {
    throw located(error, name, line);
  }
  const found = KINDS.filter((kind) => typeof parts[kind] === "function");
  if (found.length === 0 && output.length > 0 && !meant(source)) {
    // A first lesson: it prints, and that is all.
    found.push("run");
    parts.run = function* () {};
  }
  if (found.length === 0) throw new SourceError(missing(source));
  if (found.length > 1) throw new SourceError(`there are ${found.slice(0, -1).join(", ")} and ${found.at(-1)}: a program has one of them`);
  const kind = found[0];
  const own = parts[kind];
  /** @type {Generator<any, any, any> | undefined} */
  let generator;
  /** @type {import("./motions.js").Motion | undefined} */
  let motion;

  /** One step of a generator. */
  const goOn = () => {
    let result;
    if (motion) {
      result = motion.step(robot);
      if (result === undefined) return;
    }
    const { done, value } = /** @type {Generator} */ (generator).next(result);
    if (done) return robot.done();
    motion = value ?? undefined;
    if (motion) {
      if (typeof motion.step !== "function" || typeof motion.start !== "function") throw new SourceError(`yield takes a motion such as robot.forward(0.3), or nothing for one step; not ${shown(motion)}`);
      if (motion === robot._made) robot._made = undefined;
      motion.start(robot);
    }
    robot._allYielded();
  };
  const checked = (/** @type {unknown} */ result) => {
    if (result && typeof (/** @type {any} */ (result)).next === "function") throw new SourceError("step has a yield: a function that waits is function* run(robot)");
    if (result && typeof (/** @type {any} */ (result)).then === "function") throw new SourceError("step is async: a function that waits is function* run(robot)");
  };
  if (kind === "run") {
    if (Object.prototype.toString.call(own) !== "[object GeneratorFunction]") throw new SourceError("run has no yield: function* run(robot) waits with yield; a function for every step is function step(robot)");
    robot._waits = true;
    generator = own(robot);
  }

  const program = {
    kind,
    left: 0,
    right: 0,
    get line() { return line; },
    output,
    /** @param {Float64Array} readings */
    step(readings) {
      robot._readings = readings;
      robot._step++;
      printed = 0;
      left = budget;
      isRunning = true;
      try {
        if (kind === "step") {
          const result = own(robot);
          if (result !== undefined) checked(result);
        } else {
          goOn();
        }
        program.left = whole(robot._left, robot.topSpeed);
        program.right = whole(robot._right, robot.topSpeed);
      } catch (error) {
        throw atIdle(located(error, name, line), source);
      } finally {
        if (robot._sayings.length) {
          output.push(...robot._sayings);
          robot._sayings.length = 0;
        }
      }
      return !robot._isDone;
    },
    hold: () => motion?.hold?.(robot) ?? 0,
    skip: (/** @type {number} */ steps) => motion?.skip?.(steps),
    variables,
    save: () => undefined,
    restore: () => { throw new Error("JavaScript programs are replayed, not restored"); },
    /** @param {{rows: string[], cell: number, start: number[]}} room */
    *plan(room) {
      left = budget;
      isRunning = true;
      try {
        const cells = own(new Room(room));
        for (const cell of cells ?? []) {
          const [x, y] = Array.isArray(cell) ? cell : [];
          if (!Array.isArray(cell) || cell.length !== 2) throw new SourceError(`plan gives cells [x, y], not ${shown(cell)}`);
          if (!Number.isInteger(x) || !Number.isInteger(y)) throw new SourceError(`a cell has whole numbers: not ${shown(cell)}`);
          yield [x, y];
        }
      } catch (error) {
        throw located(error, name, line);
      }
    },
  };
  return /** @type {Program} */ (/** @type {unknown} */ (program));
}

/** A program may be written as a module. @param {string} source */
const tidy = (source) => source.replace(/^export (?=(async )?(function|const|let|class)\b)/gm, "       ");
