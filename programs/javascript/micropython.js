// @ts-check
// MicroPython in WebAssembly, without a browser around it: it has a memory, a read-only folder of files and a place to
// print. It has no `js` module, no network and no clock but the robot's.
import { Heap, NO_SUCH_CALL, systemCalls } from "./micropython-calls.js";

/** Kinds of values that cross its border: what proxy_c.c of MicroPython's port calls PROXY_KIND_MP_* and PROXY_KIND_JS_*. */
export const EXCEPTION = -1;
export const NONE = 1;
const BOOLEAN = 2;
const INTEGER = 3;
const STRING = 5;
const CALLABLE = 6;
const GIVEN_STRING = 5;
const GIVEN_OBJECT = 8;
/** Stack of Python's calls, bytes; heap at the start, heap.bytes. */
const PYTHON_STACK = 64 * 1024;
const HEAP = 512 * 1024;

/** @typedef {{name: string, text: string}} PythonError */

/** An interpreter with `files`, which it imports from /lib, and at most `memory` heap.bytes.
 * @param {WebAssembly.Module} module @param {Record<string, string>} files @param {number} memory */
export async function startMicroPython(module, files, memory) {
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  const heap = new Heap();
  /** What was printed and not yet taken; the robot's time, s; where Python's `random` begins. */
  const state = { printed: "", time: 0, chance: () => 0 };
  const calls = systemCalls(files, memory, heap, state);
  /** @type {Record<string, Record<string, Function>>} */
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = calls[name] ?? (name.startsWith("__syscall") || name.startsWith("fd_") ? () => NO_SUCH_CALL : () => { throw new Error(`MicroPython wants ${name}`); });
  }
  /** @type {any} */
  const of = (await WebAssembly.instantiate(module, /** @type {WebAssembly.Imports} */ (imports))).exports;
  heap.look(of.memory);
  of.emscripten_stack_init();
  of.__wasm_call_ctors();
  of.mp_js_init(PYTHON_STACK, HEAP);
  of.proxy_c_init();
  const result = of.malloc(16);

  /** @param {string} value */
  const allocated = (value) => {
    const encoded = encoder.encode(`${value}\0`);
    const at = of.malloc(encoded.length);
    heap.bytes.set(encoded, at);
    return at;
  };
  /** The value of the last call: a number, a text, the number of an object; or throws Python's exception. */
  const value = () => {
    const [kind, first, second] = heap.words.subarray(result >> 2, (result >> 2) + 3);
    if (kind === NONE) return null;
    if (kind === BOOLEAN) return first !== 0;
    if (kind === INTEGER) return first;
    if (kind === STRING) return decoder.decode(heap.bytes.subarray(second, second + first));
    if (kind === EXCEPTION) {
      const message = decoder.decode(heap.bytes.subarray(second, second + first));
      of.free(second);
      const [name, text] = message.split("\x04");
      throw Object.assign(new Error(text), { python: name });
    }
    // Keep what it is with its number.
    return { ref: first, callable: kind === CALLABLE };
  };

  return {
    state,
    exports: of,
    result,
    value,
    heap,
    takePrinted() {
      const printed = state.printed;
      state.printed = "";
      return printed;
    },
    /** Runs Python in its module __main__. @param {string} source */
    run(source) {
      const at = allocated(source);
      of.mp_js_do_exec(at, encoder.encode(source).length, result);
      of.free(at);
      return value();
    },
    /** The object of that name in __main__, as a number. @param {string} name @returns {number} */
    named(name) {
      const main = allocated("__main__");
      of.mp_js_do_import(main, result);
      const { ref } = /** @type {{ref: number}} */ (value());
      const at = allocated(name);
      of.proxy_c_to_js_lookup_attr(ref, at, result);
      of.free(at);
      of.free(main);
      return /** @type {{ref: number}} */ (value()).ref;
    },
    /** Arguments for call: texts and numbers of objects. @param {(string | number | {ref: number})[]} values */
    args(values) {
      const at = of.malloc(12 * values.length + 4);
      values.forEach((given, index) => {
        const place = (at >> 2) + 3 * index;
        if (typeof given === "string") {
          const text = allocated(given);
          heap.words.set([GIVEN_STRING, encoder.encode(given).length, text], place);
        } else if (typeof given === "number") heap.words.set([INTEGER, given, 0], place);
        else heap.words.set([GIVEN_OBJECT, given.ref, 0], place);
      });
      return at;
    },
    /** Calls a function with texts, whole numbers and objects. @param {number} ref @param {...(string | number | {ref: number})} values */
    call(ref, ...values) {
      const at = this.args(values);
      of.proxy_c_to_js_call(ref, values.length, at, result);
      of.free(at);
      return value();
    },
  };
}
