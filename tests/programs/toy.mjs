// A robot in a room of boxes, simple enough to be looked through: for tests of programs that need no simulator. It rolls
// exactly as commanded, stops at what it touches, and has the senses of a Roomba 600, made from distances.
import { LAYOUT } from "../../programs/javascript/layout.js";

export const FACTS = { name: "Toy", radius: 0.174, wheel_base: 0.235, top_speed: 0.5, tool_width: 0.18, counts_per_metre: 2262.6, laser: null };
const STEP_S = 0.015;
const CELL = 0.1;
const at = Object.fromEntries(LAYOUT.slots.map(({ name, index }) => [name, index]));
/** Directions of the light bumper's sensors, and of the bumper's halves, degrees from ahead. */
const BEAMS = [65, 38, 20, -20, -38, -65];

/** Boxes are [left, bottom, right, top] in metres. */
export class Toy {
  constructor({ width = 4, height = 3, boxes = [[2.4, 1.8, 3, 2.3], [1, 0.9, 1.3, 1.4]], x = 0.6, y = 0.6, heading = 0 } = {}) {
    Object.assign(this, { width, height, boxes, x, y, heading: (heading * Math.PI) / 180, steps: 0, rolled: [0, 0], turned: 0, odometer: 0 });
    this.own = { x, y, heading };
    this.readings = new Float64Array(LAYOUT.laser);
    this.columns = Math.round(width / CELL);
    this.clean = new Uint8Array(this.columns * Math.round(height / CELL));
    this.touch = [false, false];
    this.sense();
  }

  /** Distance from a point to the nearest thing, m; negative inside. */
  clearance(x, y) {
    let least = Math.min(x, y, this.width - x, this.height - y);
    for (const [left, bottom, right, top] of this.boxes) least = Math.min(least, Math.hypot(Math.max(left - x, 0, x - right), Math.max(bottom - y, 0, y - top)));
    return least;
  }

  /** Distance along a ray, m. */
  ray(x, y, angle, most = 1) {
    for (let way = 0; way < most; ) {
      const free = this.clearance(x + way * Math.cos(angle), y + way * Math.sin(angle));
      if (free < 1e-3) return way;
      way += free;
    }
    return most;
  }

  /** One step; whole mm/s. */
  step(left, right) {
    const [l, r] = [(left / 1000) * STEP_S, (right / 1000) * STEP_S];
    const [way, turn] = [(l + r) / 2, (r - l) / FACTS.wheel_base];
    const angle = this.heading + turn / 2;
    const [x, y] = [this.x + way * Math.cos(angle), this.y + way * Math.sin(angle)];
    this.heading += turn;
    this.turned += turn;
    this.touch = [false, false];
    if (this.clearance(x, y) > FACTS.radius) {
      [this.x, this.y] = [x, y];
      this.odometer += way;
    } else if (way > 0) {
      // The direction of what it touches, as seen from ahead.
      let side = 0;
      for (let degrees = -90; degrees <= 90; degrees += 10) {
        const direction = this.heading + (degrees * Math.PI) / 180;
        if (this.clearance(x + FACTS.radius * Math.cos(direction), y + FACTS.radius * Math.sin(direction)) < 2e-3) side += degrees || 0.1;
      }
      this.touch = [side > -300, side < 300];
    }
    this.steps++;
    this.sense();
  }

  sense() {
    const { readings } = this;
    const gone = this.odometer;
    const degrees = (this.turned * 180) / Math.PI;
    const heading = (this.heading * 180) / Math.PI;
    Object.entries({ step: this.steps, time: this.steps * STEP_S, x: this.x, y: this.y, heading: heading - 360 * Math.round(heading / 360), distance: gone, turned: degrees, charge: 1, bump_left: +this.touch[0], bump_right: +this.touch[1], stasis: 1 }).forEach(([name, value]) => { readings[at[name]] = value; });
    BEAMS.forEach((beam, index) => {
      const angle = this.heading + (beam * Math.PI) / 180;
      const away = this.ray(this.x + FACTS.radius * Math.cos(angle), this.y + FACTS.radius * Math.sin(angle), angle, 0.4);
      // A law like that of infrared light: about 1,000 at 3 cm.
      const signal = away >= 0.4 ? 0 : Math.min(4095, Math.round(0.9 / (away * away + 1e-4)));
      readings[at.light + index] = signal;
      readings[at.light_bumper + index] = +(signal > 100);
      if (index === 5) [readings[at.wall_signal], readings[at.wall]] = [Math.min(1023, signal), +(signal > 100)];
    });
    const half = FACTS.tool_width / 2;
    for (let y = this.y - half; y <= this.y + half; y += CELL / 2) for (let x = this.x - half; x <= this.x + half; x += CELL / 2) this.clean[Math.floor(y / CELL) * this.columns + Math.floor(x / CELL)] = 1;
  }

  /** Share of the cells where the robot's middle fits that it has cleaned. */
  coverage() {
    let [all, done] = [0, 0];
    this.clean.forEach((clean, index) => {
      const [x, y] = [((index % this.columns) + 0.5) * CELL, (Math.floor(index / this.columns) + 0.5) * CELL];
      if (this.clearance(x, y) < FACTS.radius) return;
      all++;
      done += clean;
    });
    return done / all;
  }
}
