// @ts-check
// Programs at work for others than the floor of Explore: logs for races and many runs, plans for comparisons.
import { THINKING } from "./doubt.js";
import { kitFor } from "./kit.js";
import { STEP } from "./stage.js";
import { Inmate } from "./sandbox.js";

/**
 * @typedef {{ language: "python" | "javascript", source: string }} Text
 * @typedef {import("./types").FromWorker} FromWorker
 * @typedef {object} Order
 * @property {Text} program
 * @property {Uint8Array} job
 * @property {number} [seed] In place of the job's.
 * @property {number} seconds How long it drives, at most.
 * @property {(part: Uint8Array) => void} [onPart] Takes the log as it grows; else the whole log is the result.
 * @property {number} [from] What is before that step is known: it is run again, and not told.
 * @property {() => Promise<number>} [next] How long it drives when that time is over, s: longer, or not at all if that is no
 *   more. Without it, it drives no further.
 */

/** Longest step, ms: nobody waits for it as in the tab Program, and all cores are busy. */
const STEPPING = 4000;
/** Workers that have nothing to do. @type {{ inmate: Inmate, language: string, hear: (message: FromWorker) => void, ended: (text: string) => void }[]} */
const idle = [];
let lastId = 0;

/** @param {"python" | "javascript"} language */
async function hand(language) {
  const known = idle.findIndex((one) => one.language === language && one.inmate.isAlive);
  if (known >= 0) return /** @type {typeof idle[number]} */ (idle.splice(known, 1)[0]);
  const kit = await kitFor(language);
  const one = { language, hear: (/** @type {FromWorker} */ _message) => {}, ended: (/** @type {string} */ _text) => {}, inmate: /** @type {Inmate} */ (/** @type {unknown} */ (undefined)) };
  const said = { silent: "a step of the program never ended; run it in the tab Program to see which line it is", loud: "the program sent too much", broken: "the program's worker broke down; it may have used too much memory" };
  one.inmate = new Inmate(kit, (message) => one.hear(message), (why) => one.ended(said[why]));
  return one;
}

/**
 * Runs a program once, in a worker of the sandbox.
 * @param {Order} order @param {{ isWanted?: () => boolean }} [options]
 * @returns {Promise<{ log: Uint8Array, digest: string } | { cells: Uint32Array, seconds: number }>} Throws a sentence for users.
 */
export async function work({ program: { language, source }, job, seed, seconds, onPart, from = 0, next }, { isWanted = () => true } = {}) {
  const one = await hand(language);
  const id = (lastId += 1);
  let until = Math.ceil(seconds / STEP);
  /** @type {(() => Promise<boolean>)} Lets it drive on. */
  const goOn = async () => {
    const before = until;
    until = Math.ceil(((await next?.()) ?? 0) / STEP);
    if (until > before) one.inmate.ask({ type: "go", id, until }, STEPPING);
    return until > before;
  };
  let began = 0;
  try {
    return await new Promise((resolve, reject) => {
      one.ended = reject;
      one.hear = (message) => {
        if (!isWanted()) return one.inmate.end(), reject("it was cancelled");
        if (!("id" in Object(message)) || /** @type {{ id: number }} */ (message).id !== id) return;
        if (message.type === "loaded") {
          began = performance.now();
          if (message.kind === "plan") one.inmate.ask({ type: "plan", id }, THINKING);
          else one.inmate.ask({ type: "go", id, until }, STEPPING);
        } else if (message.type === "failed") {
          const where = Number(message.line) ? ` in line ${Number(message.line)}` : "";
          reject(`the program failed${where}: ${String(message.message).slice(0, 500)}`);
        } else if (message.type === "planned" && message.cells instanceof Uint32Array) resolve({ cells: message.cells, seconds: (performance.now() - began) / 1000 });
        else if (message.type === "ran" && message.log instanceof Uint8Array) {
          onPart?.(message.log);
          if (message.more === true) return;
          const { log, digest } = message;
          const done = () => resolve({ log, digest: String(digest) });
          if (next && message.isOver !== true) void goOn().then((goesOn) => goesOn || done());
          else done();
        }
      };
      one.inmate.ask({ type: "load", id, language, source, job, traced: false, breakpoints: [], from, seed, isQuiet: !onPart }, STEPPING);
    });
  } finally {
    if (one.inmate.isAlive) idle.push(one);
  }
}

/**
 * Adds to a request of a comparison or of many runs what the program did.
 * @param {Text | undefined} program
 * @param {{ id: number, job: ArrayLike<number>, seeds?: number[], duration_s?: number, behaves?: boolean }} request
 * @param {() => boolean} isWanted
 */
export async function prepared(program, request, isWanted) {
  if (!program) throw "the program isn't there any more";
  const job = Uint8Array.from(request.job);
  if (!request.behaves || !request.seeds) {
    const plan = await work({ program, job, seconds: 0 }, { isWanted });
    if (!("cells" in plan)) throw "the program drives, and doesn't plan";
    return { ...request, ...plan };
  }
  const logs = [];
  for (const seed of request.seeds) {
    const run = await work({ program, job, seed, seconds: request.duration_s ?? 0 }, { isWanted });
    if (!("log" in run)) throw "the program plans, and doesn't drive";
    logs.push(run.log);
  }
  return { ...request, logs };
}
