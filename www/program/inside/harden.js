// @ts-check
// Takes away what programs have no use for, before any of their code runs. The frame's policy forbids the rest: this is the
// second wall, and keeps the messages of the worker its own.

/** What is left: the language itself, and what text and WebAssembly need. */
const KEPT = new Set(
  `globalThis self Object Function Array Number parseFloat parseInt Infinity NaN undefined Boolean String Symbol Date Promise RegExp Error AggregateError
  EvalError RangeError ReferenceError SyntaxError TypeError URIError JSON Math Intl ArrayBuffer Uint8Array Int8Array Uint16Array Int16Array Uint32Array
  Int32Array Float32Array Float64Array Uint8ClampedArray BigUint64Array BigInt64Array Float16Array DataView Map BigInt Set Iterator WeakMap WeakSet WeakRef
  FinalizationRegistry Proxy Reflect decodeURI decodeURIComponent encodeURI encodeURIComponent escape unescape isFinite isNaN console WebAssembly eval
  TextDecoder TextEncoder structuredClone DisposableStack SuppressedError`.split(/\s+/),
);

/** Removes everything else from the global object and what it inherits from. */
export function harden() {
  for (let owner = /** @type {object | null} */ (globalThis); owner && owner !== Object.prototype; owner = Object.getPrototypeOf(owner)) {
    for (const name of Reflect.ownKeys(owner)) {
      if (typeof name === "string" && KEPT.has(name)) continue;
      if (Reflect.deleteProperty(owner, name)) continue;
      try {
        Object.defineProperty(owner, name, { value: undefined, writable: false });
      } catch {
        // Some engines keep a few names, such as `constructor`'s own; none of them leads out.
      }
    }
  }
}
