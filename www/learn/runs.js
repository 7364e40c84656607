// @ts-check
// Runs in workers for goals and measurements.
import { hire } from "../workers.js";

/** Most workers at a time. */
const MOST = 8;

/**
 * Makes the runs of all requests, side by side; `told(index, outcomes)` is called as each is done. Throws a message for users.
 * @param {{ id: number }[]} requests
 * @param {(index: number, outcomes: Float64Array) => void} told
 * @param {AbortSignal} signal
 * @param {{ program: import("../program/work.js").Text, job: Uint8Array }} [driven] The program that makes them, and what it needs for it.
 */
export async function makeRuns(requests, told, signal, driven) {
  let next = 0;
  const count = Math.min(MOST, navigator.hardwareConcurrency || 2, requests.length);
  /** @type {Worker[]} */
  const workers = [];
  const stop = () => workers.forEach((worker) => worker.terminate());
  const work = async () => {
    const worker = await hire();
    workers.push(worker);
    if (signal.aborted) return worker.terminate();
    while (next < requests.length && !signal.aborted) {
      const id = next++;
      const request = { .../** @type {{ id: number }} */ (requests[id]), id };
      told(id, await one(worker, driven ? await logged(request, driven, signal) : request, signal));
    }
  };
  try {
    await Promise.all(Array.from({ length: count }, work));
    signal.throwIfAborted();
  } finally {
    stop();
  }
}

/** @param {Worker} worker @param {{ id: number }} request @param {AbortSignal} signal @returns {Promise<Float64Array>} */
function one(worker, request, signal) {
  return new Promise((resolve, reject) => {
    signal.addEventListener("abort", () => reject(signal.reason), { once: true });
    worker.onmessage = (/** @type {MessageEvent<import("../worker-types").FromRuns>} */ { data }) => {
      if (data.type === "ran") resolve(data.outcomes);
      else reject(new Error(data.message));
    };
    worker.onerror = (event) => reject(new Error(event.message || "a worker could not be started"));
    worker.postMessage({ type: "runs", request });
  });
}

/** The request with what the program did, in its sandbox. @param {{ id: number }} request @param {{ program: import("../program/work.js").Text, job: Uint8Array }} driven @param {AbortSignal} signal */
async function logged(request, { program, job }, signal) {
  const { prepared } = await import("../program/work.js");
  return prepared(program, { ...request, job }, () => !signal.aborted);
}

/** All numbers one behind the other. @param {Float64Array[]} parts */
export function joined(parts) {
  const all = new Float64Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
