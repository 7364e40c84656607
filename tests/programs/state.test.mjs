// A program's state: kept and restored, its variables, the line it is in, breakpoints.
import assert from "node:assert/strict";
import { test } from "node:test";
import { example, loaded } from "./files.mjs";
import { Toy } from "./toy.mjs";

const OWN = "def step(robot):\n    robot.count = robot.count + 1 if robot.time > 0 else 0\n    robot.another = [robot.count]\n    robot.drive(robot.count % 100 / 1000, 0.1 if robot.bump else 0.2)\n";

test("A Python program goes on from where it was saved", async () => {
  for (const source of [example("turn_when_you_bump.py"), example("random_walk.py"), example("a_map_of_its_own.py"), OWN]) {
    const program = await loaded("python", source);
    const toy = new Toy();
    const readings = [];
    const commands = [];
    let state;
    for (let step = 0; step < 4000; step++) {
      if (step === 2000) state = program.save();
      readings.push(toy.readings.slice());
      program.step(readings[step]);
      commands.push([program.left, program.right]);
      program.output.length = 0;
      toy.step(program.left, program.right);
    }
    assert.ok(state.bytes < 300_000, `${state.bytes} bytes`);
    for (let time = 0; time < 2; time++) {
      program.restore(state);
      for (let step = 2000; step < 4000; step++) {
        program.step(readings[step]);
        assert.deepEqual([program.left, program.right], commands[step], `step ${step}`);
      }
    }
  }
});

test("An endless step leaves what was saved before as it was", async () => {
  const program = await loaded("python", "n = 0\ndef step(robot):\n    global n\n    n += 1\n    while robot.bump: pass\n    robot.drive(n / 1000, 0)\n", { traced: true, budget: 1000 });
  const toy = new Toy();
  for (let step = 0; step < 5; step++) program.step(toy.readings);
  const state = program.save();
  toy.touch = [true, true];
  toy.sense();
  assert.throws(() => program.step(toy.readings), /never ends/);
  program.restore(state);
  assert.equal(program.left, 5);
  toy.touch = [false, false];
  toy.sense();
  program.step(toy.readings);
  assert.equal(program.left, 6);
});

const PROGRAMS = {
  python: "a = 1\nb = {'x': [1, 2]}\ndef step(robot, z=3):\n    global a\n    c = a + 1\n    if c > 1: a += 1\n    else: a -= 1\n    return\n",
  javascript: "let a = 1;\nconst b = { x: [1, 2] };\nfunction step(robot, z = 3) {\n  // next\n  const c = a + 1;\n  if (c > 1) a++;\n  else a--;\n  return;\n}",
};

for (const language of ["python", "javascript"]) {
  test(`Variables, lines and breakpoints: ${language}`, async () => {
    const program = await loaded(language, PROGRAMS[language], { traced: true, breakpoints: [{ line: 6, condition: language === "python" ? "a == 3" : "a === 3" }] });
    const { readings } = new Toy();
    const stops = [];
    for (let step = 0; step < 10; step++) {
      program.step(readings);
      stops.push(...program.output.splice(0).map(({ kind, line, variables }) => ({ kind, line, a: variables.find(([name]) => name === "a")[1], step })));
    }
    assert.deepEqual(stops, [{ kind: "break", line: 6, a: "3", step: 2 }]);
    assert.equal(program.line, 8);
    const shown = Object.fromEntries(program.variables().map(([name, text]) => [name, text]));
    assert.deepEqual(Object.keys(shown).sort(), ["a", "b", "c", "z"]);
    assert.equal(shown.a, "11");
    assert.match(shown.b, /x.*1, ?2/);
    assert.equal(shown.c, "11");
  });
}

test("Tracing changes no command", async () => {
  for (const { id, kind } of JSON.parse(example("index.json")).filter((one) => one.kind !== "plan")) {
    for (const language of ["python", "javascript"]) {
      const source = example(`${id}.${language === "python" ? "py" : "js"}`);
      const [plain, traced] = [await loaded(language, source), await loaded(language, source, { traced: true, budget: 100000 })];
      const toy = new Toy();
      for (let step = 0; step < 800; step++) {
        const goesOn = [plain.step(toy.readings), traced.step(toy.readings)];
        assert.equal(goesOn[0], goesOn[1]);
        if (!goesOn[0]) break;
        assert.deepEqual([traced.left, traced.right], [plain.left, plain.right], `${id}, ${language}, step ${step}`);
        assert.ok(traced.line > 0);
        toy.step(plain.left, plain.right);
      }
    }
  }
});

test("Clocks and chance of the languages are the run's", async () => {
  const sources = {
    python: "import random, time\ndef step(robot):\n    print(random.random(), time.ticks_ms() == int(robot.time * 1000))\n",
    javascript: "function step(robot) {\n  print(Math.random(), Date.now() === robot.time * 1000 && new Date().getTime() === Math.trunc(Date.now()) && performance.now() === Date.now());\n}",
  };
  for (const [language, source] of Object.entries(sources)) {
    const said = [];
    for (const seed of [1, 1, 2]) {
      const program = await loaded(language, source, { seed });
      const toy = new Toy();
      for (let step = 0; step < 5; step++) {
        program.step(toy.readings);
        toy.step(100, 100);
      }
      said.push(program.output.map(({ text }) => text));
    }
    assert.deepEqual(said[0], said[1]);
    assert.notDeepEqual(said[0], said[2]);
    assert.ok(said[0].every((text) => /true$/i.test(text)), said[0].join());
  }
});

test("Python programs reach neither JavaScript nor files", async () => {
  for (const source of ["import js\nprint(js.fetch)\n", "import js\njs.fetch('x')\n", "open('/etc/passwd')\n", "open('/lib/x', 'w')\n", "import os\nos.mkdir('/x')\n", "from js import globalThis\n"]) {
    await assert.rejects(loaded("python", `${source}def step(robot): pass\n`), { name: "SourceError" }, source);
  }
});
