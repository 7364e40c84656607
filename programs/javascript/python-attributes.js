// @ts-check
// Readings go into MicroPython without a call: fractions into an array of the package; flags and whole numbers that have
// changed straight into the robot's attributes.

/** As in robot.py. */
const FLOATS = ["time", "x", "y", "heading", "distance", "turned", "charge", "voltage", "current", "left_speed", "right_speed"];
/** As in page.py. */
const MARKER = 1000000;
/** How MicroPython 1.27 keeps true, false and whole numbers in a word (py/obj.h, representation A). */
const TRUE = 30;
const FALSE = 14;
const small = (/** @type {number} */ value) => (value << 1) | 1;
/** Words of an instance: its type, then a map of its attributes: flags, places, address of (name, value) pairs (py/objtype.h). */
const [PLACES, TABLE] = [2, 3];

/**
 * Writes readings of that layout for a robot.
 * @param {import("./micropython-calls.js").Heap} heap
 * @param {{names: string[], flags: number, robotAt: number, floatsAt: number}} of the attributes' names, how many of them are flags,
 *   where the robot is (in words) and where its fractions are (in doubles). Each attribute has its number, from MARKER on.
 * @param {import("./robot.js").Layout} layout @param {number} beams of the laser @param {() => unknown[]} check the attributes as Python sees them
 */
export function attributeWriter(heap, { names, flags, robotAt, floatsAt }, layout, beams, check) {
  let table = heap.words[robotAt + TABLE];
  const keys = new Int32Array(names.length);
  const places = new Int32Array(names.length);
  const pairs = () => heap.words.subarray(table >> 2, (table >> 2) + 2 * heap.words[robotAt + PLACES]);
  {
    const words = pairs();
    for (let at = 0; at < words.length; at += 2) {
      const index = (words[at + 1] >> 1) - MARKER;
      if (index >= 0 && index < names.length && words[at + 1] === small(MARKER + index)) keys[index] = words[at];
    }
  }
  /** The table moves when the program gives the robot attributes of its own. */
  const find = () => {
    table = heap.words[robotAt + TABLE];
    const words = pairs();
    for (let at = 0; at < words.length; at += 2) {
      const index = words[at] ? keys.indexOf(words[at]) : -1;
      if (index >= 0) places[index] = (table >> 2) + at + 1;
    }
  };
  find();
  const laserAt = layout.laser;
  const indices = Object.fromEntries(layout.slots.map(({ name: slot, index }) => [slot, index]));
  const floatFrom = FLOATS.map((slot) => indices[slot] ?? -1);
  /** @type {Record<string, string[]>} */
  const anyOf = { bump: ["bump_left", "bump_right"], wheel_drop: ["wheel_drop_left", "wheel_drop_right"], cliff: ["cliff_left", "cliff_right"] };
  /** First and last reading of each attribute: it is their greatest. */
  const spans = names.slice(0, -2).map((slot) => {
    const list = /^_([bs])(\d)$/.exec(slot);
    if (list) return [0, 1].map(() => indices[list[1] === "b" ? "light_bumper" : "light"] + Number(list[2]));
    return (anyOf[slot] ?? [slot, slot]).map((part) => indices[part]);
  });
  const isFlag = spans.map((_, index) => index < flags || names[index].startsWith("_b"));
  // Behind them: whether the lists of six have to be put together again.
  const [bumperAt, signalsAt] = [names.indexOf("_b0"), names.indexOf("_s0")];
  const [oldBumper, oldSignals] = [names.length - 2, names.length - 1];
  const begin = Int32Array.from(spans, ([from]) => from ?? -1);
  const isSingle = Uint8Array.from(spans, ([from, to]) => (from === to ? 1 : 0));
  const last = Int32Array.from(spans, ([, to]) => to ?? -1);
  const flag = Uint8Array.from(isFlag, Number);
  const sent = new Float64Array(spans.length).fill(NaN);
  let scan = -1;

  /** @param {Float64Array} readings */
  const write = (readings) => {
    const { words, doubles } = heap;
    if (words[robotAt + TABLE] !== table) {
      find();
      sent.fill(NaN);
    }
    for (let index = 0; index < floatFrom.length; index++) doubles[floatsAt + index] = readings[floatFrom[index]];
    for (let index = 0; index < begin.length; index++) {
      const from = begin[index];
      let value = readings[from];
      if (isSingle[index] === 0) for (let at = from + 1; at <= last[index]; at++) if (readings[at] > value) value = readings[at];
      if (value === sent[index]) continue;
      sent[index] = value;
      words[places[index]] = flag[index] === 1 ? (value === 0 ? FALSE : TRUE) : small(value);
      if (index >= signalsAt) words[places[oldSignals]] = TRUE;
      else if (index >= bumperAt) words[places[oldBumper]] = TRUE;
    }
    if (beams > 0 && readings[indices.laser_scan] !== scan) {
      scan = readings[indices.laser_scan];
      doubles.set(readings.subarray(laserAt, laserAt + beams), floatsAt + FLOATS.length);
    }
  };
  // The layout of MicroPython's objects is no interface of it, so it is checked before anything relies on it.
  const trial = Float64Array.from({ length: laserAt + beams }, (_, index) => index % 2);
  write(trial);
  const seen = check();
  const wrong = spans.findIndex((_, index) => seen[index] !== (flag[index] ? sent[index] !== 0 : sent[index]));
  if (wrong >= 0) throw new Error(`MicroPython's robot.${names[wrong]} is not where it was expected: this needs version 1.27.0`);
  write(trial.fill(0));
  return {
    write,
    /** Has all written anew: the memory has changed. */
    forget() {
      find();
      sent.fill(NaN);
      scan = -1;
    },
  };
}
