// @ts-check
// FTDI's chips, such as the FT232R in iRobot's own cable. Facts: Linux, drivers/usb/serial/ftdi_sio.c and ftdi_sio.h; rates:
// FTDI, AN232B-05, "Configuring FT232R, FT2232 and FT232B Baud Rates".
import { failure } from "../ports.js";
import { release } from "./control.js";

/** @typedef {import("./types").Control} Control */

const RESET = 0;
const MODEM_CONTROL = 1;
const SET_FLOW = 2;
const SET_BAUD = 3;
const SET_DATA = 4;
const SET_LATENCY = 9;

const DTR_ON = 0x0101;
const RTS_OFF = 0x0200;
const RTS_ON = 0x0202;
const NO_FLOW = 0;
const EIGHT_N_1 = 8;
/**
 * How long the chip waits for more bytes before it sends what it has, ms. With its own 16 ms, a robot's readings, one in 15
 * ms, would come a reading late; with 1 ms, the phone would be kept busy with packets that are empty.
 */
const LATENCY_MS = 4;

/** `bcdDevice` of chips, where it matters. */
const FT232AM = 0x0200;
const FT232R = 0x0600;
const FT2232 = 0x0500;

/** Each packet begins with two bytes of status. The second has the errors of the line. */
const STATUS_BYTES = 2;
const OVERRUN = 0x02;
const PARITY = 0x04;
const FRAMING = 0x08;
const BREAK = 0x10;

/** The clock that is divided; chips that have a faster one besides begin with this one. */
const CLOCK_HZ = 3_000_000;
/** Eighths of the divisor as its topmost three bits, 16 to 14. */
const EIGHTHS = [0, 3, 2, 4, 1, 5, 6, 7];

/** The divisor for a rate: whole part in bits 13 to 0, eighths above. @param {number} baud */
export function divisor(baud) {
  const eighths = Math.round((8 * CLOCK_HZ) / baud);
  return (eighths >> 3) | (EIGHTHS[eighths & 7] << 14);
}

/** The port of a chip that has several counts from 1; the others have number 0. @param {Control} control */
const port = ({ device }) => ((device.configuration?.interfaces.length ?? 1) > 1 ? 1 : 0);

/** @param {Control} control @param {number} request @param {number} value @param {number} [index] */
const send = (control, request, value, index = port(control)) => control.write({ requestType: "vendor", recipient: "device", request, value, index });

/** @type {import("./types").Chip} */
export const ftdi = {
  name: "FTDI",
  // FT232B and R (iRobot's cable), FT2232, FT4232H, FT232H, FT230X to FT234X.
  filters: [0x6001, 0x6010, 0x6011, 0x6014, 0x6015].map((productId) => ({ vendorId: 0x0403, productId })),

  async start(control, baud) {
    const { device } = control;
    const version = release(device);
    // FT232B have the number of the AM if they have no serial number.
    if (version < FT232AM || (version === FT232AM && device.serialNumber)) {
      throw failure("unsupported", "This adapter has an early FTDI chip (FT8U232AM), which this page has no driver for.", "Use another cable.");
    }
    await send(control, RESET, 0);
    const rate = divisor(baud);
    const high = rate >> 16;
    // Chips with several ports, and those later than the R, have the port in the low byte.
    const isWide = version >= FT2232 && version !== FT232R;
    await send(control, SET_BAUD, rate & 0xffff, isWide ? (high << 8) | port(control) : high);
    await send(control, SET_DATA, EIGHT_N_1);
    // The kind of flow control is in the high byte of the index.
    await send(control, SET_FLOW, 0, (NO_FLOW << 8) | port(control));
    await send(control, SET_LATENCY, LATENCY_MS);
    await send(control, MODEM_CONTROL, DTR_ON);
    await this.setRts(control, false);
  },

  setRts: (control, isOn) => send(control, MODEM_CONTROL, isOn ? RTS_ON : RTS_OFF),

  unpack(data, packetSize, onerror) {
    const bytes = new Uint8Array(data.length);
    let length = 0;
    for (let at = 0; at < data.length; at += packetSize) {
      const packet = data.subarray(at, at + packetSize);
      // Empty packets repeat the errors of the one before.
      if (packet.length <= STATUS_BYTES) continue;
      const status = packet[1];
      if (status & OVERRUN) onerror("overrun");
      if (status & BREAK) onerror("break");
      else if (status & PARITY) onerror("parity");
      else if (status & FRAMING) onerror("framing");
      bytes.set(packet.subarray(STATUS_BYTES), length);
      length += packet.length - STATUS_BYTES;
    }
    return bytes.subarray(0, length);
  },
};
