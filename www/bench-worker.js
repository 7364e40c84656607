// @ts-check
// Measures away from the page, which shows the results as they come.
import init, { bench } from "../workshop.js";

/** @param {import("./worker-types").FromBench} message */
const answer = (message) => self.postMessage(message);

self.addEventListener("message", async (/** @type {MessageEvent<{ module: WebAssembly.Module, once: boolean }>} */ event) => {
  try {
    await init({ module_or_path: event.data.module });
    const results = bench(event.data.once, (/** @type {import("./types").BenchResult} */ result) => answer({ type: "result", result }));
    answer({ type: "finished", results });
  } catch (error) {
    answer({ type: "failed", message: error instanceof Error ? error.message : String(error) });
  }
});
