// @ts-check
// What MicroPython asks of the system around it: a read-only folder of files, a place to print, memory, the robot's clock.

/** POSIX errors that it gets. */
const NO_FILE = -44;
export const NO_SUCH_CALL = -52;
const BAD_FILE = 8;
const PAGE = 65536;
/** What is kept of a flood of text, characters. */
const MOST_KEPT = 100_000;

/** The interpreter's memory, looked at anew when it grows. */
export class Heap {
  bytes = new Uint8Array();
  words = new Int32Array();
  doubles = new Float64Array();
  /** @type {WebAssembly.Memory | undefined} */
  memory;

  look(memory = this.memory) {
    if (!memory) return;
    this.memory = memory;
    this.bytes = new Uint8Array(memory.buffer);
    this.words = new Int32Array(memory.buffer);
    this.doubles = new Float64Array(memory.buffer);
  }
}

/** The calls by name. `files` are below /lib; at most `memory` bytes are given. What is printed goes to `state`.
 * @param {Record<string, string>} files @param {number} memory @param {Heap} heap @param {{printed: string, time: number, chance: () => number}} state
 * @returns {Record<string, Function>} */
export function systemCalls(files, memory, heap, state) {
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  const stream = new TextDecoder();
  /** @type {Record<string, Uint8Array>} */
  const contents = {};
  const folders = new Set(["/", "/lib"]);
  for (const [name, text] of Object.entries(files)) {
    contents[`/lib/${name}`] = encoder.encode(text);
    for (let at = name.indexOf("/"); at >= 0; at = name.indexOf("/", at + 1)) folders.add(`/lib/${name.slice(0, at)}`);
  }
  /** @type {({bytes: Uint8Array, at: number} | null)[]} */
  const open = [null, null, null];
  /** @param {number} at */
  const text = (at) => decoder.decode(heap.bytes.subarray(at, heap.bytes.indexOf(0, at)));
  /** @param {number} at */
  const resolved = (at) => {
    const path = text(at).replace(/\/+/g, "/").replace(/^\.\//, "");
    return path.startsWith("/") ? path : `/${path}`;
  };
  /** @param {string} name @param {number} at */
  const stat = (name, at) => {
    if (!folders.has(name) && !contents[name]) return NO_FILE;
    heap.bytes.fill(0, at, at + 96);
    heap.words[(at + 4) >> 2] = folders.has(name) ? 0o40555 : 0o100444;
    heap.words[(at + 24) >> 2] = contents[name]?.length ?? 0;
    return 0;
  };
  /** Runs over the buffers of a call such as writev. @param {number} vector @param {number} count @param {(at: number, length: number) => number} use */
  const each = (vector, count, use) => {
    let total = 0;
    for (let index = 0; index < count; index++) total += use(heap.words[(vector >> 2) + 2 * index], heap.words[(vector >> 2) + 2 * index + 1]);
    return total;
  };
  return {
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
    __syscall_getcwd: (/** @type {number} */ at) => (heap.bytes.set([47, 0], at), 2),
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
      heap.words[done >> 2] = each(vector, count, (at, length) => {
        const part = file.bytes.subarray(file.at, file.at + length);
        heap.bytes.set(part, at);
        file.at += part.length;
        return part.length;
      });
      return 0;
    },
    fd_write: (/** @type {number} */ _, /** @type {number} */ vector, /** @type {number} */ count, /** @type {number} */ done) => {
      heap.words[done >> 2] = each(vector, count, (at, length) => {
        if (state.printed.length < MOST_KEPT) state.printed += stream.decode(heap.bytes.subarray(at, at + length), { stream: true });
        return length;
      });
      return 0;
    },
    emscripten_resize_heap: (/** @type {number} */ wanted) => {
      const most = Math.min(memory, Math.max(wanted, heap.bytes.length + (heap.bytes.length >> 2)));
      if (wanted > most) return 0;
      try {
        heap.memory?.grow(Math.ceil((most - heap.bytes.length) / PAGE));
      } catch {
        return 0;
      }
      heap.look();
      return 1;
    },
  };
}
