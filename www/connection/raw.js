// @ts-check
// Bytes as people type them.

/** Most that is sent at once. */
const MOST = 256;
/** Another baud rate: the robot would be where this page doesn't hear it. */
const BAUD = 129;
/** Commands that move the robot: opcode and name. */
const MOTION = new Map([[134, "Spot"], [135, "Clean"], [136, "Max"], [137, "Drive"], [138, "Motors"], [143, "Seek Dock"], [144, "PWM Motors"], [145, "Drive Direct"], [146, "Drive PWM"], [165, "Buttons"], [167, "Schedule"]]);
/** Data bytes behind each opcode; of 140, 148 and 149 as many as a byte of it says. @type {Record<number, number>} */
const DATA = { 129: 1, 137: 4, 138: 1, 139: 3, 141: 1, 142: 1, 144: 3, 145: 4, 146: 4, 150: 1, 162: 2, 163: 4, 164: 4, 165: 1, 167: 15, 168: 3 };

/**
 * Bytes in decimal (142 35) or hexadecimal (0x8e 0x23), or all in hexadecimal if `hex`; a message otherwise.
 * @param {string} text
 * @returns {{ bytes: number[], fault: string }}
 */
export function parse(text) {
  const words = [...text.matchAll(/[^\s,;]+/g)];
  /** @type {number[]} */
  const bytes = [];
  for (const [index, match] of words.entries()) {
    const word = match[0];
    const place = `Byte ${index + 1} ("${word}", at character ${match.index + 1})`;
    const isHex = /^(0x|\$)[0-9a-f]+$/i.test(word);
    if (!isHex && !/^\d+$/.test(word)) {
      const hint = /^[0-9a-f]+h?$/i.test(word) ? `write 0x${word.replace(/h$/i, "")} for hexadecimal` : "write decimal numbers, or hexadecimal ones with 0x";
      return { bytes: [], fault: `${place} isn't a number: ${hint}.` };
    }
    const value = isHex ? Number.parseInt(word.replace(/^(0x|\$)/i, ""), 16) : Number(word);
    if (value > 255) return { bytes: [], fault: `${place} is too large: a byte is 0 to 255.` };
    bytes.push(value);
  }
  if (bytes.length > MOST) return { bytes: [], fault: `These are ${bytes.length} bytes; at most ${MOST} can be sent at once.` };
  return { bytes, fault: "" };
}

/**
 * Names of what in it may move the robot, and why it can't be sent, "" if it can: what is incomplete would take the next
 * command, a stop perhaps, for its rest.
 * @param {number[]} bytes
 */
export function danger(bytes) {
  const names = new Set();
  let refused = "";
  let at = 0;
  while (at < bytes.length) {
    const opcode = bytes[at] ?? 0;
    const name = MOTION.get(opcode);
    if (name) names.add(`${name} (${opcode})`);
    if (opcode === BAUD) refused = "Baud (129) isn't sent: at another speed this page could neither receive from the robot nor stop it.";
    if (opcode === 140) at += 3 + 2 * (bytes[at + 2] ?? 0);
    else if (opcode === 148 || opcode === 149) at += 2 + (bytes[at + 1] ?? 0);
    else at += 1 + (DATA[opcode] ?? 0);
  }
  const lacks = at - bytes.length;
  if (lacks > 0) refused = `The last command lacks ${lacks} byte${lacks > 1 ? "s" : ""}: the robot would read the next bytes, even a stop command, as the rest of it. Complete it.`;
  return { names: [...names], refused };
}
