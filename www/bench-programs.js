// @ts-check
// Users' programs at work, as the page runs them: in the sandbox, along the wall of the furnished flat.
import init, { Playground } from "../page.js";
import { prepared, work } from "./program/work.js";

/** @typedef {import("./types").BenchResult} BenchResult */

const LANGUAGES = /** @type {const} */ ([["python", "Python", "py"], ["javascript", "JavaScript", "js"]]);
const PLACE = "room=flat&robot=roomba600&slip=typical&noise=typical&seed=1&behaviour=bounce";

/** The program in that language. @param {"python" | "javascript"} language */
async function program(language) {
  const ending = LANGUAGES.find(([name]) => name === language)?.[2];
  const response = await fetch(new URL(`../programs/examples/follow_the_wall.${ending}`, import.meta.url));
  if (!response.ok) throw new Error(`the example could not be fetched (status ${response.status})`);
  return { language, source: await response.text() };
}

/** The room as the sandbox gets it. */
async function flat() {
  await init({ module_or_path: new URL("../page_bg.wasm", import.meta.url) });
  const playground = new Playground(document.createElement("canvas"));
  playground.restore(PLACE);
  return new TextEncoder().encode(JSON.stringify({ place: playground.snapshot(), inputs: [], version: 0 }));
}

/** A run in each language, the median of some. @param {number} minutes @param {number} rounds @param {(result: BenchResult) => void} show */
export async function measurePrograms(minutes, rounds, show) {
  const [job, seconds] = [await flat(), 60 * minutes];
  for (const [language, title] of LANGUAGES) {
    const order = { program: await program(language), job, seconds };
    // Loaded and compiled before.
    await work({ ...order, seconds: 60 });
    const took = [];
    for (let round = 0; round < rounds; round += 1) {
      const began = performance.now();
      await work(order);
      took.push(performance.now() - began);
    }
    const ms = took.sort((a, b) => a - b)[took.length >> 1];
    show({ name: `program in ${title}: follow the wall of the flat, ${minutes} min`, ms, times_real_time: (1000 * seconds) / ms, memory_mb: null });
  }
}

/** Makes what the runs of a program need: a request becomes one with its log. @param {"python" | "javascript"} language */
export async function logged(language) {
  const [job, text] = [await flat(), await program(language)];
  return (/** @type {{ id: number, seeds: number[] }} */ request) => prepared(text, { ...request, job }, () => true);
}
