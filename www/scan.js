// @ts-check
// A laser's scan, seen from above with the robot in the middle and ahead up.
import { make, setAttribute, setText } from "./dom.js";
import { draw } from "./portrait.js";

/** Radius of the plot. */
const RADIUS = 70;
/** Ring every so many metres, whichever gives two to five of them. */
const RINGS = [0.25, 0.5, 1, 2, 5];

/** @param {import("./types").RobotEntry} robot */
export function scanPlot(robot) {
  const [first = 0, step = 0, range = 1, ahead = 0, left = 0] = robot.laser;
  const svg = draw("svg", { viewBox: "-76 -76 152 152", class: "scan", role: "img" });
  const every = RINGS.find((metres) => range / metres <= 5) ?? range;
  for (let metres = every; metres <= range * 1.001; metres += every) draw("circle", { r: ((metres / range) * RADIUS).toFixed(1), class: "ring" }, svg);
  const seen = draw("path", { class: "seen" }, svg);
  const metre = RADIUS / range;
  // Small as it is, the robot shows which way it looks.
  const corners = robot.body.length > 0 ? robot.body : [[0, 1], [0.9, 0], [0, -1], [-0.9, 0]];
  const self = corners.map(([x = 0, y = 0]) => [(left - y * robot.radius_m) * metre, (ahead - x * robot.radius_m) * metre]);
  draw("polygon", { points: self.map((corner) => corner.map((value) => value.toFixed(1)).join()).join(" "), class: "self" }, svg);
  const text = make("figcaption");
  const node = make("figure", { className: "laser" }, svg, text);
  return {
    node,
    /** @param {Float32Array} scan */
    show: (scan) => {
      let path = "";
      let nearest = Infinity;
      scan.forEach((metres, beam) => {
        if (metres < nearest) nearest = metres;
        const r = (Math.min(metres, range) / range) * RADIUS;
        const angle = first + beam * step;
        path += `${path ? "L" : "M"}${(-r * Math.sin(angle)).toFixed(1)} ${(-r * Math.cos(angle)).toFixed(1)}`;
      });
      setAttribute(seen, "d", path ? `${path}Z` : "M0 0");
      const words = Number.isFinite(nearest) ? `Laser: nearest at ${nearest.toFixed(2)} m` : "Laser: nothing in range";
      setText(text, `${words}; rings every ${every} m`);
      setAttribute(svg, "aria-label", words);
    },
  };
}
