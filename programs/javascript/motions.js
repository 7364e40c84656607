// @ts-check
// What a program can wait for: `yield robot.forward(0.3)`. The twin of programs/python/robovac_program/motions.py: same
// arithmetic in the same order, so that both give the same commands.
import { SourceError, number, shown } from "./words.js";

/** @typedef {import("./robot.js").Robot} Robot */
/** A motion is started in the step that yields it, and asked at every further step: undefined while it goes on, then true
 * if it has reached its aim and false if not. @typedef {{name: string, start(robot: Robot): void, step(robot: Robot): boolean | undefined,
 * hold?(robot: Robot): number, skip?(steps: number): void}} Motion `hold` is the number of further steps in which it surely
 * commands the same, unless the robot gets blocked; `skip` is called when they have passed. */

export const RADIANS = 0.017453292519943295;
/** Slowest wheel speed at which a motion ends, m/s. */
const CREEP = 0.02;
/** What may be left of a way at its end, m: what it creeps in a step. */
const CLOSE = 0.0003;
/** Steps in a second. */
const PER_SECOND = 1 / 0.015;

/** Three times as many steps as the way takes, and 2 s. @param {number} length @param {number} speed */
const patience = (length, speed) => Math.trunc(((3 * length) / speed + 2) * PER_SECOND);

/** The speed with so much left of the way; brakes by 0.5 m/s². @param {number} left @param {number} speed */
function pace(left, speed) {
  const slow = left < 1 ? Math.sqrt(left) : speed;
  return Math.max(CREEP, Math.min(speed, slow));
}

/** @param {string} place @param {unknown} value */
function positive(place, value) {
  const checked = number(place, value);
  if (checked <= 0) throw new SourceError(`${place} must be more than 0, not ${shown(value)}`);
  return checked;
}

/** A motion by how far it has to go. `left` is the way in metres of the faster wheel.
 * @param {string} name @param {boolean} isBlockable
 * @param {(robot: Robot) => {length: number, speed: number, left: (robot: Robot) => number, drive: (robot: Robot, speed: number) => void}} begin @returns {Motion} */
function way(name, isBlockable, begin) {
  /** @type {ReturnType<typeof begin>} */
  let going;
  let limit = 0;
  const step = (/** @type {Robot} */ robot) => {
    const left = going.left(robot);
    if (left <= CLOSE || --limit === 0 || (isBlockable && robot.blocked())) {
      robot.drive(0, 0);
      return left <= CLOSE;
    }
    going.drive(robot, pace(left, going.speed));
    return undefined;
  };
  return {
    name,
    start: (robot) => {
      going = begin(robot);
      limit = patience(going.length, going.speed);
      step(robot);
    },
    step,
    hold: (robot) => {
      // Until it brakes, in wheels that turn half as fast again as they should.
      const { speed } = going;
      // One that begins blocked ends with the next step.
      if (isBlockable && robot.blocked()) return 0;
      const left = going.left(robot);
      const steps = left > speed * speed ? Math.trunc((left - speed * speed) / (speed * 0.0225)) : 0;
      return limit > 2 ? Math.min(steps, limit - 2) : 0;
    },
    skip: (steps) => { limit -= steps; },
  };
}

/** Straight ahead, or back for a negative distance. @param {number} distance @param {number} speed */
export function forward(distance, speed) {
  number("robot.forward: distance", distance);
  positive("robot.forward: speed", speed);
  const ahead = distance >= 0;
  return way("forward", ahead, (robot) => {
    const end = robot.distance + distance;
    return {
      length: Math.abs(distance),
      speed,
      left: (now) => (ahead ? end - now.distance : -(end - now.distance)),
      drive: (now, pace) => (ahead ? now.drive(pace, pace) : now.drive(-pace, -pace)),
    };
  });
}

/** On the spot, counter-clockwise for positive degrees. @param {number} degrees @param {number} rate */
export function turn(degrees, rate) {
  number("robot.turn: degrees", degrees);
  positive("robot.turn: rate", rate);
  return way("turn", false, (robot) => {
    const end = robot.turned + degrees;
    const scale = RADIANS * robot.wheelBase * 0.5;
    return {
      length: Math.abs(degrees) * scale,
      speed: rate * scale,
      left: (now) => (degrees < 0 ? -((end - now.turned) * scale) : (end - now.turned) * scale),
      drive: (now, pace) => (degrees < 0 ? now.drive(pace, -pace) : now.drive(-pace, pace)),
    };
  });
}

/** Ahead on a circle, to the left for positive degrees. @param {number} radius @param {number} degrees @param {number} speed */
export function arc(radius, degrees, speed) {
  if (number("robot.arc: radius", radius) < 0) throw new SourceError("robot.arc: radius must be 0 or more; negative degrees lead to the right");
  number("robot.arc: degrees", degrees);
  positive("robot.arc: speed", speed);
  return way("arc", true, (robot) => {
    const end = robot.turned + degrees;
    const half = 0.5 * robot.wheelBase;
    const outer = radius + half;
    return {
      length: Math.abs(degrees) * RADIANS * outer,
      speed,
      left: (now) => (degrees < 0 ? -((end - now.turned) * RADIANS * outer) : (end - now.turned) * RADIANS * outer),
      drive: (now, fast) => {
        const slow = (fast * (radius - half)) / outer;
        if (degrees < 0) now.drive(fast, slow);
        else now.drive(slow, fast);
      },
    };
  });
}

/** Goes on as it was commanded for some seconds. @param {number} seconds @returns {Motion} */
export function wait(seconds) {
  let limit = Math.trunc(number("robot.wait: seconds", seconds) * PER_SECOND + 0.5);
  return { name: "wait", start: () => {}, step: () => (--limit <= 0 ? true : undefined), hold: () => Math.max(0, limit - 2), skip: (steps) => { limit -= steps; } };
}

/** Goes on as it was commanded until a condition holds. @param {(robot: Robot) => unknown} condition @param {number} [timeout] s @returns {Motion} */
export function until(condition, timeout) {
  if (typeof condition !== "function") throw new SourceError("robot.until needs a function: robot.until((r) => r.bump)");
  let limit = timeout === undefined || timeout === null ? 0 : Math.trunc(positive("robot.until: timeout", timeout) * PER_SECOND + 0.5);
  return { name: "until", start: () => {}, step: (robot) => (condition(robot) ? true : --limit === 0 ? false : undefined) };
}
