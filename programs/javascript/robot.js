// @ts-check
// The robot as a program sees it: the twin of programs/python/robovac_program/robot.py, in camelCase.
import { chance } from "./chance.js";
import * as motions from "./motions.js";
import { SourceError, number } from "./words.js";

/** @typedef {import("./motions.js").Motion} Motion */
/** What a program says besides its command. @typedef {{kind: string, [part: string]: unknown}} Saying */
/** @typedef {{name: string, index: number, count: number, flag: boolean}} Slot */
/** @typedef {{slots: Slot[], laser: number}} Layout */
/** @typedef {{name?: string, radius: number, wheel_base: number, top_speed: number, tool_width: number, laser?: {beams: number} | null}} Facts */
/** With its readings, of which the runtime uses some itself. @typedef {Base & {time: number, distance: number, turned: number, bump: boolean}} Robot */

/** The most that a program may say in one step. */
const MOST_SAYINGS = 2000;
/** A robot without its readings. */
export class Base {
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
    /** Its lists of six, and the steps that they are of. @type {(number | boolean)[][]} */
    this._lists = [];
    this._listsOf = [-1, -1];
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
