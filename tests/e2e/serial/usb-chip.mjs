// What the emulated chips of USB adapters have in common.

export const STALL = { status: "stall" };
export const OK = { status: "ok" };
export const answer = (...bytes) => ({ status: "ok", data: bytes });

/** What is common: a UART that transmits only when all of it is set. */
export class Chip {
  baud = 0;
  rts = null;
  dtr = null;
  is8n1 = false;
  hasFlowControl = true;
  isOn = true;
  /** Control transfers that were accepted, as [request type, request, value, index, data]. */
  log = [];

  get isReady() {
    return this.isOn && this.baud > 0 && this.is8n1 && !this.hasFlowControl;
  }

  /** As WebUSB shows it. */
  get info() {
    const { bcdUSB, bcdDevice, idVendor, idProduct, deviceClass, serialNumber, interface: kind, endpoints } = this.descriptor;
    const version = (name, bcd) => ({ [`${name}VersionMajor`]: bcd >> 8, [`${name}VersionMinor`]: (bcd >> 4) & 15, [`${name}VersionSubminor`]: bcd & 15 });
    const ends = endpoints.map(([address, type, packetSize]) => ({ endpointNumber: address & 15, direction: address & 128 ? "in" : "out", type, packetSize }));
    const [interfaceClass, interfaceSubclass, interfaceProtocol] = kind;
    return {
      ...{ vendorId: idVendor, productId: idProduct, deviceClass, serialNumber, ...version("usb", bcdUSB), ...version("device", bcdDevice) },
      interfaces: [{ interfaceNumber: 0, alternate: { interfaceClass, interfaceSubclass, interfaceProtocol, endpoints: ends } }],
    };
  }

  control(type, request, value, index, data) {
    const { descriptor: d } = this;
    const [u16, none] = [(n) => [n & 255, n >> 8], 0];
    if (type === 0x80 && request === 6 && value === 0x100) {
      return answer(18, 1, ...u16(d.bcdUSB), d.deviceClass, none, none, d.maxPacketSize0, ...u16(d.idVendor), ...u16(d.idProduct), ...u16(d.bcdDevice), 1, 2, d.serialNumber ? 3 : 0, 1);
    }
    const result = this.request(type, request, value, index, data);
    if (result.status === "ok") this.log.push([type, request, value, index, ...(data?.length ? [[...data]] : [])]);
    return result;
  }

  /** Up to `length` bytes for the computer as a transfer brings them; takes them from `queue`. */
  pack(queue, length) {
    return queue.splice(0, length);
  }
}
