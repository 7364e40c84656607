// @ts-check
// Control transfers to an adapter's chip.

/** @typedef {import("./types").Control} Control */
/** @typedef {import("./types").UsbDevice} UsbDevice */
/** @typedef {import("./types").UsbSetup} UsbSetup */

/** The chip didn't accept a request ("stall"): it is none that this driver knows. */
export class Refused extends Error {
  /** @param {UsbSetup} setup */
  constructor({ request, value, index }) {
    super(`request 0x${request.toString(16)}, value 0x${value.toString(16)}, index ${index}`);
  }
}

/** @implements {Control} */
export class DeviceControl {
  #endpoints;

  /** @param {UsbDevice} device @param {{ in: number, out: number }} endpoints */
  constructor(device, endpoints) {
    this.device = device;
    this.#endpoints = endpoints;
  }

  /** @param {UsbSetup} setup @param {Uint8Array} [data] */
  async write(setup, data) {
    const { status } = await this.device.controlTransferOut(setup, data);
    if (status !== "ok") throw new Refused(setup);
  }

  /** @param {UsbSetup} setup @param {number} length */
  async read(setup, length) {
    const { status, data } = await this.device.controlTransferIn(setup, length);
    if (status !== "ok" || data?.byteLength !== length) throw new Refused(setup);
    return bytesOf(data);
  }

  /** @param {"in" | "out"} direction */
  clear(direction) {
    return this.device.clearHalt(direction, this.#endpoints[direction]);
  }
}

/** @param {DataView} view */
export const bytesOf = (view) => new Uint8Array(view.buffer, view.byteOffset, view.byteLength);

/** A device's release number, `bcdDevice`. @param {UsbDevice} device */
export const release = (device) => (device.deviceVersionMajor << 8) | (device.deviceVersionMinor << 4) | device.deviceVersionSubminor;

/** Little-endian, as USB has all numbers. @param {number} value */
export const u32 = (value) => Uint8Array.of(value, value >> 8, value >> 16, value >> 24);
