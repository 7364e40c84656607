// @ts-check
// Serial adapters that the user has granted, and how page and worker mean the same one.
import { support } from "./support.js";

/** @typedef {import("./types").Failure} Failure */

/** The USB ids of a port's adapter; "" for other ports. @param {SerialPort} port */
export function portId(port) {
  const { usbVendorId, usbProductId, bluetoothServiceClassId } = port.getInfo();
  if (bluetoothServiceClassId !== undefined) return `bluetooth ${bluetoothServiceClassId}`;
  return usbId(usbVendorId, usbProductId);
}

/** @param {(number | undefined)[]} ids of vendor and product */
export const usbId = (...ids) => ids.flatMap((id) => (id === undefined ? [] : id.toString(16).padStart(4, "0"))).join(":");

/** Makers of the chips that adapters are built with, by USB vendor. @type {Record<string, string>} */
const MAKERS = { "0403": "FTDI", "067b": "Prolific", "10c4": "CP210x", "1a86": "CH340", "2341": "Arduino", "2e8a": "Raspberry Pi", "303a": "Espressif" };

// The USB vendor iRobot. A Roomba 980's micro USB socket is a CDC device 27a6:0002, "iRobot Roomba", as three owners list it:
// github.com/Sunwood-ai-labs/OASIS (issue 61), github.com/skikozou/Termux-serial-tty, github.com/duck-5/CrazyRoomba (a 960).
const IROBOT = "27a6:";

/** Whether it is the USB port of a robot itself, which has neither a baud rate nor a BRC wire. @param {string} id */
export const isOwnUsb = (id) => id.startsWith(IROBOT);

/** The port's name on the page. @param {string} id */
export function portName(id) {
  if (id === "") return "Serial port";
  if (isOwnUsb(id)) return `Roomba's own USB port (${id})`;
  if (id.startsWith("bluetooth")) return "Bluetooth serial port";
  const maker = MAKERS[id.slice(0, 4)];
  return maker ? `${maker} adapter (${id})` : `USB adapter (${id})`;
}

/**
 * Where the worker finds a port, which the user chooses unless it is given. `null` if the user chose none; throws a
 * `Failure`.
 *
 * A `SerialPort` or `USBDevice` can't be sent to a worker, which gets the same ones by its own `getPorts()` or
 * `getDevices()`. Browsers list the granted ones in one order everywhere (Chromium's device service keeps them sorted by a
 * token that lives as long as the device), so the place in that list says which one is meant, even among adapters of the same
 * make. The ids of all go along: if the worker's list differs, something was plugged in or out meanwhile.
 * @param {import("./types").PortAccess<any>} access
 * @param {unknown} [port]
 * @returns {Promise<{ kind: "serial" | "usb", address: import("./types").PortAddress } | null>}
 */
export async function choosePort(access, port) {
  const { why, instead, ...can } = support();
  if (!can[access.kind]) throw failure(window.isSecureContext ? (access.kind in navigator ? "policy" : "unsupported") : "insecure", why, instead);
  try {
    const chosen = port ?? (await access.ask());
    const ports = await access.list();
    const index = ports.indexOf(chosen);
    if (index >= 0) return { kind: access.kind, address: { ids: ports.map(access.id), index } };
  } catch (error) {
    const { name, message } = /** @type {Error} */ (error);
    // Dismissed: the user knows.
    if (name === "NotFoundError") return null;
    // Chromium speaks of a gesture, Firefox of activation.
    if (/gesture|activation/.test(message)) throw failure("denied", "The browser shows its list of adapters only after a click.", "Press Connect.");
    if (name === "SecurityError") throw failure("policy", "This site isn't allowed to use serial adapters.", "Allow them in the browser's settings for this site, if they were blocked there.");
    throw failure("failed", `The browser couldn't list the adapters (${message}).`, "");
  }
  throw failure("absent", "That adapter is no longer plugged in.", "Plug it in and choose it again.");
}

/**
 * The worker's port with that address. Throws a `Failure`.
 * @template P
 * @param {import("./types").PortAccess<P>} access
 * @param {import("./types").PortAddress} address
 */
export async function findPort(access, { ids, index }) {
  // In a browser that has none in workers, there is nothing to be found.
  if (!(access.kind in navigator)) throw failure("unsupported", "This browser offers serial adapters to pages, but not to web workers.", "Use a recent Chrome, Edge, Opera or Firefox on a computer.");
  for (let tries = 0; tries < 5; tries++) {
    const ports = await access.list();
    if (ports.map(access.id).join() === ids.join()) return ports[index];
    const alike = ports.filter((port) => access.id(port) === ids[index]);
    if (alike.length === 1) return alike[0];
    await new Promise((later) => setTimeout(later, 100));
  }
  throw failure("absent", "That adapter is no longer plugged in.", "Plug it in and choose it again.");
}

/** @param {Failure["kind"]} kind @param {string} what @param {string} remedy @returns {Failure} */
export function failure(kind, what, remedy) {
  return { kind, what, remedy };
}
