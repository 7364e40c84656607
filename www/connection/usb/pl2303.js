// @ts-check
// The PL2303 of Prolific. Facts: Linux, drivers/usb/serial/pl2303.c. Line settings are those of USB's class of communication
// devices (CDC, PSTN subclass, revision 1.2, section 6.3), what makes the chip ready is its own.
import { failure } from "../ports.js";
import { release, u32 } from "./control.js";

/** @typedef {import("./types").Control} Control */
/** @typedef {"H" | "HX" | "HXN"} Type H: the first. HX: also the HXD, TA and TB, which differ only at rates no robot has. HXN: those called G. */

const SET_LINE = 0x20;
const SET_MODEM = 0x22;
const DTR = 0x01;
const RTS = 0x02;

/** Reading and writing registers. The HXN has requests of its own. */
const REGISTERS = 0x01;
const HXN_READ = 0x81;
const HXN_WRITE = 0x80;

/** Only chips before the HXN answer this. */
const HX_STATUS = 0x8080;
const FLOW = 0x00;
/** Registers are read at an address with this bit. */
const READ = 0x80;
const FLOW_BITS = 0xf0;
const HXN_FLOW = 0x0a;
const HXN_FLOW_BITS = 0x1c;
const HXN_NO_FLOW = 0x1c;
const RESET_OUT = 0x08;
const RESET_IN = 0x09;
const HXN_RESET = 0x07;
const HXN_RESET_BOTH = 0x03;

const DEVICE_DESCRIPTOR = 0x0100;
const DESCRIPTOR_BYTES = 18;
const MAX_PACKET_SIZE_AT = 7;

/** A packet of the interrupt endpoint has the line's state at its ninth byte. */
const STATE_AT = 8;
const ERRORS = /** @type {const} */ ([[0x04, "break"], [0x10, "framing"], [0x20, "parity"], [0x40, "overrun"]]);

/** @param {number} request @param {number} value @param {number} index @returns {import("./types").UsbSetup} */
const vendor = (request, value, index) => ({ requestType: "vendor", recipient: "device", request, value, index });
/** @param {number} request @param {number} value @returns {import("./types").UsbSetup} */
const line = (request, value) => ({ requestType: "class", recipient: "interface", request, value, index: 0 });

/** @param {Control} control @returns {Promise<Type>} */
async function typeOf(control) {
  const { device } = control;
  const descriptor = await control.read({ requestType: "standard", recipient: "device", request: 6, value: DEVICE_DESCRIPTOR, index: 0 }, DESCRIPTOR_BYTES);
  if (device.deviceClass === 2 || descriptor[MAX_PACKET_SIZE_AT] !== 64) return "H";
  if (device.usbVersionMajor < 2) return "HX";
  const version = release(device);
  // The TA has the number of a GT, the TB that of a GE.
  if ((version === 0x300 || version === 0x500) && (await answersAsHx(control))) return "HX";
  // GC, GT, GL, GE, GS, GR.
  if ([0x100, 0x300, 0x400, 0x500, 0x600, 0x700].includes(version & ~0x005)) return "HXN";
  throw failure("unsupported", `This adapter has a Prolific chip of a version that this page doesn't know (${version.toString(16)}).`, "Use another cable.");
}

/** @param {Control} control */
const answersAsHx = (control) => control.read(vendor(REGISTERS, HX_STATUS, 0), 1).then(() => true, () => false);

/** What Prolific's own driver does first; undocumented. @param {Control} control @param {Type} type */
async function wake(control, type) {
  const read = (/** @type {number} */ value) => control.read(vendor(REGISTERS, value, 0), 1);
  const write = (/** @type {number} */ value, /** @type {number} */ index) => control.write(vendor(REGISTERS, value, index));
  for (const index of [0, 1]) {
    await read(0x8484);
    await write(0x0404, index);
    await read(0x8484);
    await read(0x8383);
  }
  await write(0, 1);
  await write(1, 0);
  await write(2, type === "H" ? 0x24 : 0x44);
}

/** @param {Control} control @param {Type} type */
async function clearBuffers(control, type) {
  if (type === "HXN") return control.write(vendor(HXN_WRITE, HXN_RESET, HXN_RESET_BOTH));
  if (type === "H") {
    await control.clear("out");
    return control.clear("in");
  }
  await control.write(vendor(REGISTERS, RESET_OUT, 0));
  await control.write(vendor(REGISTERS, RESET_IN, 0));
}

/** @param {Control} control @param {Type} type */
async function endFlowControl(control, type) {
  const isHxn = type === "HXN";
  const [flow] = await control.read(isHxn ? vendor(HXN_READ, HXN_FLOW, 0) : vendor(REGISTERS, FLOW | READ, 0), 1);
  await control.write(isHxn ? vendor(HXN_WRITE, HXN_FLOW, (flow & ~HXN_FLOW_BITS) | HXN_NO_FLOW) : vendor(REGISTERS, FLOW, flow & ~FLOW_BITS));
}

/** @type {import("./types").Chip} */
export const pl2303 = {
  name: "PL2303",
  // H, HX, HXD, TA and TB; GC, GB, GT, GL, GE, GS.
  filters: [0x2303, 0x23a3, 0x23b3, 0x23c3, 0x23d3, 0x23e3, 0x23f3].map((productId) => ({ vendorId: 0x067b, productId })),

  async start(control, baud) {
    const type = await typeOf(control);
    if (type !== "HXN") await wake(control, type);
    await clearBuffers(control, type);
    // One stop bit, no parity, 8 data bits.
    await control.write(line(SET_LINE, 0), Uint8Array.of(...u32(baud), 0, 0, 8));
    await endFlowControl(control, type);
    await this.setRts(control, false);
  },

  setRts: (control, isOn) => control.write(line(SET_MODEM, isOn ? DTR | RTS : DTR)),

  errors: (packet) => ERRORS.filter(([bit]) => packet.length > STATE_AT && packet[STATE_AT] & bit).map(([, name]) => name),
};
