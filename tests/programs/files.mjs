// What the tests of programs share: the package, MicroPython, the examples, and programs in processes of their own.
import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { parser } from "@lezer/javascript";
import { LAYOUT } from "../../programs/javascript/layout.js";
import { load } from "../../programs/javascript/runtime.js";
import { FACTS } from "./toy.mjs";

export const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const python = path.join(ROOT, "programs/python");

const files = Object.fromEntries(fs.readdirSync(python, { recursive: true }).filter((name) => name.endsWith(".py")).map((name) => [name.replaceAll("\\", "/"), fs.readFileSync(path.join(python, name), "utf8")]));
const packed = path.join(ROOT, "target/modules/micropython.wasm");
execFileSync("node", ["scripts/micropython.mjs", packed], { cwd: ROOT });
export const MICROPYTHON = { wasm: await WebAssembly.compile(fs.readFileSync(packed)), files };

/** @param {string} name */
export const example = (name) => fs.readFileSync(path.join(ROOT, "programs/examples", name), "utf8");

/** The program, loaded as the page does. */
export const loaded = (language, source, options = {}) => load({ language, source, facts: FACTS, seed: 7, layout: LAYOUT, micropython: MICROPYTHON, parser, ...options });

/** Readings as the protocol sends them. */
export function message(readings) {
  const value = (number, flag) => (flag ? number !== 0 : number);
  return Object.fromEntries(LAYOUT.slots.map(({ name, index, count, flag }) => [name, count > 1 ? Array.from(readings.subarray(index, index + count), (number) => value(number, flag)) : value(readings[index], flag)]));
}

const HELLO = { robovac: 1, kind: "hello", robot: FACTS, dt: 0.015, seed: 7 };

/** Answers of a program in a process of its own to these lines, behind the greeting. */
export function answers(language, source, lines) {
  const file = path.join(ROOT, "target", `program-${process.pid}.${language === "python" ? "py" : "js"}`);
  fs.writeFileSync(file, source);
  const [command, ...words] = language === "python" ? ["python3", "-B", "-m", "robovac_program"] : ["node", path.join(ROOT, "programs/javascript/node.js")];
  const input = [HELLO, ...lines].map((line) => JSON.stringify(line)).join("\n");
  const { stdout, stderr } = spawnSync(command, [...words, file], { input: `${input}\n`, encoding: "utf8", maxBuffer: 1 << 28, env: { ...process.env, PYTHONPATH: python } });
  fs.rmSync(file);
  if (stderr) throw new Error(stderr);
  return stdout.trim().split("\n").map((line) => JSON.parse(line));
}
