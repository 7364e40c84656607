// @ts-check
// The CP210x of Silicon Labs. Facts: Silicon Labs, AN571, "CP210x Virtual COM Port Interface"; Linux,
// drivers/usb/serial/cp210x.c. They report errors of the line only among its bytes, in a mode that copies of the CP2102 don't
// have and in which the CP2102 leaves out breaks (Linux a7207e9835a4), so errors aren't counted here.
import { Refused, u32 } from "./control.js";

/** @typedef {import("./types").Control} Control */

const ENABLE = 0x00;
const SET_DIVISOR = 0x01;
const SET_LINE = 0x03;
const SET_MODEM = 0x07;
const PURGE = 0x12;
const SET_FLOW = 0x13;
const SET_BAUD = 0x1e;

const EIGHT_N_1 = 0x0800;
const ALL_QUEUES = 0x000f;
/** High byte: which lines are meant; low byte: their states. */
const DTR_ON = 0x0101;
const RTS_OFF = 0x0200;
const RTS_ON = 0x0202;
/** Four words: handshake (bit 0: DTR is held active), flow (bits 7 and 6 are 0: RTS is held inactive), limits for XON, XOFF. */
const NO_FLOW = Uint8Array.of(1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);

/** What `SET_DIVISOR` divides, Hz. */
const CLOCK_HZ = 3_686_400;

/** @param {Control} control @param {number} request @param {number} value @param {Uint8Array} [data] */
function send(control, request, value, data) {
  const index = control.device.configuration?.interfaces[0].interfaceNumber ?? 0;
  return control.write({ requestType: "vendor", recipient: "interface", request, value, index }, data);
}

/** @type {import("./types").Chip} */
export const cp210x = {
  name: "CP210x",
  // CP2101 to CP2104, CP2109 and CP2102N; CP2105; CP2108.
  filters: [0xea60, 0xea70, 0xea71].map((productId) => ({ vendorId: 0x10c4, productId })),

  async start(control, baud) {
    await send(control, ENABLE, 1);
    try {
      await send(control, SET_BAUD, 0, u32(baud));
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      // The CP2101 and early CP2102 and CP2103 only know divisors.
      await send(control, SET_DIVISOR, Math.round(CLOCK_HZ / baud));
    }
    await send(control, SET_LINE, EIGHT_N_1);
    await send(control, SET_FLOW, 0, NO_FLOW);
    await send(control, PURGE, ALL_QUEUES);
    await send(control, SET_MODEM, DTR_ON);
    await this.setRts(control, false);
  },

  setRts: (control, isOn) => send(control, SET_MODEM, isOn ? RTS_ON : RTS_OFF),

  stop: (control) => send(control, ENABLE, 0),
};
