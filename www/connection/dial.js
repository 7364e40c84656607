// @ts-check
// Opens a WebSocket to a bridge, and takes its first messages, by which it can be told what speaks there.
import { closure, isHello } from "./bridge-words.js";
import { unreachable } from "./local-network.js";
import { failure } from "./ports.js";
import { within } from "./within.js";

/** Time limit for a bridge to answer, ms. */
const OPEN_MS = 8000;

/** How long a bridge's first messages are waited for: only ours sends them at once, or closes the connection, ms. */
export const HELLO_MS = 300;

/**
 * Throws a `Failure`. Messages that come later are kept until `onmessage` is set in the same task.
 * @param {URL} address
 * @returns {Promise<{ socket: WebSocket, early: unknown[] }>}
 */
export async function dial(address) {
  const socket = new WebSocket(address);
  socket.binaryType = "arraybuffer";
  /** @type {unknown[]} */
  const early = [];
  /** @type {CloseEvent | undefined} */
  let closed;
  try {
    await within(OPEN_MS, new Promise((resolve, reject) => ((socket.onopen = resolve), (socket.onerror = socket.onclose = reject))));
    const first = new Promise((resolve) => {
      socket.onmessage = ({ data }) => {
        early.push(data);
        // Ours says next who drives.
        if (early.length > 1 || !isHello(data)) resolve(early);
      };
      socket.onclose = (event) => resolve((closed = event));
    });
    await within(HELLO_MS, first).catch(() => {});
  } catch {
    socket.close();
    throw await unreachable(address);
  }
  if (closed) {
    const { why, isForGood } = closure(closed);
    throw failure(isForGood ? "denied" : "unreachable", why, "");
  }
  return { socket, early };
}
