// @ts-check
// A robot from above, drawn with what its sensors report: bumper, cliff sensors, light bumper, wheels.
import { setAttribute, setText } from "./dom.js";

/**
 * @typedef {import("./types").RobotEntry} Robot
 * @typedef {import("./types").SensorsView} Reading
 * @typedef {{ svg: SVGSVGElement, show: (of: Reading) => void }} Portrait
 */

/** Radius of the robot, and where the bars of the light bumper begin and end, units of the drawing. */
const RADIUS = 58;
const BARS = [72, 108];
/** Distance of the numbers of the bars. */
const NUMBERS = 120;
/** Largest signal of the light bumper. */
const FULL = 4095;
/** Encoder counts after which the pattern of a tread repeats. */
const TREAD = 40;

const SVG = "http://www.w3.org/2000/svg";

/**
 * @template {keyof SVGElementTagNameMap} K
 * @param {K} tag @param {Record<string, string | number>} attributes @param {Element} [into]
 * @returns {SVGElementTagNameMap[K]}
 */
export function draw(tag, attributes, into) {
  const node = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  into?.append(node);
  return node;
}

/** A point of the robot's frame, in units of its radius: ahead is up. @param {number} x @param {number} y */
const at = (x, y) => /** @type {const} */ ([-y * RADIUS, -x * RADIUS]);
/** A point at a distance in a direction, counter-clockwise from ahead. @param {number} r @param {number} angle */
const polar = (r, angle) => /** @type {const} */ ([-r * Math.sin(angle), -r * Math.cos(angle)]);
/** @param {number} value */
const round = (value) => Math.round(value * 100) / 100;

/** @param {Robot} robot @param {string} id Differs from those of other portraits. @returns {Portrait} */
export function portrait(robot, id = "portrait") {
  const hasLight = robot.light.length > 0;
  const top = hasLight ? -NUMBERS - 12 : -RADIUS - 14;
  const svg = draw("svg", { viewBox: `-140 ${top} 280 ${RADIUS + 12 - top}`, class: "portrait", role: "img" });
  /** @type {((of: Reading) => void)[]} */
  const parts = [];
  if (robot.bumper > 0) bumper(svg, robot, parts, id);
  body(svg, robot, parts);
  robot.light.forEach((angle, index) => bar(svg, angle, index, parts));
  for (const index of cliffSensors(robot)) cliff(svg, robot.cliffs[index] ?? [0, 0], index, parts);
  return {
    svg,
    show: (of) => {
      for (const part of parts) part(of);
      setAttribute(svg, "aria-label", words(robot, of));
    },
  };
}

/** Numbers of the cliff sensors that there are: a single one in front is listed twice. @param {Robot} robot */
export function cliffSensors({ cliffs }) {
  const [, left, right] = cliffs;
  const isSingle = left && right && left[0] === right[0] && left[1] === right[1];
  return [0, 1, 2, 3].filter((index) => cliffs[index] && !(index === 2 && isSingle));
}

/** @param {SVGElement} svg @param {Robot} robot @param {((of: Reading) => void)[]} parts */
function body(svg, robot, parts) {
  outline(svg, robot).setAttribute("class", "body");
  const half = Math.max(9, robot.wheel_radius * RADIUS);
  for (const [side, index] of /** @type {[number, 0 | 1][]} */ ([[1, 0], [-1, 1]])) {
    const [x] = at(0, (side * robot.wheel_base) / 2);
    const wheel = draw("line", { x1: round(x), x2: round(x), y1: -half, y2: half, class: "wheel" }, svg);
    const tread = draw("line", { x1: round(x), x2: round(x), y1: -half, y2: half, class: "tread" }, svg);
    parts.push((of) => {
      setAttribute(tread, "stroke-dashoffset", String(round(((of.counts[index] % TREAD) / TREAD) * 4)));
      setAttribute(wheel, "class", of.wheel_drops[index] ? "wheel on" : "wheel");
    });
  }
  draw("path", { d: "M0 -34 L9 -18 H-9 Z", class: "heading" }, svg);
}

/** @param {SVGElement} svg @param {Robot} robot */
function outline(svg, robot) {
  if (robot.body.length === 0) return draw("circle", { r: RADIUS }, svg);
  return draw("polygon", { points: robot.body.map(([x, y]) => at(x, y).map(round).join()).join(" ") }, svg);
}

/** A rim around the front that the body hides the inner half of. @param {SVGElement} svg @param {Robot} robot @param {((of: Reading) => void)[]} parts @param {string} id */
function bumper(svg, robot, parts, id) {
  for (const [side, index] of /** @type {[number, 0 | 1][]} */ ([[1, 0], [-1, 1]])) {
    const clip = draw("clipPath", { id: `${id}-bumper-${index}` }, svg);
    // Far outside the body, so that the straight sides of the wedge hold it.
    const corners = [0.03, 0.25, 0.5, 0.75, 1].map((share) => polar(4 * RADIUS, side * Math.max(0.03, share * robot.bumper)));
    draw("polygon", { points: `0,0 ${corners.map((corner) => corner.map(round).join()).join(" ")}` }, clip);
    const rim = outline(svg, robot);
    rim.setAttribute("clip-path", `url(#${id}-bumper-${index})`);
    parts.push((of) => setAttribute(rim, "class", of.bumper[index] ? "bumper on" : "bumper"));
  }
}

/** @param {SVGElement} svg @param {number} angle @param {number} index @param {((of: Reading) => void)[]} parts */
function bar(svg, angle, index, parts) {
  const [from, to, end] = [polar(BARS[0] ?? 0, angle), polar(BARS[1] ?? 0, angle), polar(NUMBERS, angle)];
  const ends = { x1: round(from[0]), y1: round(from[1]), x2: round(to[0]), y2: round(to[1]), pathLength: 100 };
  draw("line", { ...ends, class: "track" }, svg);
  const level = draw("line", { ...ends, "stroke-dasharray": "100 300" }, svg);
  const number = draw("text", { x: round(end[0]), y: round(end[1] + 3), class: "number" }, svg);
  parts.push((of) => {
    const signal = of.light_signals[index] ?? 0;
    // The signal falls steeply with distance: its root is easier to read.
    setAttribute(level, "stroke-dashoffset", String(round(100 * (1 - Math.sqrt(Math.min(1, signal / FULL))))));
    setAttribute(level, "class", of.light[index] ? "level near" : signal > 0 ? "level" : "level none");
    setText(number, String(signal));
  });
}

/** @param {SVGElement} svg @param {readonly [number, number]} spot @param {number} index @param {((of: Reading) => void)[]} parts */
function cliff(svg, [x, y], index, parts) {
  const [cx, cy] = at(x, y).map(round);
  const dot = draw("circle", { cx: cx ?? 0, cy: cy ?? 0, r: 4.5 }, svg);
  parts.push((of) => setAttribute(dot, "class", of.cliffs[index] ? "cliff on" : "cliff"));
}

/** Description of the drawing for screen readers. @param {Robot} robot @param {Reading} of */
function words(robot, of) {
  const list = (/** @type {boolean[]} */ flags, names = ["left", "right"]) => names.filter((_, index) => flags[index]).join(" and ") || "nowhere";
  const said = [];
  if (robot.bumper > 0) said.push(`Bumper pressed: ${list(of.bumper)}.`);
  if (robot.cliffs.some(Boolean)) said.push(`Cliff: ${list(of.cliffs, ["left", "front left", "front right", "right"])}.`);
  if (robot.light.length > 0) said.push(`Light bumper from left to right: ${of.light_signals.join(", ")}.`);
  if (robot.wheel_drops) said.push(`Wheels dropped: ${list(of.wheel_drops)}.`);
  return said.join(" ");
}
