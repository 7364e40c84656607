// @ts-check
// Infrared characters in words: beams of docks, virtual walls and remote controls (Create 2 Open Interface, packets 17, 52
// and 53).

/** Bits that the docks of the 600 series (from 160) and of the Discovery (from 240) add for each beam. @type {[base: number, field: number, green: number, red: number][]} */
const DOCKS = [
  [160, 1, 4, 8],
  [240, 2, 4, 8],
];
const VIRTUAL_WALL = 162;
/** Characters of the remote control. */
const REMOTE = [129, 143];

/** @typedef {{ green: boolean, red: boolean, field: boolean, wall: boolean, text: string }} Beams */

/** @param {number} character 0 for none @returns {Beams} */
export function decode(character) {
  const none = { green: false, red: false, field: false, wall: false };
  if (character === 0) return { ...none, text: "–" };
  if (character === VIRTUAL_WALL) return { ...none, wall: true, text: "virtual wall" };
  for (const [base, field, green, red] of DOCKS) {
    const bits = character - base;
    if (bits <= 0 || (bits & ~(field | green | red)) !== 0) continue;
    const beams = { ...none, field: (bits & field) !== 0, green: (bits & green) !== 0, red: (bits & red) !== 0 };
    const names = [beams.green && "green", beams.red && "red", beams.field && "field"].filter(Boolean);
    return { ...beams, text: names.join(" + ") };
  }
  const isRemote = character >= (REMOTE[0] ?? 0) && character <= (REMOTE[1] ?? 0);
  return { ...none, text: isRemote ? "remote" : String(character) };
}
