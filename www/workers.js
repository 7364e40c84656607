// @ts-check
// All that needs the workshop, the module with the planners and the readers of map files. It is loaded with this one,
// when it is first needed: the page opens without.
import { compile } from "./wasm.js";

/** @type {Promise<WebAssembly.Module> | undefined} */
let compiled;

/** The module, compiled once for all workers. What could not be fetched is tried again the next time. */
export function workshop() {
  compiled ??= compile(new URL("../workshop_bg.wasm", import.meta.url)).catch((error) => {
    compiled = undefined;
    throw error;
  });
  return compiled;
}

/** A worker, ready for work; to be ended by the caller. */
export async function hire() {
  const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
  /** @type {Promise<never>} */
  const broken = new Promise((_, reject) => {
    worker.addEventListener("error", (event) => reject(new Error(event.message || "a worker could not be started")), { once: true });
  });
  try {
    worker.postMessage({ type: "init", module: await Promise.race([workshop(), broken]) });
    return worker;
  } catch (error) {
    worker.terminate();
    throw error;
  }
}

/**
 * Reads a map from files that belong together, in a worker of its own: a large one takes its time. Their bytes are handed
 * over. Throws messages for users.
 * @param {{ name: string, bytes: Uint8Array }[]} files
 * @returns {Promise<Uint8Array>}
 */
export const readMap = (files) => mapFrom({ type: "read", request: { id: 0, files } }, files.map(({ bytes }) => bytes.buffer));

/** Makes the furnished flat with that name, such as 7, or 7~area:40..60. Throws messages for users. @param {string} flat */
export const makeFlat = (flat) => mapFrom({ type: "flat", request: { id: 0, flat } });

/** @param {import("./worker-types").ToWorker} message @param {ArrayBufferLike[]} [transfer] @returns {Promise<Uint8Array>} */
async function mapFrom(message, transfer = []) {
  const worker = await hire();
  try {
    return await new Promise((resolve, reject) => {
      worker.addEventListener("message", (/** @type {MessageEvent<import("./worker-types").FromReader>} */ { data }) => {
        if (data.type === "read") resolve(data.map);
        else reject(data.message);
      });
      worker.addEventListener("error", (event) => reject(new Error(event.message || "its reader could not be loaded")));
      worker.postMessage(message, /** @type {Transferable[]} */ (transfer));
    });
  } finally {
    worker.terminate();
  }
}
