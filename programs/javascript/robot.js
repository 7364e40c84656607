// @ts-check
// The robot as a program sees it: the twin of programs/python/robovac_program/robot.py, in camelCase.
import { chance } from "./chance.js";
import * as motions from "./motions.js";
import { SourceError, number, unknown } from "./words.js";

/** @typedef {import("./motions.js").Motion} Motion */
/** What a program says besides its command. @typedef {{kind: string, [part: string]: unknown}} Saying */
/** @typedef {{name: string, index: number, count: number, flag: boolean}} Slot */
/** @typedef {{slots: Slot[], laser: number}} Layout */
/** @typedef {{name?: string, radius: number, wheel_base: number, top_speed: number, tool_width: number, laser?: {beams: number} | null}} Facts */
/** With its readings, of which the runtime uses some itself. @typedef {Base & {time: number, distance: number, turned: number, bump: boolean}} Robot */

/** The most that a program may say in one step. */
const MOST_SAYINGS = 2000;
/** Readings that are true if one of others is. */
const ANY = { bump: ["bump_left", "bump_right"], wheel_drop: ["wheel_drop_left", "wheel_drop_right"], cliff: ["cliff_left", "cliff_front_left", "cliff_front_right", "cliff_right"] };

/** A reading's name in JavaScript. @param {string} name */
export const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());

class Base {
  /** @param {Facts} facts @param {number} seed */
  constructor(facts, seed) {
    this.radius = facts.radius;
    this.wheelBase = facts.wheel_base;
    this.topSpeed = facts.top_speed;
    this.toolWidth = facts.tool_width;
    this.model = facts.name ?? "";
    this.random = chance(seed);
    /** Wanted wheel speeds, m/s. */
    this._left = 0;
    this._right = 0;
    this._isDone = false;
    this._half = motions.RADIANS * this.wheelBase * 0.5;
    /** Readings of this step, in the host's layout. @type {Float64Array} */
    this._readings = new Float64Array(0);
    /** Counts the readings. */
    this._step = 0;
    /** Whether the program is a generator, and the motion that it has made but not yet yielded. */
    this._waits = false;
    /** @type {Motion | undefined} */
    this._made = undefined;
    /** @type {Saying[]} */
    this._sayings = [];
  }

  /** Whether something is in its way. @this {Robot} */
  blocked() {
    const { bump, cliff, wheelDrop } = /** @type {any} */ (this);
    return bump || cliff || wheelDrop;
  }

  /** @param {number} left m/s @param {number} right m/s */
  drive(left, right) {
    this._left = typeof left === "number" ? left : number("robot.drive: left", left);
    this._right = typeof right === "number" ? right : number("robot.drive: right", right);
  }

  /** @param {number} speed m/s @param {number} [turnRate] degrees/s, counter-clockwise */
  go(speed, turnRate = 0) {
    const spin = (typeof turnRate === "number" ? turnRate : number("robot.go: turnRate", turnRate)) * this._half;
    this._left = (typeof speed === "number" ? speed : number("robot.go: speed", speed)) - spin;
    this._right = speed + spin;
  }

  stop() {
    this.drive(0, 0);
  }

  done() {
    this.stop();
    this._isDone = true;
  }

  forward(/** @type {number} */ distance, speed = 0.3) {
    return this._motion(motions.forward(distance, speed));
  }

  turn(/** @type {number} */ degrees, rate = 90) {
    return this._motion(motions.turn(degrees, rate));
  }

  arc(/** @type {number} */ radius, /** @type {number} */ degrees, speed = 0.3) {
    return this._motion(motions.arc(radius, degrees, speed));
  }

  wait(/** @type {number} */ seconds) {
    return this._motion(motions.wait(seconds));
  }

  until(/** @type {(robot: Robot) => unknown} */ condition, /** @type {number | undefined} */ timeout = undefined) {
    return this._motion(motions.until(condition, timeout));
  }

  /** @param {Motion} motion */
  _motion(motion) {
    const { name } = motion;
    if (!this._waits) throw new SourceError(`robot.${name} takes time, so it needs function* run(robot) and yield robot.${name}(...)`);
    this._allYielded();
    this._made = motion;
    return motion;
  }

  _allYielded() {
    if (!this._made) return;
    const { name } = this._made;
    this._made = undefined;
    throw new SourceError(`robot.${name}(...) does nothing without yield: write yield robot.${name}(...)`);
  }

  randint(/** @type {number} */ least, /** @type {number} */ most) {
    return least + Math.trunc(this.random() * (most - least + 1));
  }

  /** @template T @param {T[]} items @returns {T} */
  choice(items) {
    if (!items.length) throw new SourceError("robot.choice: the list is empty");
    return items[Math.trunc(this.random() * items.length)];
  }

  mark(/** @type {number} */ x, /** @type {number} */ y, /** @type {unknown} */ colour = null) {
    this._say({ kind: "mark", x: number("robot.mark: x", x), y: number("robot.mark: y", y), colour: named(colour) });
  }

  line(/** @type {number} */ x1, /** @type {number} */ y1, /** @type {number} */ x2, /** @type {number} */ y2, /** @type {unknown} */ colour = null) {
    for (const end of [x1, y1, x2, y2]) number("robot.line: end", end);
    this._say({ kind: "line", x1, y1, x2, y2, colour: named(colour) });
  }

  text(/** @type {number} */ x, /** @type {number} */ y, /** @type {unknown} */ words) {
    this._say({ kind: "text", x: number("robot.text: x", x), y: number("robot.text: y", y), text: String(words).slice(0, 200) });
  }

  clear() { this._say({ kind: "clear" }); }

  /** @param {Saying} saying */
  _say(saying) {
    if (this._sayings.length >= MOST_SAYINGS) throw new SourceError(`more than ${MOST_SAYINGS} marks, lines and texts in one step`);
    this._sayings.push(saying);
  }
}

/** @param {unknown} colour */
const named = (colour) => (colour === null || colour === undefined ? null : String(colour).slice(0, 30));

/** What programs write after `robot.`, for messages. @param {Layout} layout */
const names = (layout) => [
  ...layout.slots.map(({ name }) => camel(name)), "bump", "wheelDrop", "cliff", "laser", "radius", "wheelBase", "topSpeed", "toolWidth", "model", "random",
  ...Object.getOwnPropertyNames(Base.prototype).filter((name) => !name.startsWith("_") && name !== "constructor"),
];

/** A robot whose readings are where `layout` has them. @param {Facts} facts @param {number} seed @param {Layout} layout @returns {Robot} */
export function makeRobot(facts, seed, layout) {
  class Own extends Base {}
  const prototype = Own.prototype;
  const indices = Object.fromEntries(layout.slots.map(({ name, index }) => [name, index]));
  /** @param {string} name @param {(this: Base) => unknown} get */
  const reading = (name, get) =>
    Object.defineProperty(prototype, camel(name), {
      get,
      set() { throw new SourceError(`robot.${camel(name)} is measured: a program can't set it`); },
    });
  for (const { name, index, count, flag } of layout.slots) {
    if (count > 1) {
      // A new list for each step, as a program may keep it.
      let step = -1;
      /** @type {(number | boolean)[]} */
      let list = [];
      reading(name, function () {
        if (step === this._step) return list;
        step = this._step;
        list = [];
        for (let at = index; at < index + count; at++) list.push(flag ? this._readings[at] !== 0 : this._readings[at]);
        return list;
      });
    }
    else if (flag) reading(name, function () { return this._readings[index] !== 0; });
    else reading(name, function () { return this._readings[index]; });
  }
  for (const [name, parts] of Object.entries(ANY)) {
    const [first, last] = [indices[parts[0]], indices[/** @type {string} */ (parts.at(-1))]];
    reading(name, function () {
      for (let index = first; index <= last; index++) if (this._readings[index] !== 0) return true;
      return false;
    });
  }
  const beams = facts.laser?.beams ?? 0;
  reading("laser", function () { return this._readings[indices.laser_scan] ? Array.from(this._readings.subarray(layout.laser, layout.laser + beams)) : null; });
  // Behind all that is there: a name that isn't.
  const missing = new Proxy({}, {
    get: (_, name) => {
      if (typeof name === "symbol" || name.startsWith("_") || name in Object.prototype || ["then", "toJSON"].includes(name)) return undefined;
      throw new SourceError(unknown("robot", name, names(layout)));
    },
  });
  Object.setPrototypeOf(Base.prototype, missing);
  return /** @type {Robot} */ (/** @type {unknown} */ (new Own(facts, seed)));
}
