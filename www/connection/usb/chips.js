// @ts-check
// The chips that there are drivers for.
import { ch340 } from "./ch340.js";
import { cp210x } from "./cp210x.js";
import { ftdi } from "./ftdi.js";
import { pl2303 } from "./pl2303.js";

const CHIPS = [ftdi, cp210x, ch340, pl2303];

/** What the browser's list of devices is to show. */
export const FILTERS = CHIPS.flatMap(({ filters }) => filters);

/** The driver of a device. @param {import("./types").UsbDevice} device */
export const chipOf = (device) => CHIPS.find(({ filters }) => filters.some(({ vendorId, productId }) => device.vendorId === vendorId && device.productId === productId));
