// @ts-check
// Serial ports that the user has granted, and how page and worker mean the same one.
import { support } from "./support.js";

/** @typedef {import("./types").Failure} Failure */

/** The USB ids of a port's adapter; "" for other ports. @param {SerialPort} port */
export function portId(port) {
  const { usbVendorId, usbProductId, bluetoothServiceClassId } = port.getInfo();
  if (bluetoothServiceClassId !== undefined) return `bluetooth ${bluetoothServiceClassId}`;
  return [usbVendorId, usbProductId].flatMap((id) => (id === undefined ? [] : id.toString(16).padStart(4, "0"))).join(":");
}

/** Makers of the chips that adapters are built with, by USB vendor. @type {Record<string, string>} */
const MAKERS = { "0403": "FTDI", "067b": "Prolific", "10c4": "CP210x", "1a86": "CH340", "2341": "Arduino", "2e8a": "Raspberry Pi", "303a": "Espressif" };

/** The port's name on the page. @param {string} id */
export function portName(id) {
  if (id === "") return "Serial port";
  if (id.startsWith("bluetooth")) return "Bluetooth serial port";
  const maker = MAKERS[id.slice(0, 4)];
  return maker ? `${maker} adapter (${id})` : `USB adapter (${id})`;
}

/**
 * Where the worker finds a port, which the user chooses unless it is given. `null` if the user chose none; throws a
 * `Failure`.
 *
 * A `SerialPort` can't be sent to a worker, which gets the same ports by its own `getPorts()`. Browsers list the granted
 * ports in one order everywhere (Chromium's device service keeps them sorted by a token that lives as long as the device), so
 * the place in that list says which one is meant, even among adapters of the same make. The ids of all go along: if the
 * worker's list differs, something was plugged in or out meanwhile.
 * @param {SerialPort} [port]
 * @returns {Promise<{ kind: "serial", address: import("./types").PortAddress } | null>}
 */
export async function choosePort(port) {
  const { serial, why, instead } = support();
  if (!serial) throw failure(window.isSecureContext ? ("serial" in navigator ? "policy" : "unsupported") : "insecure", why, instead);
  try {
    const chosen = port ?? (await navigator.serial.requestPort());
    const ports = await navigator.serial.getPorts();
    const index = ports.indexOf(chosen);
    if (index >= 0) return { kind: "serial", address: { ids: ports.map(portId), index } };
  } catch (error) {
    const { name, message } = /** @type {Error} */ (error);
    // Dismissed: the user knows.
    if (name === "NotFoundError") return null;
    // Chromium speaks of a gesture, Firefox of activation.
    if (/gesture|activation/.test(message)) throw failure("denied", "The browser shows its list of ports only after a click.", "Press Connect.");
    if (name === "SecurityError") throw failure("policy", "This site isn't allowed to use serial ports.", "Allow them in the browser's settings for this site, if they were blocked there.");
    throw failure("failed", `The browser couldn't list its ports (${message}).`, "");
  }
  throw failure("absent", "That adapter is no longer plugged in.", "Plug it in and choose it again.");
}

/**
 * The worker's port with that address. Throws a `Failure`.
 * @param {import("./types").PortAddress} address
 */
export async function findPort({ ids, index }) {
  // In a browser that has no serial ports in workers, there is nothing to be found.
  if (!("serial" in navigator)) throw failure("unsupported", "This browser offers serial ports to pages, but not to web workers.", "Use a recent Chrome, Edge, Opera or Firefox on a computer.");
  for (let tries = 0; tries < 5; tries++) {
    const ports = await navigator.serial.getPorts();
    if (ports.map(portId).join() === ids.join()) return ports[index];
    const alike = ports.filter((port) => portId(port) === ids[index]);
    if (alike.length === 1) return alike[0];
    await new Promise((later) => setTimeout(later, 100));
  }
  throw failure("absent", "That adapter is no longer plugged in.", "Plug it in and choose it again.");
}

/** @param {Failure["kind"]} kind @param {string} what @param {string} remedy @returns {Failure} */
export function failure(kind, what, remedy) {
  return { kind, what, remedy };
}
