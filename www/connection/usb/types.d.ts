// As much of WebUSB (https://wicg.github.io/webusb/) as the drivers use, and what a driver of a chip is.
import type { LineError } from "../types";

export type UsbSetup = { requestType: "standard" | "class" | "vendor"; recipient: "device" | "interface"; request: number; value: number; index: number };
export type UsbStatus = "ok" | "stall" | "babble";
export type UsbEndpoint = { endpointNumber: number; direction: "in" | "out"; type: "bulk" | "interrupt" | "isochronous"; packetSize: number };
export type UsbInterface = { interfaceNumber: number; alternate: { interfaceClass: number; endpoints: UsbEndpoint[] } };

export interface UsbDevice {
  readonly vendorId: number;
  readonly productId: number;
  readonly serialNumber?: string | null;
  /** `bcdDevice` is major << 8 | minor << 4 | subminor; so is `bcdUSB`. */
  readonly deviceVersionMajor: number;
  readonly deviceVersionMinor: number;
  readonly deviceVersionSubminor: number;
  readonly usbVersionMajor: number;
  readonly usbVersionMinor: number;
  readonly deviceClass: number;
  readonly configuration: { interfaces: UsbInterface[] } | null;
  open(): Promise<void>;
  close(): Promise<void>;
  selectConfiguration(value: number): Promise<void>;
  claimInterface(number: number): Promise<void>;
  controlTransferIn(setup: UsbSetup, length: number): Promise<{ status: UsbStatus; data?: DataView }>;
  controlTransferOut(setup: UsbSetup, data?: Uint8Array): Promise<{ status: UsbStatus }>;
  transferIn(endpoint: number, length: number): Promise<{ status: UsbStatus; data?: DataView }>;
  transferOut(endpoint: number, data: Uint8Array): Promise<{ status: UsbStatus }>;
  clearHalt(direction: "in" | "out", endpoint: number): Promise<void>;
}

export type UsbFilter = { vendorId: number; productId: number };

export interface Usb extends EventTarget {
  getDevices(): Promise<UsbDevice[]>;
  requestDevice(options: { filters: UsbFilter[] }): Promise<UsbDevice>;
}

declare global {
  interface Navigator {
    readonly usb: Usb;
  }
}

/** The control transfers of a claimed adapter. */
export interface Control {
  readonly device: UsbDevice;
  /** Throws `Refused` if the chip doesn't accept it. */
  write(setup: UsbSetup, data?: Uint8Array): Promise<void>;
  read(setup: UsbSetup, length: number): Promise<Uint8Array>;
  /** Makes an endpoint forget what it was in the middle of. */
  clear(direction: "in" | "out"): Promise<void>;
}

/** The driver of a family of chips. All are set to 8 data bits, no parity, one stop bit, no flow control. */
export interface Chip {
  readonly name: string;
  readonly filters: UsbFilter[];
  /** Makes it ready, with RTS off and DTR on; throws `Refused` or a `Failure`. */
  start(control: Control, baud: number): Promise<void>;
  /** Switches RTS; DTR stays on. On means that the pin of a TTL adapter is low. */
  setRts(control: Control, isOn: boolean): Promise<void>;
  /** The line's bytes in what a transfer brought, without what the chip adds. */
  unpack?(data: Uint8Array, packetSize: number, onerror: (error: LineError) => void): Uint8Array;
  /** Errors in a packet of the interrupt endpoint. */
  errors?(packet: Uint8Array): LineError[];
  /** Before it is closed. */
  stop?(control: Control): Promise<void>;
}
