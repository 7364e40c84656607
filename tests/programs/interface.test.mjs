// programs/interface.json is what there is: in Python, in JavaScript and in docs/programs.md; its examples run.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { LAYOUT } from "../../programs/javascript/layout.js";
import { camel, makeRobot } from "../../programs/javascript/readings.js";
import { ROOT, example, loaded } from "./files.mjs";
import { FACTS, Toy } from "./toy.mjs";

const entries = JSON.parse(fs.readFileSync(path.join(ROOT, "programs/interface.json"), "utf8"));
const docs = fs.readFileSync(path.join(ROOT, "docs/programs.md"), "utf8");
const ofRobot = entries.filter(({ group }) => !["program", "room"].includes(group));

test("The list has all names of both robots, and no others", async () => {
  const robot = makeRobot(FACTS, 1, LAYOUT);
  const found = new Set();
  for (let of = robot; of && of !== Object.prototype && Object.getPrototypeOf(of); of = Object.getPrototypeOf(of)) {
    for (const name of Object.getOwnPropertyNames(of)) if (!name.startsWith("_") && name !== "constructor") found.add(name);
    if (Object.getPrototypeOf(of).constructor === undefined) break;
  }
  found.delete("blocked");
  assert.deepEqual(ofRobot.map(({ js }) => js).sort(), [...found].sort());
  const program = await loaded("python", "from robovac_program.robot import NAMES\nprint(' '.join(sorted(NAMES)))\ndef step(robot): pass\n");
  const names = program.output[0].text.split(" ").filter((name) => name !== "blocked");
  assert.deepEqual(ofRobot.map(({ name }) => name).sort(), names);
  for (const { name, js } of entries) assert.equal(js, camel(name));
});

test("The documentation has each of them", () => {
  for (const { name, js, kind, group, args, jsArgs, text } of entries.filter((entry) => entry.group !== "program")) {
    const of = group === "room" ? "room" : "robot";
    const call = (parameters) => (kind === "method" ? `(${parameters})` : "");
    const row = docs.split("\n").find((line) => line.startsWith(`| \`${of}.${name}${call(args)}\` | \`${of}.${js}${call(jsArgs)}\` |`));
    assert.ok(row, name);
    assert.ok(row.includes(text), `${name}: ${row}`);
  }
});

test("Every example runs in both languages", async () => {
  const room = { rows: ["..........", "..........", "..........", "..........", ".........."], cell: 0.12, start: [0, 0] };
  for (const { name, group, kind, example: { python, javascript } } of entries) {
    const indented = python.split("\n").map((line) => `    ${line}\n`).join("");
    const sources = kind === "function" && name !== "print" ? { python, javascript }
      : group === "room" ? { python: `def plan(room):\n${indented}    yield 0, 0\n`, javascript: `function* plan(room) {\n${javascript}\nyield [0, 0];\n}` }
      : { python: `def run(robot):\n${indented}    yield\n`, javascript: `function* run(robot) {\n${javascript}\nyield;\n}` };
    for (const [language, source] of Object.entries(sources)) {
      const program = await loaded(language, source);
      const toy = new Toy();
      if (program.kind === "plan") assert.ok([...program.plan(room)].length > 0, name);
      else for (let step = 0; step < 20 && program.step(toy.readings); step++) toy.step(program.left, program.right);
    }
  }
});

test("Examples are listed, say what they do, and are there in both languages", () => {
  const listed = JSON.parse(example("index.json")).map(({ id }) => id);
  const files = fs.readdirSync(path.join(ROOT, "programs/examples")).filter((name) => name !== "index.json").sort();
  assert.deepEqual(files, listed.flatMap((id) => [`${id}.js`, `${id}.py`]).sort());
  for (const file of files) assert.match(example(file), file.endsWith(".py") ? /^# [A-Z]/ : /^\/\/ [A-Z]/);
  for (const id of listed) assert.ok(docs.includes(`programs/examples/${id}.py`), id);
});

test("The programs of the documentation load", async () => {
  const blocks = [...docs.matchAll(/```(python|js)\n([^]*?)```/g)].filter(([, , text]) => /^(def|function|from|import|async|const|let|[a-z_]+ = )/m.test(text) && /(def|function\*?) (step|run|plan)\b|robot\.play\(\)/.test(text));
  assert.ok(blocks.length >= 6);
  for (const [, language, text] of blocks) await loaded(language === "python" ? "python" : "javascript", text);
});
