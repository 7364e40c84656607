// The same program gives the same commands in CPython, MicroPython and JavaScript, in the page and in a process.
import assert from "node:assert/strict";
import { test } from "node:test";
import { answers, example, loaded, message } from "./files.mjs";
import { Toy } from "./toy.mjs";

const STEPS = 3000;
const examples = JSON.parse(example("index.json"));
const ROOM = { rows: ["..........", "..##......", "..##..#...", "......#...", ".........."], cell: 0.12, start: [0, 0] };

/** A run in the toy room: readings and commands of each step. */
async function recorded(program, most = STEPS) {
  const toy = new Toy();
  const steps = [];
  for (let goesOn = true; goesOn && steps.length < most; ) {
    const readings = toy.readings.slice();
    goesOn = program.step(readings);
    steps.push({ readings, left: program.left, right: program.right, print: program.output.filter(({ kind }) => kind === "print").map(({ text }) => text), done: !goesOn });
    program.output.length = 0;
    toy.step(program.left, program.right);
  }
  return { steps, coverage: toy.coverage() };
}

for (const { id, kind } of examples.filter((one) => one.kind !== "plan")) {
  test(`${id}: same commands everywhere`, async () => {
    const sources = { python: example(`${id}.py`), javascript: example(`${id}.js`) };
    const program = await loaded("javascript", sources.javascript);
    assert.equal(program.kind, kind);
    const { steps } = await recorded(program);
    const inPython = await loaded("python", sources.python);
    const lines = steps.map(({ readings }) => message(readings));
    const outside = ["python", "javascript"].map((language) => answers(language, sources[language], lines));
    for (const [ready] of outside) assert.deepEqual(ready, { ready: "behaviour" });
    steps.forEach(({ readings, left, right, print, done }, step) => {
      const goesOn = inPython.step(readings);
      const expected = { left, right, print, done };
      assert.deepEqual({ left: inPython.left, right: inPython.right, print: inPython.output.filter((one) => one.kind === "print").map(({ text }) => text), done: !goesOn }, expected, `MicroPython, step ${step}`);
      inPython.output.length = 0;
      for (const [index, name] of ["CPython", "node"].entries()) {
        const { left: l, right: r, print: p = [], done: d = false } = outside[index][step + 1];
        assert.deepEqual({ left: l, right: r, print: p, done: d }, expected, `${name}, step ${step}`);
      }
    });
  });
}

test("A planner gives the same cells everywhere, all of them, each beside the last", async () => {
  const cells = [...(await loaded("javascript", example("plan_in_rows.js"))).plan(ROOM)];
  assert.deepEqual([...(await loaded("python", example("plan_in_rows.py"))).plan(ROOM)], cells);
  for (const language of ["python", "javascript"]) {
    const [ready, ...parts] = answers(language, example(language === "python" ? "plan_in_rows.py" : "plan_in_rows.js"), [{ room: ROOM }]);
    assert.deepEqual(ready, { ready: "planner" });
    assert.deepEqual(parts.pop(), { done: true });
    assert.deepEqual(parts.flatMap((part) => part.cells), cells);
  }
  const free = ROOM.rows.join("").split(".").length - 1;
  assert.equal(new Set(cells.map(String)).size, free);
  cells.slice(1).forEach(([x, y], index) => assert.equal(Math.abs(x - cells[index][0]) + Math.abs(y - cells[index][1]), 1));
});

test("Examples that clean do clean", async () => {
  // Shares of the toy room after 7.5 minutes; follow_the_wall keeps to the walls.
  const least = { turn_when_you_bump: 0.9, random_walk: 0.8, spiral_then_bounce: 0.65, lanes: 0.8, a_map_of_its_own: 0.7 };
  for (const [id, share] of Object.entries(least)) {
    const { coverage } = await recorded(await loaded("javascript", example(`${id}.js`)), 30000);
    assert.ok(coverage >= share, `${id}: ${coverage}`);
  }
});

test("Chance, rounding and limits are the same", async () => {
  const python = "def step(robot):\n    robot.drive(robot.random() * 2 - 1, robot.choice([-0.0005, 0.0005, 0.1235, 9, -9]))\n    print(robot.randint(1, 6))\n";
  const javascript = "function step(robot) {\n  robot.drive(robot.random() * 2 - 1, robot.choice([-0.0005, 0.0005, 0.1235, 9, -9]));\n  print(robot.randint(1, 6));\n}\n";
  for (const seed of [0, 1, 2 ** 32 - 1, 2 ** 53 - 1]) {
    const programs = [await loaded("python", python, { seed }), await loaded("javascript", javascript, { seed })];
    const { readings } = new Toy();
    const rights = new Set();
    for (let step = 0; step < 300; step++) {
      for (const program of programs) program.step(readings);
      const [a, b] = programs.map(({ left, right, output }) => [left, right, output.pop().text]);
      assert.deepEqual(a, b);
      rights.add(a[1]);
    }
    assert.deepEqual([...rights].sort((a, b) => a - b), [-500, -1, 1, 124, 500]);
  }
});
