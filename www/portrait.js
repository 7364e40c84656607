// @ts-check
// A robot from above, drawn with what its sensors report: bumper, cliff sensors, light bumper, wheels.
import { setAttribute, setText } from "./dom.js";

/**
 * @typedef {import("./types").RobotEntry} Robot
 * @typedef {(name: string) => number} Reading What a sensor reads, by its name in the catalogue.
 * @typedef {{ svg: SVGSVGElement, show: (of: Reading) => void }} Portrait
 */

/** Radius of the robot, and where the bars of the light bumper begin and end, units of the drawing. */
const RADIUS = 58;
const BARS = [72, 108];
/** Distance of the middle line of the bumper from the centre, and of the numbers of the bars. */
const BUMPER = 63;
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

/** @param {Robot} robot @returns {Portrait} */
export function portrait(robot) {
  const hasLight = robot.light.length > 0;
  const top = hasLight ? -NUMBERS - 12 : -RADIUS - 14;
  const svg = draw("svg", { viewBox: `-140 ${top} 280 ${RADIUS + 12 - top}`, class: "portrait", role: "img" });
  /** @type {((of: Reading) => void)[]} */
  const parts = [];
  body(svg, robot, parts);
  if (robot.bumper > 0) bumper(svg, robot.bumper, parts);
  robot.light.forEach((angle, index) => bar(svg, angle, index, parts));
  const front = robot.cliffs[1];
  const isSingle = front && robot.cliffs[2] && front[0] === robot.cliffs[2][0] && front[1] === robot.cliffs[2][1];
  robot.cliffs.forEach((spot, index) => {
    // A single front sensor is listed twice.
    if (spot && !(index === 2 && isSingle)) cliff(svg, spot, index, parts);
  });
  return {
    svg,
    show: (of) => {
      for (const part of parts) part(of);
      setAttribute(svg, "aria-label", words(robot, of));
    },
  };
}

/** @param {SVGElement} svg @param {Robot} robot @param {((of: Reading) => void)[]} parts */
function body(svg, robot, parts) {
  if (robot.body.length === 0) draw("circle", { r: RADIUS, class: "body" }, svg);
  else draw("polygon", { points: robot.body.map(([x, y]) => at(x, y).map(round).join()).join(" "), class: "body" }, svg);
  const half = Math.max(9, robot.wheel_radius * RADIUS);
  for (const [side, counts, drop] of /** @type {[number, string, string][]} */ ([[1, "left_counts", "drop_left"], [-1, "right_counts", "drop_right"]])) {
    const [x] = at(0, (side * robot.wheel_base) / 2);
    const wheel = draw("line", { x1: round(x), x2: round(x), y1: -half, y2: half, class: "wheel" }, svg);
    const tread = draw("line", { x1: round(x), x2: round(x), y1: -half, y2: half, class: "tread" }, svg);
    parts.push((of) => {
      setAttribute(tread, "stroke-dashoffset", String(round(((of(counts) % TREAD) / TREAD) * 4)));
      setAttribute(wheel, "class", of(drop) ? "wheel on" : "wheel");
    });
  }
  draw("path", { d: "M0 -34 L9 -18 H-9 Z", class: "heading" }, svg);
}

/** @param {SVGElement} svg @param {number} half @param {((of: Reading) => void)[]} parts */
function bumper(svg, half, parts) {
  for (const [side, name] of /** @type {[number, string][]} */ ([[1, "bump_left"], [-1, "bump_right"]])) {
    const [from, to] = [polar(BUMPER, side * 0.04), polar(BUMPER, side * half)];
    const arc = draw("path", { d: `M${from.map(round)} A${BUMPER} ${BUMPER} 0 0 ${side > 0 ? 0 : 1} ${to.map(round)}` }, svg);
    parts.push((of) => setAttribute(arc, "class", of(name) ? "bumper on" : "bumper"));
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
    const signal = of(`light_signal_${index}`);
    // The signal falls steeply with distance: its root is easier to read.
    setAttribute(level, "stroke-dashoffset", String(round(100 * (1 - Math.sqrt(Math.min(1, signal / FULL))))));
    setAttribute(level, "class", of(`light_${index}`) ? "level near" : signal > 0 ? "level" : "level none");
    setText(number, String(signal));
  });
}

/** @param {SVGElement} svg @param {readonly [number, number]} spot @param {number} index @param {((of: Reading) => void)[]} parts */
function cliff(svg, [x, y], index, parts) {
  const [cx, cy] = at(x, y).map(round);
  const dot = draw("circle", { cx: cx ?? 0, cy: cy ?? 0, r: 4.5 }, svg);
  const inward = y > 0.5 ? 8 : y < -0.5 ? -8 : 0;
  const anchor = inward > 0 ? "start" : inward < 0 ? "end" : "middle";
  // The front two stand close together.
  const aside = inward === 0 ? Math.sign(-y) * 3 : 0;
  const number = draw("text", { x: (cx ?? 0) + inward + aside, y: (cy ?? 0) + (inward === 0 ? 14 : 3), style: `text-anchor: ${anchor}`, class: "number inner" }, svg);
  parts.push((of) => {
    setAttribute(dot, "class", of(`cliff_${index}`) ? "cliff on" : "cliff");
    setText(number, String(of(`cliff_signal_${index}`)));
  });
}

/** What the drawing shows, for those who can't see it. @param {Robot} robot @param {Reading} of */
function words(robot, of) {
  const list = (/** @type {(string | false)[]} */ ...names) => names.filter(Boolean).join(" and ") || "nowhere";
  const said = [];
  if (robot.bumper > 0) said.push(`Bumper pressed: ${list(of("bump_left") > 0 && "left", of("bump_right") > 0 && "right")}.`);
  if (robot.cliffs.some(Boolean)) {
    const names = ["left", "front left", "front right", "right"];
    said.push(`Cliff: ${list(...names.map((name, index) => of(`cliff_${index}`) > 0 && name))}.`);
  }
  if (robot.light.length > 0) said.push(`Light bumper from left to right: ${robot.light.map((_, index) => of(`light_signal_${index}`)).join(", ")}.`);
  if (robot.wheel_drops) said.push(`Wheels dropped: ${list(of("drop_left") > 0 && "left", of("drop_right") > 0 && "right")}.`);
  return said.join(" ");
}
