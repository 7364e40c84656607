// @ts-check
// A program in Python, in MicroPython.
import { chance } from "./chance.js";
import { MOST_PRINTED, whole } from "./javascript.js";
import { NONE, startMicroPython } from "./micropython.js";
import { explained, uncalled } from "./python-hints.js";
import { attributeWriter } from "./python-attributes.js";
import { instrument } from "./trace-python.js";
import { SourceError, atIdle } from "./words.js";

/** @typedef {import("./runtime.js").Options} Options */
/** @typedef {import("./runtime.js").Program} Program */
/** Pages of memory that differ from those after loading. @typedef {{bytes: number, pages: Uint32Array, content: Uint8Array, length: number, left: number, right: number}} State */

const PAGE = 4096;
const MEGABYTE = 1 << 20;
/** How many of the statements that JavaScript counts take as long as one turn of a loop that is counted here, by a call. */
const CALL = 5;

/** @param {Options} options @returns {Promise<Program>} */
export async function loadPython(options) {
  const { source, name = "program.py", facts, seed, layout, micropython, traced = false, budget = Infinity, breakpoints = [], memory = 64 } = options;
  if (!micropython) throw new Error("a Python program needs micropython: {wasm, files}");
  const module = micropython.wasm instanceof WebAssembly.Module ? micropython.wasm : await WebAssembly.compile(/** @type {BufferSource} */ (micropython.wasm));
  const idle = uncalled(source);
  if (idle) throw new SourceError(idle.message, idle.line);
  const python = await startMicroPython(module, micropython.files, memory * MEGABYTE);
  const { heap, exports, result, state } = python;
  const text = traced ? instrument(source, breakpoints) : { source, lines: null };
  /** @type {Record<string, unknown>[]} */
  const output = [];
  let isDead = false;
  let hint = 0;
  let what = "program never starts";

  /** @param {any} error */
  const inWords = (error) => {
    if (error instanceof SourceError) return error;
    if (error?.neverEnds) {
      isDead = true;
      return new SourceError(`this line is run again and again: the ${what}`, heap.words[traceAt]);
    }
    if (!error?.python) return error;
    const inPython = pythonError(error.message, name, text.lines, source);
    if (hint && /no such name$|^NameError: name '/.test(inPython.message)) inPython.message = String(python.call(hint, inPython.message));
    return inPython;
  };
  /** @template T @param {() => T} work @returns {T} */
  const guarded = (work) => {
    try {
      return work();
    } catch (error) {
      throw inWords(error);
    }
  };
  const call = (/** @type {number} */ ref, /** @type {(string | number | {ref: number})[]} */ ...values) => guarded(() => python.call(ref, ...values));

  guarded(() => python.run("from robovac_program import page\nfrom robovac_program.page import *\nfrom robovac_program.page import trace"));
  const named = (/** @type {string} */ of) => python.named(of);
  hint = named("hinted");
  const traceAt = Number(call(named("trace"))) >> 2;
  let most = Math.min(budget / CALL, 2 ** 30);
  heap.words[traceAt + 1] = most;
  // What Python's `random` begins with: always the same, as it may begin again behind a restored state.
  const first = chance(seed)();
  state.chance = () => first;
  const loading = named("load");
  options.begins?.();
  const { kind, floats, out } = JSON.parse(String(call(loading, text.source, name, JSON.stringify(facts), String(seed))));
  what = kind === "plan" ? "plan never ends" : "step never ends";
  // A planner may think for longer.
  if (kind === "plan") most = Math.min(budget, 2 ** 30);
  const [floatsAt, outAt] = [floats >> 3, out >> 3];
  python.run("robot = page.program.robot\nfunction = page.program.function");
  const robot = named("robot");
  const function_ = kind === "step" ? named("function") : named("run");
  const [takeEvents, variablesOf] = [named("take"), named("variables")];
  const args = python.args([{ ref: robot }]);

  const { names, flags } = JSON.parse(String(call(named("attributes"))));
  const places = { names, flags, robotAt: Number(call(named("mark"))) >> 2, floatsAt };
  const { write, forget } = attributeWriter(heap, places, layout, facts.laser?.beams ?? 0, () => JSON.parse(String(call(named("check")))));

  const drain = () => {
    if (state.printed) {
      const printed = python.takePrinted();
      const shown = printed.length > MOST_PRINTED ? printed.slice(0, MOST_PRINTED) : printed;
      for (const line of (shown.endsWith("\n") ? shown.slice(0, -1) : shown).split("\n")) output.push({ kind: "print", text: line });
      if (shown !== printed) throw new SourceError(`more than ${MOST_PRINTED} characters printed in one step`);
    }
    if (heap.doubles[outAt + 2] !== 0) output.push(...JSON.parse(String(call(takeEvents))));
  };
  drain();

  const base = heap.bytes.slice();
  const stack = exports.emscripten_stack_get_current();
  const program = {
    kind,
    left: 0,
    right: 0,
    get line() { return traced ? heap.words[traceAt] : 0; },
    output,
    /** @param {Float64Array} readings */
    step(readings) {
      if (isDead) throw new SourceError("the program has ended");
      write(readings);
      state.time = heap.doubles[floatsAt];
      heap.words[traceAt + 1] = most;
      try {
        exports.proxy_c_to_js_call(function_, 1, args, result);
        if (heap.words[result >> 2] !== NONE) returned(python.value(), kind);
      } catch (error) {
        if (!isDead) drain();
        throw inWords(error);
      }
      if (state.printed || heap.doubles[outAt + 2] !== 0) drain();
      const { doubles } = heap;
      program.left = whole(doubles[outAt], facts.top_speed);
      program.right = whole(doubles[outAt + 1], facts.top_speed);
      return doubles[outAt + 3] === 0;
    },
    /** @returns {[name: string, text: string, type: string][]} */
    variables: () => (isDead ? [] : JSON.parse(String(call(variablesOf)))),
    /** @returns {State} */
    save() {
      const { bytes } = heap;
      const pages = [];
      for (let at = 0; at < bytes.length; at += PAGE) if (differs(bytes, base, at)) pages.push(at);
      const content = new Uint8Array(pages.length * PAGE);
      pages.forEach((at, index) => content.set(bytes.subarray(at, at + PAGE), index * PAGE));
      return { bytes: content.length, pages: Uint32Array.from(pages), content, length: bytes.length, left: program.left, right: program.right };
    },
    /** @param {State} saved */
    restore(saved) {
      const { bytes } = heap;
      // An endless step was left without return.
      exports._emscripten_stack_restore(stack);
      bytes.set(base);
      bytes.fill(0, base.length);
      saved.pages.forEach((at, index) => bytes.set(saved.content.subarray(index * PAGE, (index + 1) * PAGE), at));
      forget();
      state.printed = "";
      output.length = 0;
      isDead = false;
      program.left = saved.left;
      program.right = saved.right;
    },
    /** @param {{rows: string[], cell: number, start: number[]}} room */
    *plan(room) {
      heap.words[traceAt + 1] = most;
      const more = named("more");
      call(named("plan"), JSON.stringify(room));
      for (;;) {
        const cells = JSON.parse(String(call(more)));
        drain();
        if (cells.length === 0) return;
        yield* cells;
      }
    },
  };
  return /** @type {Program} */ (program);
}

/** Whether a page of memory isn't what it was; what was beyond its end was 0. @param {Uint8Array} bytes @param {Uint8Array} base @param {number} at */
function differs(bytes, base, at) {
  const now = new Float64Array(bytes.buffer, at, PAGE / 8);
  const words = new Int32Array(bytes.buffer, at, PAGE / 4);
  if (at >= base.length) return words.some((word) => word !== 0);
  const before = new Int32Array(base.buffer, at, now.length * 2);
  for (let index = 0; index < words.length; index++) if (words[index] !== before[index]) return true;
  return false;
}

/** A function that returns something other than None. @param {unknown} value @param {string} kind */
function returned(value, kind) {
  if (kind === "step" && value !== null && typeof value === "object") throw new SourceError("step has a yield: a function that waits is def run(robot)");
}

/** MicroPython's traceback in words. @param {string} trace @param {string} name @param {number[] | null} lines @param {string} source */
function pythonError(trace, name, lines, source) {
  const all = trace.trimEnd().split("\n");
  const places = all.filter((words) => words.startsWith("  File "));
  const from = all.lastIndexOf(places[places.length - 1]);
  const own = places.filter((words) => words.startsWith(`  File "${name}", line `)).pop();
  const number = Number(/line (\d+)/.exec(own ?? "")?.[1] ?? 0);
  let message = all.slice(from + 1).join("\n");
  message = message.replace(/^(ProgramError|AttributeError): (?=.)/, "");
  if (/maximum recursion depth/.test(message)) message = "a function calls itself without end";
  if (/^MemoryError/.test(message)) message = "the program needs more memory than it may have";
  const told = explained(message, (lines ? lines[number] : number) || undefined, source);
  return atIdle(new SourceError(told.message, told.line), source);
}
