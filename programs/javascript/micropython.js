// @ts-check
// MicroPython in WebAssembly, without a browser around it: it has a memory, a read-only folder of files and a place to
// print. It has no `js` module, no network and no clock but the robot's.

/** Errors of POSIX that it is told. */
const NO_FILE = -44;
const NO_SUCH_CALL = -52;
const BAD_FILE = 8;
/** Kinds of values that cross its border: what proxy_c.c of MicroPython's port calls PROXY_KIND_MP_* and PROXY_KIND_JS_*. */
export const EXCEPTION = -1;
export const NONE = 1;
const BOOLEAN = 2;
const INTEGER = 3;
const STRING = 5;
const CALLABLE = 6;
const GIVEN_STRING = 5;
const GIVEN_OBJECT = 8;
const PAGE = 65536;
/** Stack of Python's calls, bytes; heap at the start, bytes. */
const PYTHON_STACK = 64 * 1024;
const HEAP = 512 * 1024;

/** @typedef {{name: string, text: string}} PythonError */

/** An interpreter with `files`, which it imports from /lib, and at most `memory` bytes.
 * @param {WebAssembly.Module} module @param {Record<string, string>} files @param {number} memory */
export async function startMicroPython(module, files, memory) {
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  /** @type {Record<string, Uint8Array>} */
  const contents = {};
  const folders = new Set(["/", "/lib"]);
  for (const [name, text] of Object.entries(files)) {
    contents[`/lib/${name}`] = encoder.encode(text);
    for (let at = name.indexOf("/"); at >= 0; at = name.indexOf("/", at + 1)) folders.add(`/lib/${name.slice(0, at)}`);
  }
  /** @type {({bytes: Uint8Array, at: number} | null)[]} */
  const open = [null, null, null];
  /** @type {any} */
  let of = {};
  let bytes = new Uint8Array();
  let words = new Int32Array();
  /** Its memory, looked at anew when it grows. */
  const memoryViews = { bytes, words, doubles: new Float64Array() };
  const look = () => {
    memoryViews.bytes = bytes = new Uint8Array(of.memory.buffer);
    memoryViews.words = words = new Int32Array(of.memory.buffer);
    memoryViews.doubles = new Float64Array(of.memory.buffer);
  };
  /** @param {number} at */
  const text = (at) => decoder.decode(bytes.subarray(at, bytes.indexOf(0, at)));
  /** @param {number} at */
  const resolved = (at) => {
    const path = text(at).replace(/\/+/g, "/").replace(/^\.\//, "");
    return path.startsWith("/") ? path : `/${path}`;
  };
  /** What was printed and not yet taken. */
  const state = { printed: "", time: 0, chance: () => 0 };
  /** @param {string} name @param {number} at */
  const stat = (name, at) => {
    if (!folders.has(name) && !contents[name]) return NO_FILE;
    bytes.fill(0, at, at + 96);
    words[(at + 4) >> 2] = folders.has(name) ? 0o40555 : 0o100444;
    words[(at + 24) >> 2] = contents[name]?.length ?? 0;
    return 0;
  };
  /** Runs over the buffers of a call such as writev. @param {number} vector @param {number} count @param {(at: number, length: number) => number} use */
  const each = (vector, count, use) => {
    let total = 0;
    for (let index = 0; index < count; index++) total += use(words[(vector >> 2) + 2 * index], words[(vector >> 2) + 2 * index + 1]);
    return total;
  };
  const stream = new TextDecoder();
  /** @type {Record<string, Function>} */
  const calls = {
    mp_js_random_u32: () => Math.floor(state.chance() * 4294967296) | 0,
    mp_js_ticks_ms: () => state.time * 1000,
    mp_js_time_ms: () => state.time * 1000,
    // Nothing of JavaScript is reachable.
    has_attr: () => 0,
    lookup_attr: (/** @type {number} */ _, /** @type {number} */ name) => {
      // The one thing that Python can't catch: see page.py.
      if (text(name) === "never_ends") throw Object.assign(new Error("never ends"), { neverEnds: true });
      return 0;
    },
    js_check_existing: () => -1,
    proxy_js_free_obj: () => {},
    __syscall_stat64: (/** @type {number} */ path, /** @type {number} */ at) => stat(resolved(path), at),
    __syscall_lstat64: (/** @type {number} */ path, /** @type {number} */ at) => stat(resolved(path), at),
    __syscall_getcwd: (/** @type {number} */ at) => (bytes.set([47, 0], at), 2),
    __syscall_openat: (/** @type {number} */ _, /** @type {number} */ path) => {
      const found = contents[resolved(path)];
      return found ? open.push({ bytes: found, at: 0 }) - 1 : NO_FILE;
    },
    fd_close: (/** @type {number} */ fd) => {
      open[fd] = null;
      while (open.length > 3 && !open[open.length - 1]) open.pop();
      return 0;
    },
    fd_read: (/** @type {number} */ fd, /** @type {number} */ vector, /** @type {number} */ count, /** @type {number} */ done) => {
      const file = open[fd];
      if (!file) return BAD_FILE;
      words[done >> 2] = each(vector, count, (at, length) => {
        const part = file.bytes.subarray(file.at, file.at + length);
        bytes.set(part, at);
        file.at += part.length;
        return part.length;
      });
      return 0;
    },
    fd_write: (/** @type {number} */ _, /** @type {number} */ vector, /** @type {number} */ count, /** @type {number} */ done) => {
      words[done >> 2] = each(vector, count, (at, length) => {
        state.printed += stream.decode(bytes.subarray(at, at + length), { stream: true });
        return length;
      });
      return 0;
    },
    emscripten_resize_heap: (/** @type {number} */ wanted) => {
      const most = Math.min(memory, Math.max(wanted, bytes.length + (bytes.length >> 2)));
      if (wanted > most) return 0;
      try {
        of.memory.grow(Math.ceil((most - of.memory.buffer.byteLength) / PAGE));
      } catch {
        return 0;
      }
      look();
      return 1;
    },
  };
  /** @type {Record<string, Record<string, Function>>} */
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] ??= {};
    imports[from][name] = calls[name] ?? (name.startsWith("__syscall") || name.startsWith("fd_") ? () => NO_SUCH_CALL : () => { throw new Error(`MicroPython wants ${name}`); });
  }
  of = (await WebAssembly.instantiate(module, /** @type {WebAssembly.Imports} */ (imports))).exports;
  look();
  of.emscripten_stack_init();
  of.__wasm_call_ctors();
  of.mp_js_init(PYTHON_STACK, HEAP);
  of.proxy_c_init();
  const result = of.malloc(16);

  /** @param {string} value */
  const allocated = (value) => {
    const encoded = encoder.encode(`${value}\0`);
    const at = of.malloc(encoded.length);
    bytes.set(encoded, at);
    return at;
  };
  /** The value of the last call: a number, a text, the number of an object; or throws Python's exception. */
  const value = () => {
    const [kind, first, second] = words.subarray(result >> 2, (result >> 2) + 3);
    if (kind === NONE) return null;
    if (kind === BOOLEAN) return first !== 0;
    if (kind === INTEGER) return first;
    if (kind === STRING) return decoder.decode(bytes.subarray(second, second + first));
    if (kind === EXCEPTION) {
      const words = decoder.decode(bytes.subarray(second, second + first));
      of.free(second);
      const [name, text] = words.split("\x04");
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
    heap: memoryViews,
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
          words.set([GIVEN_STRING, encoder.encode(given).length, text], place);
        } else if (typeof given === "number") words.set([INTEGER, given, 0], place);
        else words.set([GIVEN_OBJECT, given.ref, 0], place);
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
