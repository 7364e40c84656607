// @ts-check
// The robot's sensors, from the packets that it sends, on the dashboard that Explore has too.
import { byId, make, setHidden, setText } from "../dom.js";
import { instruments, row } from "../dashboard.js";
import { count } from "../format.js";
import { portrait } from "../portrait.js";

/** Milliseconds between looks: faster numbers can't be read. */
const PAUSE = 60;

/** Values that only a real robot has: name, definition, text. @type {[name: string, tip: string, text: (of: import("./types").RoombaView) => string][]} */
const MORE = [
  ["Wall signal", "Strength of the wall sensor on the right, 0 to 1023 (packet 27).", (of) => count(of.wall_signal)],
  ["Power", "Voltage of the battery, and its charge (packets 22, 25 and 26).", (of) => `${of.voltage_v.toFixed(2)} V, ${count(of.charge_mah)} of ${count(of.capacity_mah)} mAh`],
  ["Charging", "Charging state, and where the power comes from (packets 21 and 34).", (of) => of.charging],
  ["Temperature", "Of the battery (packet 24).", (of) => `${of.temperature_c} °C`],
  ["Motor currents", "Left wheel, right wheel, main brush, side brush (packets 54 to 57).", (of) => `${of.motors_ma.join(" · ")} mA`],
  ["Requested speeds", "Speeds last commanded, left and right wheel (packets 42 and 41).", (of) => `${of.requested_mm_s.join(" · ")} mm/s`],
  ["Buttons", "Buttons on the robot that are pressed (packet 18).", (of) => of.buttons.join(", ") || "none"],
  ["Song", "Number of the song, and whether it plays (packets 36 and 37).", (of) => `${of.song}${of.song_plays ? ", playing" : ""}`],
];

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: import("./types").ConnectionView) => void} */
export function startSensors(it) {
  const board = byId("connection-dashboard");
  const robot = it.app.catalogue.robots.find(({ id }) => id === "roomba600");
  if (!robot) throw new Error("there is no Roomba 600 in the catalogue");
  const { svg, show } = portrait(robot, "connection-portrait");
  const parts = instruments(robot);
  const more = MORE.map(([name, tip, text]) => {
    const value = make("span", { className: "value" });
    return { node: row(name, tip, value), value, text };
  });
  board.replaceChildren(svg, ...parts.map(({ node }) => node), ...more.map(({ node }) => node));
  let looked = 0;

  return ({ readings }) => {
    setHidden(board, !readings);
    setHidden(byId("connection-senses-none"), readings !== null);
    const now = performance.now();
    if (!readings || now - looked < PAUSE || !board.checkVisibility({ visibilityProperty: true })) return;
    looked = now;
    show(readings.sensors);
    for (const part of parts) part.show(readings.sensors);
    for (const { value, text } of more) setText(value, text(readings));
  };
}
