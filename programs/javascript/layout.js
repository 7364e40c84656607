// @ts-check
// Readings of the protocol as numbers at places: for programs that get them as JSON. The page has the simulator's own.

const FLOATS = ["time", "x", "y", "heading", "distance", "turned", "charge", "voltage", "current", "left_speed", "right_speed"];
const FLAGS = ["bump_left", "bump_right", "wheel_drop_left", "wheel_drop_right", "cliff_left", "cliff_front_left", "cliff_front_right", "cliff_right",
  "wall", "virtual_wall", "docked", "stasis", "overcurrent_left", "overcurrent_right", "overcurrent_brush", "overcurrent_side_brush"];
const WHOLE = ["step", "cliff_left_signal", "cliff_front_left_signal", "cliff_front_right_signal", "cliff_right_signal", "wall_signal", "dirt",
  "infrared_omni", "infrared_left", "infrared_right", "left_counts", "right_counts", "laser_scan"];

let places = 0;
const slot = (/** @type {string} */ name, /** @type {number} */ count, /** @type {boolean} */ flag) => {
  const index = places;
  places += count;
  return { name, index, count, flag };
};
const slots = [
  ...FLOATS.map((name) => slot(name, 1, false)), ...FLAGS.map((name) => slot(name, 1, true)), ...WHOLE.map((name) => slot(name, 1, false)),
  slot("light_bumper", 6, true), slot("light", 6, false),
];
/** All readings of the protocol. */
export const LAYOUT = { slots, laser: places };

/** Writes a message's readings; keeps the laser's last ones. @param {Record<string, any>} message @param {Float64Array} readings */
export function pack(message, readings) {
  for (const { name, index, count } of slots) {
    if (count > 1) for (let at = 0; at < count; at++) readings[index + at] = Number(message[name]?.[at] ?? 0);
    else readings[index] = Number(message[name] ?? 0);
  }
  message.laser?.forEach((/** @type {number | null} */ range, /** @type {number} */ beam) => { readings[places + beam] = range ?? Infinity; });
}
