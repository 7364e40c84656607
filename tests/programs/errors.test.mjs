// Mistakes in programs are told with their line and a mend; what never ends or takes too much is ended.
import assert from "node:assert/strict";
import { test } from "node:test";
import { answers, loaded, message } from "./files.mjs";
import { Toy } from "./toy.mjs";

/** [language, program, line, what the message says, options] */
const MISTAKES = [
  ["python", "def step(robot):\n    robot.forwrd(1)\n", 2, /robot\.forwrd: there is no such name; did you mean forward\?/],
  ["javascript", "function step(robot) {\n  robot.forwrd(1);\n}", 2, /robot\.forwrd: there is no such name; did you mean forward\?/],
  ["python", "def step(robot):\n    if robot.bumpLeft: pass\n", 2, /did you mean bump_left\?/],
  ["javascript", "function step(robot) {\n  if (robot.bump_left) robot.stop();\n}", 2, /did you mean bumpLeft\?/],
  ["python", "def step(robot):\n    robot.drive(0.1, 'fast')\n", 2, /robot\.drive: right must be a number, not 'fast'/],
  ["javascript", "function step(robot) {\n  robot.drive(0.1, 'fast');\n}", 2, /robot\.drive: right must be a number, not "fast"/],
  ["python", "def step(robot):\n    if (robot.bump:\n        pass\n", 2, /SyntaxError/],
  ["javascript", "function step(robot) {\n  if (robot.bump {\n}", 2, /SyntaxError/],
  ["python", "x = 1\ndef stp(robot): pass\n", undefined, /did you mean step instead of stp\?/],
  ["javascript", "function stp(robot) {}", undefined, /did you mean step instead of stp\?/],
  ["python", "def step(robot): pass\ndef run(robot): yield\n", undefined, /there are step and run: a program has one of them/],
  ["javascript", "function step() {}\nfunction* run() {}", undefined, /there are step and run: a program has one of them/],
  ["python", "def step(robot):\n    robot.forward(1)\n", 2, /robot\.forward takes time, so it needs def run/],
  ["javascript", "function step(robot) {\n  robot.forward(1);\n}", 2, /robot\.forward takes time, so it needs function\* run/],
  ["python", "def run(robot):\n    robot.forward(1)\n    yield robot.turn(9)\n", 2, /robot\.forward\(\.\.\.\) does nothing without yield/],
  ["javascript", "function* run(robot) {\n  robot.forward(1);\n  yield robot.turn(9);\n}", 2, /robot\.forward\(\.\.\.\) does nothing without yield/],
  ["python", "def run(robot):\n    yield 3\n", 2, /yield takes a motion such as/],
  ["javascript", "function* run(robot) {\n  yield 3;\n}", undefined, /yield takes a motion such as/],
  ["python", "def step(robot):\n    x = 1 / 0\n", 2, /ZeroDivisionError/],
  ["javascript", "function step(robot) {\n  nothing.here;\n}", 2, /ReferenceError: nothing is not defined/],
  ["javascript", "function step(robot) {\n  robot.x = 1;\n}", 2, /robot\.x is measured: a program can't set it/],
  ["javascript", "function step(robot) {\n  robot.drive(0 / 0, 1);\n}", undefined, /not a number/],
  ["python", "def step(robot)\n    robot.stop()\n", 1, /SyntaxError: a colon \(:\) is missing/],
  ["python", "def step(robot):\n    if robot.bump:\n    robot.stop()\n", 3, /must be indented/],
  ["python", "def step(robot):\n    if robot.bump:\n        robot.stop()\n      robot.stop()\n", 4, /fits none of the lines above/],
  ["python", "def step(robot):\n    robot.stop()\n      robot.stop()\n", 3, /indented more than the one before/],
  ["python", "def step(robot):\n    robot.go(0.2\n    robot.stop()\n", 2, /a bracket isn't closed/],
  ["python", "def step(robot):\n    if robot.time = 3: pass\n", 2, /to compare, write ==/],
  ["python", "def step(robot):\n    if robot.bump && robot.cliff: pass\n", 2, /Python writes "and"/],
  ["python", "def step(robot):\n    if bump: pass\n", 2, /did you mean robot\.bump\?/],
  ["python", "def step(robot):\n    x = sin(1)\n", 2, /write import math in the first line/],
  ["python", "robot.go(0.2)\ndef step(robot):\n    pass\n", 1, /robot' isn't defined; it is known inside def step\(robot\)/],
  ["python", "def step(robot):\n    x = true\n", 2, /did you mean True\?/],
  ["python", "def step():\n    pass\n", 1, /write def step\(robot\):/],
  ["python", "def step(robot):\n    if robot.bump(): pass\n", 2, /robot\.bump is a reading, no function/],
  ["python", "n = 0\ndef step(robot):\n    n += 1\n", 3, /Write global n as its first line/],
  ["python", "def step(robot):\n    robot.left_speed = 1\n", 2, /robot\.left_speed is measured: a program can't set it/],
  ["python", "def step(robot):\n    robot.go()\n", 2, /robot\.go takes at least 1 value/],
  ["python", "def step(robot):\n    robot.stop\n", 2, /does nothing without parentheses/],
  ["python", "def f():\n    return f()\ndef step(robot):\n    f()\n", 2, /calls itself without end/],
  ["javascript", "function f() {\n  return f() + 1;\n}\nfunction step(robot) {\n  f();\n}", 2, /calls itself without end/],
  ["python", "def step(robot):\n    print('x' * 30000)\n", undefined, /more than 20000 characters/],
  ["javascript", "function step(robot) {\n  print('x'.repeat(30000));\n}", 2, /more than 20000 characters/],
  ["python", "def step(robot):\n    while True: robot.mark(0, 0)\n", 2, /more than 2000 marks/],
  ["javascript", "function step(robot) {\n  while (true) robot.mark(0, 0);\n}", 2, /more than 2000 marks/],
  ["python", "kept = []\ndef step(robot):\n    while True: kept.append(bytearray(100000))\n", 3, /needs more memory/, { memory: 8 }],
];
const ENDLESS = [
  ["python", "def step(robot):\n    while True: pass\n", 2],
  ["python", "def step(robot):\n    while (True or\n            False):\n        x = 1\n", 4],
  ["python", "def step(robot):\n    while True:\n        try:\n            x = 1\n        except:\n            pass\n", 4],
  ["python", "x = 1\nwhile x:\n    x = x\n", 3],
  ["javascript", "function step(robot) {\n  while (true);\n}", 2],
  ["javascript", "function step(robot) {\n  for (;;) robot.stop();\n}", 2],
  ["javascript", "function step(robot) {\n  do {\n    robot.stop();\n  } while (robot.time >= 0);\n}", 3],
];

/** The error of a program in its first 100 steps. */
async function mistake(language, source, options) {
  try {
    const program = await loaded(language, source, options);
    const toy = new Toy();
    for (let step = 0; step < 100; step++) program.step(toy.readings);
  } catch (error) {
    return error;
  }
  return undefined;
}

test("Mistakes are told with their line and a mend", async () => {
  for (const [language, source, line, words, options] of MISTAKES) {
    const error = await mistake(language, source, options);
    assert.match(error?.message ?? "no error", words, source);
    assert.equal(error.name, "SourceError", source);
    assert.equal(error.line, line, source);
  }
});

test("Lines are the program's own when it is traced", async () => {
  for (const [language, source, line, words] of MISTAKES.filter((one) => one[2] && !one[4])) {
    const error = await mistake(language, source, { traced: true });
    assert.match(error?.message ?? "no error", words, source);
    assert.equal(error.line, line, source);
  }
});

test("A step that never ends is named by a line of its loop", async () => {
  for (const [language, source, line] of ENDLESS) {
    const error = await mistake(language, source, { traced: true, budget: 20000 });
    assert.match(error?.message ?? "no error", /never ends|never starts/, source);
    assert.ok(Math.abs(error.line - line) <= 1, `${source}: line ${error.line}`);
  }
});

test("A program in a process answers with its error and stops", () => {
  const lines = [message(new Toy().readings)];
  for (const [language, source, line, words] of MISTAKES.filter((one) => one[2] && !one[4]).slice(0, 6)) {
    const last = answers(language, source, lines).pop();
    assert.match(last.error, words);
    if (language === "python" || !/SyntaxError/.test(last.error)) assert.equal(last.line, line, source);
  }
});
