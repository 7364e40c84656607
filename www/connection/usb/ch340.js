// @ts-check
// The CH340 and CH341 of WCH. Facts: Linux, drivers/usb/serial/ch341.c. Its interrupt endpoint reports modem lines, not errors.
import { Refused } from "./control.js";

/** @typedef {import("./types").Control} Control */

const READ_VERSION = 0x5f;
const READ_REGISTERS = 0x95;
const WRITE_REGISTERS = 0x9a;
const START = 0xa1;
const SET_MODEM = 0xa4;

/** Registers are named in pairs: the second in the high byte. */
const BREAK = 0x05;
const PRESCALER_AND_DIVISOR = 0x1312;
const LINE_CONTROL = 0x2518;

/** Receiver and transmitter on, 8 data bits. */
const EIGHT_N_1 = 0xc3;
/** Sends bytes on as they arrive rather than 32 at a time. */
const AT_ONCE = 0x80;
const DTR = 0x20;
const RTS = 0x40;

/** Up to this version, `AT_ONCE` means the opposite. */
const INVERTED = 0x27;
/** From this version, line control is one register that can be written. */
const ONE_REGISTER = 0x30;

const CLOCK_HZ = 48_000_000;

/**
 * What the registers of prescaler (low byte) and divisor (high byte, negated) are set to:
 * rate = 48 MHz / (2^(12 - 3 prescaler - fact) divisor), with fact in bit 2. `isLimited`: the chip has fact = 1 only with the
 * fastest prescaler.
 * @param {number} baud @param {boolean} isLimited
 */
export function rateRegisters(baud, isLimited) {
  /** @type {{ error: number, value: number } | undefined} */
  let best;
  for (const prescaler of [3, 2, 1, 0]) {
    // 0 first: of two that are as close, it tolerates more on the line.
    for (const fact of isLimited && prescaler < 3 ? [0] : [0, 1]) {
      const clock = CLOCK_HZ / 2 ** (12 - 3 * prescaler - fact);
      const divisor = Math.round(clock / baud);
      if (divisor < (fact ? 9 : 2) || divisor > 256) continue;
      const error = Math.abs(clock / divisor - baud);
      if (!best || error < best.error) best = { error, value: ((256 - divisor) << 8) | (fact << 2) | prescaler };
    }
  }
  if (!best) throw new RangeError(`The CH340 has no rate of ${baud} baud.`);
  return best.value;
}

/** @param {Control} control @param {number} request @param {number} value @param {number} index */
const send = (control, request, value, index) => control.write({ requestType: "vendor", recipient: "device", request, value, index });
/** Two bytes. @param {Control} control @param {number} request @param {number} value */
const read = (control, request, value) => control.read({ requestType: "vendor", recipient: "device", request, value, index: 0 }, 2);

/** Chips that can't send breaks refuse that register, and have fewer rates. @param {Control} control */
async function isLimited(control) {
  try {
    await read(control, READ_REGISTERS, BREAK);
    return false;
  } catch (error) {
    if (error instanceof Refused) return true;
    throw error;
  }
}

/** @type {import("./types").Chip} */
export const ch340 = {
  name: "CH340",
  // CH341, CH340K, CH340.
  filters: [0x5523, 0x7522, 0x7523].map((productId) => ({ vendorId: 0x1a86, productId })),

  async start(control, baud) {
    const [version] = await read(control, READ_VERSION, 0);
    await send(control, START, 0, 0);
    const rate = rateRegisters(baud, await isLimited(control));
    await send(control, WRITE_REGISTERS, PRESCALER_AND_DIVISOR, version > INVERTED ? rate | AT_ONCE : rate);
    // Earlier ones have 8 data bits, no parity and one stop bit once they have been started.
    if (version >= ONE_REGISTER) await send(control, WRITE_REGISTERS, LINE_CONTROL, EIGHT_N_1);
    await this.setRts(control, false);
  },

  // Negated, all 16 bits.
  setRts: (control, isOn) => send(control, SET_MODEM, 0xffff & ~(isOn ? DTR | RTS : DTR), 0),
};
