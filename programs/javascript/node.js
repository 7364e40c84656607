// @ts-check
// usage: node node.js FILE   Runs a program for `robovac run`: one JSON object a line, as docs/programs.md describes.
import fs from "node:fs";
import { Framed } from "./frames.js";
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

/** The lines of the host, as they come. */
function* lines() {
  const part = Buffer.alloc(1 << 16);
  for (let rest = ""; ; ) {
    const read = fs.readSync(0, part, 0, part.length, null);
    const all = (rest + part.toString("latin1", 0, read)).split("\n");
    rest = all.pop() ?? "";
    // Behind the last line there may be none.
    yield* (read || !rest ? all : [rest]).map((line) => Buffer.from(line, "latin1").toString());
    if (read === 0) return;
  }
}

/** @param {Record<string, unknown>} message */
function answer(message) {
  const output = program?.output ?? [];
  const print = output.filter(({ kind }) => kind === "print").map(({ text }) => text);
  const events = output.filter(({ kind }) => kind !== "print");
  output.length = 0;
  const line = Buffer.from(`${JSON.stringify({ ...message, ...(print.length && { print }), ...(events.length && { events }) })}\n`);
  for (let sent = 0; sent < line.length; ) sent += fs.writeSync(1, line, sent);
}

/** @param {any} message */
function begin({ robot, seed, frames, holds: mayHold }) {
  const options = { language: /** @type {const} */ ("javascript"), source: fs.readFileSync(file, "utf8"), name: file, facts: robot };
  if (frames) {
    const framed = new Framed(frames, options);
    if (framed.kind !== "plan") {
      answer({ ready: "behaviour", frames: true });
      return framed.serve();
    }
  }
  readings = new Float64Array(LAYOUT.laser + (robot.laser?.beams ?? 0));
  program = loadJavaScript({ ...options, seed, layout: LAYOUT });
  holds = mayHold === true;
  answer({ ready: program.kind === "plan" ? "planner" : "behaviour" });
}

/** @param {any} message */
function take(message) {
  if (message.kind === "hello" && message.robovac === VERSION) return begin(message);
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

for (const line of lines()) {
  try {
    if (line) take(JSON.parse(line));
  } catch (/** @type {any} */ error) {
    answer({ error: error.message, ...(error.line && { line: error.line }) });
    process.exitCode = 1;
    break;
  }
}
