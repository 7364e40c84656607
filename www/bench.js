// @ts-check
// What `robovac bench` measures natively, measured in this browser; scripts/bench.mjs compares the two.
import { measureRuns } from "./bench-runs.js";
import { byId, make } from "./dom.js";
import { pace } from "./format.js";
import { compile, missing } from "./wasm.js";

/**
 * @typedef {import("./types").BenchResult} BenchResult
 * @typedef {import("./types").FromBench} FromBench
 */

/**
 * Runs the benchmark in a worker.
 * @param {(result: BenchResult) => void} show Is told each result as it comes.
 * @returns {Promise<BenchResult[]>}
 */
async function measure(show) {
  const lack = missing();
  if (lack) throw new Error(`this browser lacks ${lack}`);
  const module = await compile(new URL("../workshop_bg.wasm", import.meta.url));
  const worker = new Worker(new URL("./bench-worker.js", import.meta.url), { type: "module" });
  try {
    const results = await new Promise((/** @type {(results: BenchResult[]) => void} */ resolve, reject) => {
      worker.addEventListener("message", (/** @type {MessageEvent<FromBench>} */ { data }) => {
        if (data.type === "result") show(data.result);
        else if (data.type === "finished") resolve(data.results);
        else reject(new Error(data.message));
      });
      worker.addEventListener("error", (event) => reject(new Error(event.message || "the worker could not be loaded")));
      worker.postMessage({ module });
    });
    // By itself: it takes all cores.
    const runs = await measureRuns(module);
    show(runs);
    return [...results, runs];
  } finally {
    worker.terminate();
  }
}

/** @param {BenchResult} result */
function addRow({ name, ms, times_real_time: times }) {
  const cells = [ms.toFixed(2), times === null ? "" : pace(times)].map((text) => make("td", {}, text));
  byId("results").append(make("tr", {}, make("th", { scope: "row" }, name), ...cells));
}

const results = measure(addRow);
// For programs that open this page: there at once, and settled when everything has been measured.
Object.assign(window, { benchResult: results });

const status = byId("status");
results.then(
  () => (status.textContent = "Done."),
  (error) => {
    console.error(error);
    status.textContent = `Stopped: ${error instanceof Error ? error.message : error}. Reload to try again.`;
  },
);
