// @ts-check
// Sends a last stop over a line whose worker no longer answers: opens it once more, writes, closes.
import { accessBy } from "./access.js";
import { bridgeAddress, isHello } from "./bridge-words.js";
import { HELLO_MS } from "./dial.js";
import { findPort } from "./ports.js";

/** How long it is tried, ms. A worker that hangs lets go of its port only when the browser ends it, which takes two seconds. */
const PATIENCE_MS = 6000;
const AGAIN_MS = 10;
/** How long the bridge's confirmation of a stop is waited for, ms. */
const CONFIRM_MS = 500;

/**
 * Says whether the bytes were sent.
 * @param {import("./types").LineTarget} target @param {number} baud @param {Uint8Array} bytes
 */
export async function rescue(target, baud, bytes) {
  const end = performance.now() + PATIENCE_MS;
  while (performance.now() < end) {
    try {
      await (target.kind === "socket" ? overSocket(target.url, bytes) : overSerial(accessBy(target.kind), target.address, baud, bytes));
      return true;
    } catch {
      await new Promise((later) => setTimeout(later, AGAIN_MS));
    }
  }
  return false;
}

/** @param {import("./types").PortAccess<any>} access @param {import("./types").PortAddress} address @param {number} baud @param {Uint8Array} bytes */
async function overSerial(access, address, baud, bytes) {
  const port = access.open(await findPort(access, address), { onbytes: () => {}, onerror: () => {}, onlost: () => {} });
  await port.open(baud);
  port.write(bytes);
  await port.close();
}

/**
 * Ours drops the bytes, since this connection doesn't drive, but everyone may tell it to stop. Others pass the bytes on.
 * @param {string} url @param {Uint8Array} bytes
 */
function overSocket(url, bytes) {
  return new Promise((resolve, reject) => {
    const socket = new WebSocket(bridgeAddress(url) ?? url);
    let [isOurs, isStopped] = [false, false];
    socket.onopen = () => {
      socket.send(Uint8Array.from(bytes));
      setTimeout(() => isOurs || socket.close(), HELLO_MS);
    };
    socket.onmessage = ({ data }) => {
      if (isHello(data)) {
        isOurs = true;
        socket.send("stop");
        setTimeout(() => socket.close(), CONFIRM_MS);
      } else if (isOurs && data === "halted stopped") {
        isStopped = true;
        socket.close();
      }
    };
    socket.onclose = ({ wasClean }) => (isOurs ? isStopped : wasClean) ? resolve(undefined) : reject(new Error("closed"));
  });
}
