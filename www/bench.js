// @ts-check
// The cases of `robovac bench`, measured in this browser; scripts/bench.mjs compares the two.
import { logged, measurePrograms } from "./bench-programs.js";
import { measureRuns } from "./bench-runs.js";
import { byId, make } from "./dom.js";
import { pace } from "./format.js";
import { compile, missing } from "./wasm.js";

/**
 * @typedef {import("./types").BenchResult} BenchResult
 * @typedef {import("./worker-types").FromBench} FromBench
 */

/** With bench.html?once, each case runs a single time: enough to see that it works. */
const ONCE = new URLSearchParams(location.search).has("once");

/** Milliseconds between two looks at whether the page still answers. */
const LOOK_EVERY = 5;

/**
 * Runs all cases of a module in a worker.
 * @param {URL} script @param {WebAssembly.Module} module
 * @param {(result: BenchResult) => void} show Receives each result.
 * @returns {Promise<BenchResult[]>}
 */
async function inWorker(script, module, show) {
  const worker = new Worker(script, { type: "module" });
  try {
    return await new Promise((resolve, reject) => {
      worker.addEventListener("message", (/** @type {MessageEvent<FromBench>} */ { data }) => {
        if (data.type === "result") show(data.result);
        else if (data.type === "finished") resolve(data.results);
        else reject(new Error(data.message));
      });
      worker.addEventListener("error", (event) => reject(new Error(event.message || "the worker could not be loaded")));
      worker.postMessage({ module, once: ONCE });
    });
  } finally {
    worker.terminate();
  }
}

/** The longest that the page didn't answer while something was done. @param {() => Promise<unknown>} what */
async function longestPause(what) {
  let [last, longest] = [performance.now(), 0];
  const look = () => {
    const now = performance.now();
    [last, longest] = [now, Math.max(longest, now - last)];
  };
  const looking = setInterval(look, LOOK_EVERY);
  await what();
  clearInterval(looking);
  look();
  return longest;
}

/**
 * Runs the benchmark, one worker after the other.
 * @param {(result: BenchResult) => void} show Receives each result.
 * @returns {Promise<BenchResult[]>}
 */
async function measure(show) {
  const lack = missing();
  if (lack) throw new Error(`this browser lacks ${lack}`);
  /** @type {BenchResult[]} */
  const results = [];
  /** @param {BenchResult} result */
  const take = (result) => {
    results.push(result);
    show(result);
  };
  const module = await compile(new URL("../floor_plan_bg.wasm", import.meta.url));
  const ms = await longestPause(() => inWorker(new URL("./bench-floor-plan-worker.js", import.meta.url), module, take));
  take({ name: "longest pause of the page meanwhile", ms, times_real_time: null, memory_mb: null });
  const workshop = await compile(new URL("../workshop_bg.wasm", import.meta.url));
  await inWorker(new URL("./bench-worker.js", import.meta.url), workshop, take);
  // By itself: it takes all cores.
  take(await measureRuns(workshop));
  await measurePrograms(ONCE ? 3 : 30, ONCE ? 1 : 5, take);
  take(await measureRuns(workshop, " of a program in Python", await logged("python")));
  take(await measureRuns(workshop, " of a program in JavaScript", await logged("javascript")));
  return results;
}

/** @param {BenchResult} result */
function addRow({ name, ms, times_real_time: times, memory_mb: memory }) {
  const cells = [ms.toFixed(2), times === null ? "" : pace(times), memory === null ? "" : memory.toFixed(0)].map((text) => make("td", {}, text));
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
