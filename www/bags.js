// @ts-check
// Runs as MCAP bags with ROS 2 messages: simulated again in a worker, as runs are not stored. Loaded when one is saved.
import { download } from "./files.js";
import { complain, hideToast, textOf, toast } from "./messages.js";
import { hire } from "./workers.js";

/** @param {import("./worker-types").BagRequest} request @param {string} stem */
export async function saveBag(request, stem) {
  toast("Simulating the run again for the file", true);
  try {
    const name = `${stem}.mcap`;
    download(name, /** @type {BlobPart} */ (await write(request)), "application/x-mcap");
    toast(`Saved as ${name}`);
  } catch (error) {
    hideToast();
    complain(error instanceof Error ? `The bag could not be written (${error.message}). Check the connection, then try again.` : textOf(error));
  }
}

/** @param {import("./worker-types").BagRequest} request @returns {Promise<Uint8Array>} */
async function write(request) {
  const worker = await hire();
  try {
    return await new Promise((resolve, reject) => {
      worker.addEventListener("message", (/** @type {MessageEvent<import("./worker-types").FromBag>} */ { data }) => {
        if (data.type === "bagged") resolve(data.bytes);
        else reject(data.message);
      });
      worker.addEventListener("error", (event) => reject(new Error(event.message || "its worker could not be loaded")));
      worker.postMessage({ type: "bag", request: { id: 0, ...request } });
    });
  } finally {
    worker.terminate();
  }
}
