// @ts-check
// Takes away what programs have no use for, before any of their code runs. The frame's policy forbids the rest: this is the
// second wall, and keeps the messages of the worker its own.

/** What is left: the language itself, and what text and WebAssembly need. */
const KEPT = new Set(
  `globalThis self Object Array Number parseFloat parseInt Infinity NaN undefined Boolean String Symbol Date Promise RegExp Error AggregateError
  EvalError RangeError ReferenceError SyntaxError TypeError URIError JSON Math Intl ArrayBuffer Uint8Array Int8Array Uint16Array Int16Array Uint32Array
  Int32Array Float32Array Float64Array Uint8ClampedArray BigUint64Array BigInt64Array Float16Array DataView Map BigInt Set Iterator WeakMap WeakSet WeakRef
  FinalizationRegistry Proxy Reflect decodeURI decodeURIComponent encodeURI encodeURIComponent escape unescape isFinite isNaN console WebAssembly
  TextDecoder TextEncoder structuredClone DisposableStack SuppressedError`.split(/\s+/),
);

/**
 * Removes everything else from the global object and what it inherits from, and every way to make code from text but one.
 * @returns {() => void} Lets the next text be evaluated, once: the loader's.
 */
export function harden() {
  const evaluate = globalThis.eval;
  let isAllowed = false;
  const once = (/** @type {string} */ text) => {
    if (!isAllowed) throw new TypeError("Programs can't make code from text.");
    isAllowed = false;
    return evaluate(text);
  };
  const makers = [function () {}, async function () {}, function* () {}, async function* () {}];
  for (const maker of makers) Object.defineProperty(Object.getPrototypeOf(maker), "constructor", { value: undefined, writable: false, configurable: false });
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
  Object.defineProperty(globalThis, "eval", { value: once, writable: false, configurable: false });
  return () => void (isAllowed = true);
}
