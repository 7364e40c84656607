// @ts-check
// Programs at work for others than the floor of Explore: logs for races and many runs, plans for comparisons.
import { THINKING } from "./doubt.js";
import { endOf } from "./faults.js";
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
 * @typedef {{ log: Uint8Array, digest: string } | { cells: Uint32Array, seconds: number }} Done
 */

/** Longest step, ms: nobody waits for it as in the tab Program, and all cores are busy. */
const STEPPING = 4000;
/**
 * @typedef {import("./sandbox.js").Why} Why
 * @typedef {{ inmate: Inmate, source: string, hear: (message: FromWorker) => void, ended: (why: Why, text: string) => void }} Hand
 */
/** Workers that have nothing to do. What one program has done to its worker is none of another's business. @type {Hand[]} */
let idle = [];
let lastId = 0;

/** @param {Text} program @returns {Promise<Hand>} */
async function hand({ language, source }) {
  for (const { inmate } of idle.filter((one) => one.source !== source)) inmate.end();
  idle = idle.filter(({ inmate }) => inmate.isAlive);
  const known = idle.pop();
  if (known) return known;
  const kit = await kitFor(language);
  /** @type {Hand} */
  const one = { source, hear: () => {}, ended: () => {}, inmate: new Inmate(kit, (message) => one.hear(message), (why, text) => one.ended(why, text)) };
  return one;
}

/**
 * Runs a program once, in a worker of the sandbox. If a step never ends, the same run is followed line by line, to say where.
 * @param {Order} order @param {{ isWanted?: () => boolean }} [options]
 * @returns {Promise<Done>} Throws a sentence for users.
 */
export async function work(order, { isWanted = () => true } = {}) {
  try {
    return await attempt(order, isWanted, STEPPING);
  } catch (error) {
    if (error !== "silent") throw error;
    await attempt({ ...order, onPart: undefined, next: undefined }, isWanted, THINKING).catch((error) => {
      throw error === "silent" ? bare(endOf("silent", "", 0).message) : error;
    });
    throw `a step of the program took longer than ${STEPPING / 1000} s and was ended. Do less in each step`;
  }
}

/** A sentence that stands behind others. @param {string} text */
const bare = (text) => text.replace(/^[A-Z](?=[a-z]* )/, (letter) => letter.toLowerCase()).replace(/\.$/, "");

/** @param {Order} order @param {() => boolean} isWanted @param {number} patience Longest step, ms: it is followed line by line, if that is more than ordinary. @returns {Promise<Done>} Throws "silent" if a step takes longer. */
async function attempt({ program, job, seed, seconds, onPart, from = 0, next }, isWanted, patience) {
  const { language, source } = program;
  const one = await hand(program);
  const id = (lastId += 1);
  let until = Math.ceil(seconds / STEP);
  /** @type {(() => Promise<boolean>)} Lets it drive on. */
  const goOn = async () => {
    const before = until;
    until = Math.ceil(((await next?.()) ?? 0) / STEP);
    if (until > before) one.inmate.ask({ type: "go", id, until }, patience);
    return until > before;
  };
  let began = 0;
  try {
    return await new Promise((resolve, reject) => {
      one.ended = (why, text) => reject(why === "silent" ? why : bare(endOf(why, text, 0).message));
      one.hear = (message) => {
        if (!isWanted()) return one.inmate.end(), reject("it was cancelled");
        if (!("id" in Object(message)) || /** @type {{ id: number }} */ (message).id !== id) return;
        if (message.type === "loaded") {
          began = performance.now();
          if (message.kind === "plan") one.inmate.ask({ type: "plan", id }, THINKING);
          else one.inmate.ask({ type: "go", id, until }, patience);
        } else if (message.type === "failed") {
          const where = Number(message.line) ? ` in line ${Number(message.line)}` : "";
          reject(`the program failed${where}: ${bare(String(message.message).slice(0, 500))}. Mend it in the tab Program`);
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
      one.inmate.ask({ type: "load", id, language, source, job, traced: patience > STEPPING, breakpoints: [], from, seed, isQuiet: !onPart }, patience);
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
    if (!("cells" in plan)) throw "the program drives but doesn't plan";
    return { ...request, ...plan };
  }
  const logs = [];
  for (const seed of request.seeds) {
    const run = await work({ program, job, seed, seconds: request.duration_s ?? 0 }, { isWanted });
    if (!("log" in run)) throw "the program plans but doesn't drive";
    logs.push(run.log);
  }
  return { ...request, logs };
}
