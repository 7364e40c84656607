// @ts-check
// One opening of a USB adapter over WebUSB: bytes both ways until it is closed or lost.
import { AdapterPort, CLOSE_MS, OPEN_MS } from "../adapter-port.js";
import { failure } from "../ports.js";
import { within } from "../within.js";
import { chipOf } from "./chips.js";
import { DeviceControl, Refused, bytesOf } from "./control.js";

/** @typedef {import("../types").OpenablePort} OpenablePort */
/** @typedef {import("./types").UsbDevice} UsbDevice */
/** @typedef {import("./types").UsbEndpoint} UsbEndpoint */

/**
 * Packets of a transfer, and transfers that are under way at a time. A chip has room for as little as 128 bytes, 11 ms at
 * 115200 baud: there is always a transfer waiting for them, even while this worker is busy.
 */
const PACKETS = 8;
const TRANSFERS = 4;

/** @implements {OpenablePort} */
export class UsbPort extends AdapterPort {
  #device;
  #chip;
  /** @type {DeviceControl | undefined} */
  #control;
  #out = 0;
  /** @param {UsbDevice} device @param {import("../types").PortEvents} events */
  constructor(device, events) {
    super(events);
    this.#device = device;
    this.#chip = /** @type {import("./types").Chip} */ (chipOf(device));
  }

  /** Opens it; throws a `Failure`. @param {number} baud */
  async open(baud) {
    try {
      await within(OPEN_MS, this.#open(baud));
    } catch (error) {
      this.isOver = true;
      await within(CLOSE_MS, this.#device.close()).catch(() => {});
      throw cantOpen(error, this.#chip.name);
    }
  }

  /** @param {number} baud */
  async #open(baud) {
    await this.#device.open();
    if (!this.#device.configuration) await this.#device.selectConfiguration(1);
    // Of chips with several ports, the first.
    const { interfaceNumber, alternate } = /** @type {NonNullable<UsbDevice["configuration"]>} */ (this.#device.configuration).interfaces[0];
    const find = (/** @type {string} */ type, /** @type {string} */ direction) => alternate.endpoints.find((end) => end.type === type && end.direction === direction);
    const [bulkIn, bulkOut, state] = [find("bulk", "in"), find("bulk", "out"), find("interrupt", "in")];
    if (!bulkIn || !bulkOut) throw failure("unsupported", "This adapter has no serial port.", "Choose another one.");
    await this.#device.claimInterface(interfaceNumber);
    const control = new DeviceControl(this.#device, { in: bulkIn.endpointNumber, out: bulkOut.endpointNumber });
    await this.#chip.start(control, baud);
    this.#control = control;
    this.#out = bulkOut.endpointNumber;
    this.hasSignals = true;
    void this.#read(bulkIn, PACKETS, TRANSFERS, (data) => this.#received(data, bulkIn.packetSize));
    const { errors } = this.#chip;
    if (errors && state) void this.#read(state, 1, 1, (packet) => errors(packet).forEach((error) => this.events.onerror(error)));
  }

  /** Pulls RTS, and with it BRC, low (`true`), or lets go of it; says whether the adapter can. @param {boolean} isLow */
  async setBrc(isLow) {
    if (!this.#control || this.isOver) return false;
    try {
      await within(CLOSE_MS, this.#chip.setRts(this.#control, isLow));
      return true;
    } catch {
      return false;
    }
  }

  /** @override @param {Uint8Array<ArrayBuffer>} bytes */
  send(bytes) {
    return this.#control && this.#transfer(bytes);
  }

  /** @param {Uint8Array<ArrayBuffer>} bytes */
  async #transfer(bytes) {
    const { status } = await this.#device.transferOut(this.#out, bytes);
    if (status !== "ok") this.lose("The adapter no longer accepts data.");
  }

  /** @override */
  async shut() {
    // What was transferred is in the chip, which took its time to send it; closing empties some chips.
    if (this.#control) await this.#chip.stop?.(this.#control).catch(() => {});
    await this.#device.close();
  }

  /** @override @param {unknown} error */
  said(error) {
    return /** @type {Error} */ (error).name === "NotFoundError" ? "The adapter was unplugged." : super.said(error);
  }

  /** Reads from an endpoint until the end. @param {UsbEndpoint} end @param {number} packets @param {number} transfers @param {(data: Uint8Array) => void} arrived */
  async #read({ endpointNumber, packetSize }, packets, transfers, arrived) {
    const ask = () => {
      const transfer = this.#device.transferIn(endpointNumber, packetSize * packets);
      // When one fails, so do those behind it.
      transfer.catch(() => {});
      return transfer;
    };
    const waiting = Array.from({ length: transfers }, ask);
    try {
      for (let next = waiting.shift(); next; next = waiting.shift()) {
        const { status, data } = await next;
        if (status === "stall") await this.#device.clearHalt("in", endpointNumber);
        if (data?.byteLength) arrived(bytesOf(data));
        waiting.push(ask());
      }
    } catch (error) {
      this.lose(this.said(error));
    }
  }

  /** @param {Uint8Array} data @param {number} packetSize */
  #received(data, packetSize) {
    const bytes = this.#chip.unpack ? this.#chip.unpack(data, packetSize, this.events.onerror) : data;
    if (bytes.length) this.arrived(bytes);
  }
}

/** @param {unknown} error @param {string} chip */
function cantOpen(error, chip) {
  if (error && typeof error === "object" && "kind" in error) return /** @type {import("../types").Failure} */ (error);
  const { name, message } = /** @type {Error} */ (error);
  if (error instanceof Refused) {
    return failure("unsupported", `The adapter's chip calls itself a ${chip}, but refuses its commands (${message}). It may be a copy, or of a version that this page doesn't know.`, "Use another cable.");
  }
  if (name === "SecurityError") return failure("denied", "The system didn't let the browser use that adapter.", "Unplug it, plug it in again, and allow it when you are asked.");
  if (name === "NetworkError" || name === "InvalidStateError") {
    return failure(
      "busy",
      "The adapter could not be opened: another app, another tab or the system's own driver probably uses it.",
      "Close other apps and tabs that may use it, then unplug it and plug it in again. On Android, update Chrome: from version 140, it takes adapters over from the system.",
    );
  }
  if (name === "NotFoundError") return failure("absent", "That adapter is no longer plugged in.", "Plug it in and choose it again.");
  return failure("failed", `The adapter could not be opened (${message}).`, "Unplug it, plug it in again, and connect.");
}
