// @ts-check
// Plans and reads maps away from the page, which stays responsive; to cancel, the page ends this worker.
import init, { Runner, TrialRunner, film, fit_cells, flat, least, map_bag, plan, prove, read_map, run_bag, smooth, trade_off } from "../workshop.js";

/** @typedef {import("./worker-types").FromWorker | import("./worker-types").FromTrial | import("./worker-types").FromRuns | import("./worker-types").FromReader | import("./worker-types").FromFit | import("./worker-types").FromTradeOff | import("./worker-types").FromBag} Answer */

let markReady = () => {};
/** @type {Promise<void>} */
const ready = new Promise((resolve) => (markReady = resolve));
/** @type {TrialRunner | undefined} */
let trials;
/** @type {Runner | undefined} */
let runner;

/** @param {Answer} message @param {ArrayBufferLike[]} [transfer] */
function answer(message, transfer = []) {
  self.postMessage(message, { transfer: /** @type {Transferable[]} */ (transfer) });
}

/** @param {import("./worker-types").PlanRequest} request @param {import("./worker-types").WirePath} path @param {import("./worker-types").Knots} knots */
function tellProof(request, path, knots) {
  answer({ type: "proven", id: request.id, proof: prove(request, path), least: least(request, path, knots) });
}

self.addEventListener("message", async (/** @type {MessageEvent<import("./worker-types").ToWorker>} */ event) => {
  const message = event.data;
  if (message.type === "init") {
    await init({ module_or_path: message.module });
    markReady();
    return;
  }
  await ready;
  const { id } = message.request;
  /** @type {unknown[]} */
  const frames = [];
  /** @param {number} done @param {import("./worker-types").WirePath} cells @param {import("./worker-types").Proof | undefined} proof @param {unknown[] | undefined} more */
  const report = (done, cells, proof, more = []) => {
    frames.push(...more);
    answer({ type: "progress", id, done, cells, proof, frames: more }, [cells.buffer]);
  };
  try {
    if (message.type === "plan") {
      const { cells, seconds, trace, proof } = plan(message.request, report);
      const knots = smooth(message.request, cells);
      answer({ type: "finished", id, cells, seconds, trace, proof, knots, film: film(message.request, frames, cells, proof) });
      tellProof(message.request, cells, knots);
    } else if (message.type === "prove") {
      const knots = smooth(message.request, message.cells);
      answer({ type: "smoothed", id, knots });
      answer({ type: "filmed", id, film: film(message.request, message.frames, message.cells, message.proof) });
      tellProof(message.request, message.cells, knots);
    } else if (message.type === "read" || message.type === "flat") {
      const map = message.type === "read" ? read_map(message.request.files) : flat(message.request.flat);
      answer({ type: "read", id, map }, [map.buffer]);
    } else if (message.type === "fit") {
      answer({ type: "fitted", id, cells: fit_cells(message.request.snapshot, message.request.percent) });
    } else if (message.type === "trade-off") {
      const { snapshot, corners, shares } = message.request;
      trade_off(snapshot, corners, shares, (/** @type {Float64Array} */ point) => answer({ type: "point", id, point }));
      answer({ type: "traded", id });
    } else if (message.type === "bag") {
      const { request } = message;
      const bytes = "stored" in request ? map_bag(request.snapshot, request.link, request.stored, request.log) : run_bag(request.snapshot, request.corners, request.knots, request.inputs, request.end_s, request.log);
      answer({ type: "bagged", id, bytes }, [bytes.buffer]);
    } else if (message.type === "runs") {
      runner ??= new Runner();
      const outcomes = runner.run(message.request);
      answer({ type: "ran", id, outcomes }, [outcomes.buffer]);
    } else {
      trials ??= new TrialRunner();
      const { cells, numbers, knots } = trials.run(message.request, report);
      answer({ type: "tried", id, cells, numbers, knots }, [cells.buffer]);
    }
  } catch (error) {
    answer({ type: "failed", id, message: error instanceof Error ? error.message : String(error) });
  }
});
