// @ts-check
// Plans away from the page, which stays responsive; to cancel, the page ends this worker.
import init, { plan } from "../robovac-playground.js";

/** @typedef {import("./types").FromWorker} FromWorker */

let markReady = () => {};
/** @type {Promise<void>} */
const ready = new Promise((resolve) => (markReady = resolve));

/** @param {FromWorker} message @param {ArrayBufferLike[]} [transfer] */
function answer(message, transfer = []) {
  self.postMessage(message, { transfer: /** @type {Transferable[]} */ (transfer) });
}

self.addEventListener("message", async (/** @type {MessageEvent<import("./types").ToWorker>} */ event) => {
  const message = event.data;
  if (message.type === "init") {
    await init({ module_or_path: message.module });
    markReady();
    return;
  }
  await ready;
  const { request } = message;
  try {
    const { cells, seconds } = plan(request, (/** @type {number} */ done, /** @type {Uint32Array} */ cells) =>
      answer({ type: "progress", id: request.id, done, cells }, [cells.buffer]),
    );
    answer({ type: "finished", id: request.id, cells, seconds }, [cells.buffer]);
  } catch (error) {
    answer({ type: "failed", id: request.id, message: error instanceof Error ? error.message : String(error) });
  }
});
