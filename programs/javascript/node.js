// @ts-check
// usage: node node.js FILE   Runs a program for `robovac run`: one JSON object a line, as docs/programs.md describes.
import fs from "node:fs";
import readline from "node:readline";
import { loadJavaScript } from "./javascript.js";
import { LAYOUT, pack } from "./layout.js";

const VERSION = 1;
const file = process.argv[2];
if (!file) {
  console.error("usage: node node.js FILE   (a program for `robovac run`)");
  process.exit(2);
}

/** @type {import("./runtime.js").Program | undefined} */
let program;
let readings = new Float64Array(0);
/** Whether the host keeps commands, and the step that comes next. */
let holds = false;
let at = 0;

/** @param {Record<string, unknown>} message */
function answer(message) {
  const output = program?.output ?? [];
  const print = output.filter(({ kind }) => kind === "print").map(({ text }) => text);
  const events = output.filter(({ kind }) => kind !== "print");
  output.length = 0;
  process.stdout.write(`${JSON.stringify({ ...message, ...(print.length && { print }), ...(events.length && { events }) })}\n`);
}

/** @param {any} message */
function take(message) {
  if (message.kind === "hello" && message.robovac === VERSION) {
    readings = new Float64Array(LAYOUT.laser + (message.robot.laser?.beams ?? 0));
    program = loadJavaScript({ language: "javascript", source: fs.readFileSync(file, "utf8"), name: file, facts: message.robot, seed: message.seed, layout: LAYOUT });
    holds = message.holds === true;
    return answer({ ready: program.kind === "plan" ? "planner" : "behaviour" });
  }
  if (!program) throw new Error(`this program speaks version ${VERSION} of the protocol; the host does not`);
  if (message.room) {
    const cells = [...program.plan(message.room)];
    for (let at = 0; at < cells.length; at += 1000) answer({ cells: cells.slice(at, at + 1000) });
    return answer({ done: true });
  }
  pack(message, readings);
  if (message.step > at) program.skip?.(message.step - at);
  at = message.step + 1;
  const goesOn = program.step(readings);
  const hold = (goesOn && holds && program.hold?.()) || 0;
  answer({ left: program.left, right: program.right, ...(!goesOn && { done: true }), ...(hold && { hold }) });
}

for await (const line of readline.createInterface({ input: process.stdin })) {
  try {
    take(JSON.parse(line));
  } catch (/** @type {any} */ error) {
    answer({ error: error.message, ...(error.line && { line: error.line }) });
    process.exitCode = 1;
    break;
  }
}
