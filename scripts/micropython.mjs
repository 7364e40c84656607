// usage: node scripts/micropython.mjs OUT.wasm
// Packs MicroPython for programs of users: npm's build catches exceptions by going through JavaScript at nearly every
// call of its interpreter. Here WebAssembly's own exceptions replace that, which makes Python more than three times as fast
// (tests/programs/speed.mjs). The interpreter itself stays as it is.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";

const require = createRequire(import.meta.url);
const source = require.resolve("@micropython/micropython-webassembly-pyscript/micropython.wasm");
const out = path.resolve(process.argv[2] ?? "target/modules/micropython.wasm");
const kept = path.resolve("target/modules/micropython");
const binaryen = path.join(path.dirname(require.resolve("binaryen/package.json")), "bin");
// What the build uses, and exceptions; all browsers of this page have them.
const FEATURES = ["exception-handling", "bulk-memory", "bulk-memory-opt", "sign-ext", "mutable-globals", "nontrapping-float-to-int", "reference-types", "multivalue"].map((name) => `--enable-${name}`);

/** Emscripten's calls that may be jumped out of, as `invoke_` and the types of result and arguments (v: none, i: i32). */
function shim(module) {
  const signatures = WebAssembly.Module.imports(module).filter(({ name }) => name.startsWith("invoke_")).map(({ name }) => name.slice("invoke_".length));
  const calls = signatures.map((signature) => {
    const result = signature[0] === "i" ? "(result i32)" : "";
    const count = signature.length - 1;
    const types = count > 0 ? `(param ${"i32 ".repeat(count)})` : "";
    const args = Array.from({ length: count }, (_, index) => `(local.get ${index + 1})`).join(" ");
    return `(func (export "invoke_${signature}") (param $function i32) ${types} ${result} (local $stack i32)
      (local.set $stack (call $get_stack))
      (try ${result} (do (call_indirect ${types} ${result} ${args} (local.get $function)))
        (catch $jump (call $set_stack (local.get $stack)) (call $set_threw (i32.const 1) (i32.const 0)) ${result && "(i32.const 0)"})
        (catch_all (call $set_stack (local.get $stack)) (rethrow 0))))`;
  });
  return `(module
    (import "micropython" "__indirect_function_table" (table 1 funcref))
    (import "micropython" "emscripten_stack_get_current" (func $get_stack (result i32)))
    (import "micropython" "_emscripten_stack_restore" (func $set_stack (param i32)))
    (import "micropython" "setThrew" (func $set_threw (param i32 i32)))
    (tag $jump)
    (func (export "_emscripten_throw_longjmp") (throw $jump))
    ${calls.join("\n")})`;
}

/** Pages of 64 KB that the interpreter starts with: its own 16 MB would be copied with every key frame of a run. */
const PAGES = 20;

/** `wasm` with a memory that starts with PAGES. @param {Buffer} wasm */
function smaller(wasm) {
  const MEMORY_SECTION = 5;
  /** The number at `at` in LEB128, and where it ends. */
  const number = (at) => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      value |= (wasm[at] & 0x7f) << shift;
      if (wasm[at++] < 0x80) return [value, at];
    }
  };
  for (let at = 8; at < wasm.length; ) {
    const [length, start] = number(at + 1);
    if (wasm[at] === MEMORY_SECTION) {
      // One memory with a maximum.
      if (wasm[start] !== 1 || wasm[start + 1] !== 1) break;
      const [, maximum] = number(start + 2);
      const content = Buffer.concat([Buffer.from([1, 1, PAGES]), wasm.subarray(maximum, start + length)]);
      return Buffer.concat([wasm.subarray(0, at), Buffer.from([MEMORY_SECTION, content.length]), content, wasm.subarray(start + length)]);
    }
    at = start + length;
  }
  throw new Error("MicroPython's memory section isn't as expected");
}

const wasm = fs.readFileSync(source);
const digest = createHash("sha256").update(wasm).update(fs.readFileSync(new URL(import.meta.url))).digest("hex");
const packed = `${kept}-${digest.slice(0, 12)}.wasm`;
if (!fs.existsSync(packed)) {
  fs.mkdirSync(kept, { recursive: true });
  const file = (name) => path.join(kept, name);
  const run = (tool, ...args) => execFileSync(path.join(binaryen, tool), [...FEATURES, ...args]);
  fs.writeFileSync(file("shim.wat"), shim(new WebAssembly.Module(wasm)));
  run("wasm-as", file("shim.wat"), "-o", file("shim.wasm"));
  run("wasm-merge", source, "micropython", file("shim.wasm"), "env", "-o", file("merged.wasm"));
  run("wasm-opt", "-O3", file("merged.wasm"), "-o", file("packed.wasm"));
  fs.writeFileSync(packed, smaller(fs.readFileSync(file("packed.wasm"))));
}
fs.mkdirSync(path.dirname(out), { recursive: true });
fs.copyFileSync(packed, out);
