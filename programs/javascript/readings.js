// @ts-check
// The robot with its readings, which are where the host's layout has them.
import { Base } from "./robot.js";
import { SourceError, unknown } from "./words.js";

/** @typedef {import("./robot.js").Robot} Robot */
/** @typedef {import("./robot.js").Facts} Facts */
/** @typedef {import("./robot.js").Layout} Layout */

/** Readings that are true if one of others is. */
const ANY = { bump: ["bump_left", "bump_right"], wheel_drop: ["wheel_drop_left", "wheel_drop_right"], cliff: ["cliff_left", "cliff_front_left", "cliff_front_right", "cliff_right"] };

/** A reading's name in JavaScript. @param {string} name */
export const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());

/** What programs write after `robot.`, for messages. @param {Layout} layout */
const names = (layout) => [
  ...layout.slots.map(({ name }) => camel(name)), "bump", "wheelDrop", "cliff", "laser", "radius", "wheelBase", "topSpeed", "toolWidth", "model", "random",
  ...Object.getOwnPropertyNames(Base.prototype).filter((name) => !name.startsWith("_") && name !== "constructor"),
];

/** A robot whose readings are where `layout` has them. @param {Facts} facts @param {number} seed @param {Layout} layout @param {typeof Base} [Kind] @returns {Robot} */
export const makeRobot = (facts, seed, layout, Kind = robotOf(layout, facts)) => /** @type {Robot} */ (/** @type {unknown} */ (new Kind(facts, seed)));

/** The class of such robots. @param {Layout} layout @param {Facts} facts */
export function robotOf(layout, { laser }) {
  class Own extends Base {}
  const prototype = Own.prototype;
  const beams = laser?.beams ?? 0;
  let lists = 0;
  const indices = Object.fromEntries(layout.slots.map(({ name, index }) => [name, index]));
  /** @param {string} name @param {(this: Base) => unknown} get */
  const reading = (name, get) =>
    Object.defineProperty(prototype, camel(name), {
      get,
      set() { throw new SourceError(`robot.${camel(name)} is measured: a program can't set it`); },
    });
  for (const { name, index, count, flag } of layout.slots) {
    if (count > 1) {
      const which = lists++;
      reading(name, function () {
        // A new list for each step, as a program may keep it.
        if (this._listsOf[which] !== this._step) {
          this._listsOf[which] = this._step;
          /** @type {(number | boolean)[]} */
          const list = (this._lists[which] = []);
          for (let at = index; at < index + count; at++) list.push(flag ? this._readings[at] !== 0 : this._readings[at]);
        }
        return this._lists[which];
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
  reading("laser", function () { return this._readings[indices.laser_scan] ? Array.from(this._readings.subarray(layout.laser, layout.laser + beams)) : null; });
  // Behind all that is there: a name that isn't.
  const missing = new Proxy({}, {
    get: (_, name) => {
      if (typeof name === "symbol" || name.startsWith("_") || name in Object.prototype || ["then", "toJSON"].includes(name)) return undefined;
      throw new SourceError(unknown("robot", name, names(layout)));
    },
  });
  Object.setPrototypeOf(Base.prototype, missing);
  return Own;
}
