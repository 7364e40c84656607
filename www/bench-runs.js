// @ts-check
// Many runs on all cores, as in Compare: a hundred times half an hour of the cleaning cycle in the furnished flat.

/** @typedef {import("./worker-types").FromRuns} FromRuns */

/** Or as many as the address says: bench.html?runs=4. */
const SEEDS = Number(new URLSearchParams(location.search).get("runs")) || 100;
const MINUTES = 30;

/** The request to each worker, without id and seeds. */
const REQUEST = {
  room: "flat",
  scenario: null,
  settings: "robot=roomba600&slip=typical&noise=typical",
  duration_s: 60 * MINUTES,
  plan_seed: 1,
  behaves: true,
  entrant: "cleaning_cycle",
  place: "bench",
};

/** @param {WebAssembly.Module} module @returns {Promise<import("./types").BenchResult>} */
export async function measureRuns(module) {
  const cores = navigator.hardwareConcurrency || 2;
  const began = performance.now();
  let next = 1;
  /** Gives one worker requests until all seeds are taken. @returns {Promise<void>} */
  const work = () =>
    new Promise((resolve, reject) => {
      const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
      const ask = () => {
        if (next > SEEDS) {
          worker.terminate();
          resolve();
          return;
        }
        worker.postMessage({ type: "runs", request: { ...REQUEST, id: next, seeds: [next] } });
        next += 1;
      };
      worker.addEventListener("message", (/** @type {MessageEvent<FromRuns>} */ { data }) => {
        if (data.type === "ran") ask();
        else reject(new Error(data.message));
      });
      worker.addEventListener("error", (event) => reject(new Error(event.message || "the worker could not be loaded")));
      worker.postMessage({ type: "init", module });
      ask();
    });
  await Promise.all(Array.from({ length: cores }, work));
  const ms = performance.now() - began;
  const name = `Monte Carlo: ${SEEDS} runs of ${MINUTES} min, ${cores} workers`;
  return { name, ms, times_real_time: (SEEDS * MINUTES * 60) / (ms / 1000), memory_mb: null };
}
