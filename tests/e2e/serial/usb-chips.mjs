// The chips of USB adapters as a computer sees them: descriptors as `lsusb -v` lists them, and requests decoded the way the
// chips do it, apart from the drivers that are tested with it. Facts: Linux, drivers/usb/serial/{ftdi_sio,cp210x,ch341,pl2303}.c;
// FTDI AN232B-05; Silicon Labs AN571. Everything that a chip doesn't know stalls.

import { Chip, OK, STALL, answer } from "./usb-chip.mjs";

/** FT232R: lsusb of an FT232RL. */
export class Ftdi extends Chip {
  descriptor = {
    ...{ bcdUSB: 0x200, deviceClass: 0, maxPacketSize0: 8, idVendor: 0x0403, idProduct: 0x6001, bcdDevice: 0x600, serialNumber: "A600eHYG" },
    ...{ interface: [255, 255, 255], endpoints: [[0x81, "bulk", 64], [0x02, "bulk", 64]] },
  };
  latency = 16;
  lineStatus = 0;

  request(type, request, value, index) {
    if (type !== 0x40) return STALL;
    if (request === 0) this.isOn = true;
    else if (request === 1) {
      if (value & 0x100) this.dtr = (value & 1) !== 0;
      if (value & 0x200) this.rts = (value & 2) !== 0;
    } else if (request === 2) this.hasFlowControl = index >> 8 !== 0;
    else if (request === 3) {
      // AN232B-05: bits 15, 14 of the value and 0 of the index are a code for the eighths.
      const eighths = [0, 4, 2, 1, 3, 5, 6, 7][((index & 1) << 2) | (value >> 14)];
      this.baud = 3_000_000 / ((value & 0x3fff) + eighths / 8);
    } else if (request === 4) this.is8n1 = value === 8;
    else if (request === 9) this.latency = value;
    else return STALL;
    return OK;
  }

  pack(queue, length) {
    const packets = [];
    do {
      const payload = queue.splice(0, 62);
      // Modem lines, then errors with "transmitter empty" (bits 5 and 6).
      packets.push(0x01, 0x60 | this.lineStatus, ...payload);
      if (payload.length > 0) this.lineStatus = 0;
      if (payload.length < 62) break;
    } while (packets.length + 64 <= length);
    return packets;
  }

  report(error) {
    this.lineStatus |= { overrun: 2, parity: 4, framing: 8, break: 16 }[error];
  }
}

/** CP2102. `isEarly`: one that only knows divisors. */
export class Cp210x extends Chip {
  descriptor = {
    ...{ bcdUSB: 0x110, deviceClass: 0, maxPacketSize0: 64, idVendor: 0x10c4, idProduct: 0xea60, bcdDevice: 0x100, serialNumber: "0001" },
    ...{ interface: [255, 0, 0], endpoints: [[0x81, "bulk", 64], [0x01, "bulk", 64]] },
  };
  isOn = false;
  isEarly = false;

  request(type, request, value, index, data) {
    if (type !== 0x41 || index !== 0) return STALL;
    if (request === 0x00) this.isOn = value === 1;
    else if (request === 0x01) this.baud = 3_686_400 / value;
    else if (request === 0x03) this.is8n1 = value === 0x0800;
    else if (request === 0x07) {
      if (value & 0x100) this.dtr = (value & 1) !== 0;
      if (value & 0x200) this.rts = (value & 2) !== 0;
    } else if (request === 0x12) return OK;
    else if (request === 0x13) {
      if (data?.length !== 16) return STALL;
      // AN571: handshake by CTS, DSR, DCD (bits 3, 4, 5), DSR sensitivity (6); XON and XOFF (bits 1, 0), RTS (7, 6).
      this.hasFlowControl = (data[0] & 0x78) !== 0 || (data[4] & 0x83) !== 0;
      this.dtr = (data[0] & 3) === 1;
      this.rts = (data[4] & 0xc0) === 0x40;
    } else if (request === 0x1e && !this.isEarly) this.baud = data[0] + (data[1] << 8) + (data[2] << 16) + (data[3] << 24);
    else return STALL;
    return OK;
  }
}

/** CH340G. Versions before 0x30 have no register for line control that could be written. */
export class Ch340 extends Chip {
  descriptor = {
    ...{ bcdUSB: 0x110, deviceClass: 255, maxPacketSize0: 8, idVendor: 0x1a86, idProduct: 0x7523, bcdDevice: 0x264, serialNumber: null },
    ...{ interface: [255, 1, 2], endpoints: [[0x82, "bulk", 32], [0x02, "bulk", 32], [0x81, "interrupt", 8]] },
  };
  version = 0x31;
  /** Can't send breaks. */
  isLimited = false;
  hasFlowControl = false;
  isOn = false;
  sendsAtOnce = false;

  request(type, request, value, index) {
    if (type === 0xc0) {
      if (request === 0x5f) return answer(this.version, 0);
      return request === 0x95 && value === 0x05 && !this.isLimited ? answer(1, 0) : STALL;
    }
    if (type !== 0x40) return STALL;
    if (request === 0xa1) {
      this.isOn = true;
      this.is8n1 = this.version < 0x30;
    } else if (request === 0xa4) {
      this.rts = (value & 0x40) === 0;
      this.dtr = (value & 0x20) === 0;
    } else if (request === 0x9a && value === 0x1312) {
      const [prescaler, fact] = [index & 3, (index >> 2) & 1];
      if (fact && this.isLimited && prescaler < 3) return STALL;
      this.sendsAtOnce = ((index & 0x80) !== 0) === this.version > 0x27;
      this.baud = 48_000_000 / (2 ** (12 - 3 * prescaler - fact) * (256 - (index >> 8)));
    } else if (request === 0x9a && value === 0x2518 && this.version >= 0x30) this.is8n1 = index === 0xc3;
    else return STALL;
    return OK;
  }

  pack(queue, length) {
    return this.sendsAtOnce || queue.length >= 32 ? queue.splice(0, length) : [];
  }
}

/** PL2303HX; with `isHxn`, a PL2303GT. */
export class Pl2303 extends Chip {
  descriptor = {
    ...{ bcdUSB: 0x110, deviceClass: 0, maxPacketSize0: 64, idVendor: 0x067b, idProduct: 0x2303, bcdDevice: 0x300, serialNumber: null },
    ...{ interface: [255, 0, 0], endpoints: [[0x81, "interrupt", 10], [0x02, "bulk", 64], [0x83, "bulk", 64]] },
  };
  isHxn = false;
  /** What was last written to register 2 when the chip was made ready. */
  ready = 0;
  /** Flow control in bits 7 to 4, or 4 to 2. */
  flow = 0x61;

  request(type, request, value, index, data) {
    const hx = !this.isHxn;
    if (type === 0x21 && request === 0x20) {
      if (data?.length !== 7) return STALL;
      this.baud = data[0] + (data[1] << 8) + (data[2] << 16) + (data[3] << 24);
      this.is8n1 = data[4] === 0 && data[5] === 0 && data[6] === 8;
    } else if (type === 0x21 && request === 0x22) {
      this.dtr = (value & 1) !== 0;
      this.rts = (value & 2) !== 0;
    } else if (type === 0xc0 && request === 0x01 && hx) return answer(value === 0x80 ? this.flow : 0);
    else if (type === 0xc0 && request === 0x81 && !hx && value === 0x0a) return answer(this.flow);
    else if (type === 0x40 && request === 0x01 && hx) {
      if (value === 0) [this.flow, this.hasFlowControl] = [index, (index & 0xf0) !== 0];
      if (value === 2) this.ready = index;
    } else if (type === 0x40 && request === 0x80 && !hx) {
      if (value === 0x0a) [this.flow, this.hasFlowControl] = [index, (index & 0x1c) !== 0x1c];
      else if (value !== 0x07) return STALL;
    } else return STALL;
    return OK;
  }

  get isReady() {
    return super.isReady && (this.isHxn || this.ready === (this.descriptor.maxPacketSize0 === 64 ? 0x44 : 0x24));
  }

  /** A packet of the interrupt endpoint. */
  report(error) {
    return [0xa1, 0x20, 0, 0, 0, 0, 2, 0, { break: 4, framing: 0x10, parity: 0x20, overrun: 0x40 }[error], 0];
  }
}

export const CHIPS = { FTDI: Ftdi, CP210x: Cp210x, CH340: Ch340, PL2303: Pl2303 };

/** A chip with other numbers in its descriptor, or other properties. */
export function make(Kind, descriptor = {}, properties = {}) {
  const chip = Object.assign(new Kind(), properties);
  Object.assign(chip.descriptor, descriptor);
  return chip;
}
