// @ts-check
// The two ways in which browsers let a page use serial adapters. Lines and choosers are the same for both.
import { usbId, portId } from "./ports.js";
import { OpenPort } from "./serial-port.js";
import { FILTERS, chipOf } from "./usb/chips.js";
import { UsbPort } from "./usb/usb-port.js";

/** @typedef {import("./usb/types").UsbDevice} UsbDevice */

/** The system's serial ports. @type {import("./types").PortAccess<SerialPort>} */
const webSerial = {
  kind: "serial",
  source: () => navigator.serial,
  list: () => navigator.serial.getPorts(),
  ask: () => navigator.serial.requestPort(),
  id: portId,
  open: (port, events) => new OpenPort(port, events),
};

/** Adapters that the page drives itself, for systems without serial ports of their own. @type {import("./types").PortAccess<UsbDevice>} */
const webUsb = {
  kind: "usb",
  source: () => navigator.usb,
  list: async () => (await navigator.usb.getDevices()).filter(chipOf),
  ask: () => navigator.usb.requestDevice({ filters: FILTERS }),
  id: ({ vendorId, productId }) => usbId(vendorId, productId),
  open: (device, events) => new UsbPort(device, events),
};

/** @param {"serial" | "usb"} kind @returns {import("./types").PortAccess<any>} */
export const accessBy = (kind) => (kind === "usb" ? webUsb : webSerial);
