// What the tests of programs load: the package, MicroPython, the examples.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

export const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const python = path.join(ROOT, "programs/python");

const files = Object.fromEntries(fs.readdirSync(python, { recursive: true }).filter((name) => name.endsWith(".py")).map((name) => [name.replaceAll("\\", "/"), fs.readFileSync(path.join(python, name), "utf8")]));
const packed = path.join(ROOT, "target/modules/micropython.wasm");
execFileSync("node", ["scripts/micropython.mjs", packed], { cwd: ROOT });
export const MICROPYTHON = { wasm: await WebAssembly.compile(fs.readFileSync(packed)), files };

/** @param {string} name */
export const example = (name) => fs.readFileSync(path.join(ROOT, "programs/examples", name), "utf8");
