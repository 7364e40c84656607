// @ts-check
// The robot's sensors, from the packets that it sends, on the dashboard that Explore has too.
import { byId, make, setHidden, setText } from "../dom.js";
import { instruments, row } from "../dashboard.js";
import { count } from "../format.js";
import { portrait } from "../portrait.js";
import { packet, signed } from "./view.js";

/** Milliseconds between looks: faster numbers can't be read. */
const PAUSE = 60;
/** Packet 21. */
const CHARGING = ["not charging", "reconditioning", "full charging", "trickle charging", "waiting", "charging fault"];
/** Bits of packet 18. */
const BUTTONS = ["Clean", "Spot", "Dock", "Minute", "Hour", "Day", "Schedule", "Clock"];

/** Names of the dashboard, and what they are on the line. @type {Record<string, (packets: number[]) => number>} */
const READINGS = {
  bump_right: bit(7, 0), bump_left: bit(7, 1), drop_right: bit(7, 2), drop_left: bit(7, 3),
  wall: of(8), cliff_0: of(9), cliff_1: of(10), cliff_2: of(11), cliff_3: of(12), virtual_wall: of(13),
  over_side_brush: bit(14, 0), over_main_brush: bit(14, 2), over_right_wheel: bit(14, 3), over_left_wheel: bit(14, 4),
  dirt: of(15), infrared_omni: of(17), infrared_left: of(52), infrared_right: of(53),
  cliff_signal_0: of(28), cliff_signal_1: of(29), cliff_signal_2: of(30), cliff_signal_3: of(31), wall_signal: of(27),
  left_counts: of(43), right_counts: of(44), stasis: bit(58, 0), voltage_mv: of(22), capacity_mah: of(26),
  current_ma: (packets) => signed(packets, 23),
  // An empty battery's charge runs below zero, and round.
  charge_mah: (packets) => Math.max(0, signed(packets, 25)),
  battery_share: (packets) => Math.min(1, Math.max(0, signed(packets, 25)) / Math.max(1, packet(packets, 26))),
  on_dock: bit(34, 1),
};
for (let beam = 0; beam < 6; beam += 1) {
  READINGS[`light_${beam}`] = bit(45, beam);
  READINGS[`light_signal_${beam}`] = of(46 + beam);
}

/** @param {number} id */
function of(id) {
  return (/** @type {number[]} */ packets) => packet(packets, id);
}
/** @param {number} id @param {number} place */
function bit(id, place) {
  return (/** @type {number[]} */ packets) => (packet(packets, id) >> place) & 1;
}

/** What only a real robot has: name, definition, text. @type {[name: string, tip: string, text: (packets: number[]) => string][]} */
const MORE = [
  ["Wall signal", "Strength of the wall sensor on the right, 0 to 1023 (packet 27).", (p) => count(packet(p, 27))],
  ["Power", "Voltage of the battery, and its charge (packets 22, 25 and 26).", (p) => `${(packet(p, 22) / 1000).toFixed(2)} V, ${count(Math.max(0, signed(p, 25)))} of ${count(packet(p, 26))} mAh`],
  ["Charging", "Charging state, and where the power comes from (packets 21 and 34).", (p) => `${CHARGING[packet(p, 21)] ?? packet(p, 21)}${["", ", charger plugged in", ", home base", ", both chargers"][packet(p, 34) & 3]}`],
  ["Temperature", "Of the battery (packet 24).", (p) => `${packet(p, 24) > 127 && packet(p, 24) < 256 ? packet(p, 24) - 256 : signed(p, 24)} °C`],
  ["Motor currents", "Left wheel, right wheel, main brush, side brush (packets 54 to 57).", (p) => `${[54, 55, 56, 57].map((id) => signed(p, id)).join(" · ")} mA`],
  ["Requested speeds", "Speeds last commanded, left and right wheel (packets 42 and 41).", (p) => `${signed(p, 42)} · ${signed(p, 41)} mm/s`],
  ["Buttons", "Buttons on the robot that are pressed (packet 18).", (p) => BUTTONS.filter((_, place) => (packet(p, 18) >> place) & 1).join(", ") || "none"],
  ["Song", "Number of the song, and whether it plays (packets 36 and 37).", (p) => `${packet(p, 36) + 1}${packet(p, 37) ? ", playing" : ""}`],
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

  return ({ packets, phase }) => {
    const isThere = packets.length > 0 && (phase === "connected" || phase === "lost");
    setHidden(board, !isThere);
    setHidden(byId("connection-senses-none"), isThere);
    const now = performance.now();
    if (!isThere || now - looked < PAUSE || !board.checkVisibility({ visibilityProperty: true })) return;
    looked = now;
    const reading = (/** @type {string} */ name) => READINGS[name]?.(packets) ?? 0;
    show(reading);
    for (const part of parts) part.show(reading);
    for (const { value, text } of more) setText(value, text(packets));
  };
}
