// @ts-check
// Many runs on all cores, as in Compare: a hundred times half an hour in the furnished flat, of the cleaning cycle or a program.

/** @typedef {import("./worker-types").FromRuns} FromRuns */

const asked = new URLSearchParams(location.search);
/** Or as many as the address says: bench.html?runs=4. */
const SEEDS = Number(asked.get("runs")) || 100;
/** With bench.html?once as short as shows that it works. */
const MINUTES = asked.has("once") ? 3 : 30;

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

/**
 * @param {WebAssembly.Module} module @param {string} what @param {(request: any) => Promise<object>} prepare What comes before: a program drives in its sandbox.
 * @returns {Promise<import("./types").BenchResult>}
 */
export async function measureRuns(module, what = "", prepare = async (request) => request) {
  const cores = navigator.hardwareConcurrency || 2;
  const began = performance.now();
  let next = 1;
  /** Gives one worker requests until all seeds are taken. @returns {Promise<void>} */
  const work = () =>
    new Promise((resolve, reject) => {
      const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
      const ask = async () => {
        if (next > SEEDS) {
          worker.terminate();
          resolve();
          return;
        }
        const id = next++;
        worker.postMessage({ type: "runs", request: await prepare({ ...REQUEST, id, seeds: [id] }) });
      };
      worker.addEventListener("message", (/** @type {MessageEvent<FromRuns>} */ { data }) => {
        if (data.type === "ran") ask().catch(reject);
        else reject(new Error(data.message));
      });
      worker.addEventListener("error", (event) => reject(new Error(event.message || "the worker could not be loaded")));
      worker.postMessage({ type: "init", module });
      ask().catch(reject);
    });
  await Promise.all(Array.from({ length: cores }, work));
  const ms = performance.now() - began;
  const name = `Monte Carlo${what}: ${SEEDS} runs of ${MINUTES} min, ${cores} workers`;
  return { name, ms, times_real_time: (SEEDS * MINUTES * 60) / (ms / 1000), memory_mb: null };
}
