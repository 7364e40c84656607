// How long a step of a program takes, without a simulator: readings recorded in the toy room, the best of 10 rounds.
// usage: node tests/programs/speed.mjs
import { ROOT, example, loaded } from "./files.mjs";
import { Toy } from "./toy.mjs";

const recorder = await loaded("javascript", example("turn_when_you_bump.js"));
const toy = new Toy();
const rows = Array.from({ length: 5000 }, () => {
  recorder.step(toy.readings);
  toy.step(recorder.left, recorder.right);
  return toy.readings.slice();
});

console.log("program                 language     traced   ns/step   real time");
for (const id of ["turn_when_you_bump", "follow_the_wall", "random_walk"]) {
  for (const language of ["python", "javascript"]) {
    for (const traced of [false, true]) {
      const program = await loaded(language, example(`${id}.${language === "python" ? "py" : "js"}`), { traced });
      let best = Infinity;
      for (let round = 0; round < 10; round++) {
        const begin = performance.now();
        for (const readings of rows) program.step(readings);
        best = Math.min(best, (performance.now() - begin) / rows.length);
      }
      console.log(id.padEnd(23), language.padEnd(12), String(traced).padEnd(6), (best * 1e6).toFixed(0).padStart(9), `${(15 / best).toFixed(0)} x`.padStart(11));
    }
  }
}
const begin = performance.now();
const program = await loaded("python", example("follow_the_wall.py"));
console.log(`loading a Python program: ${(performance.now() - begin).toFixed(1)} ms; its saved state: ${program.save().bytes / 1024} KB`);

// What scripts/micropython.mjs gains: the same loop in npm's MicroPython as it is, and packed.
const LOOP = `
class Robot:
    def __init__(self):
        self.bump = False
        self.time = 0
    def go(self, speed, rate=0):
        self.left = speed - rate
        self.right = speed + rate
robot = Robot()
until = 0
def step():
    global until
    robot.time += 0.015
    if robot.bump:
        robot.go(-0.1)
        until = robot.time + 0.5
    elif robot.time < until:
        robot.go(0, 90)
    else:
        robot.go(0.3)
def loop(count):
    for _ in range(count):
        step()
`;
const { loadMicroPython } = await import("@micropython/micropython-webassembly-pyscript/micropython.mjs");
const folder = `${ROOT}/node_modules/@micropython/micropython-webassembly-pyscript`;
const nanoseconds = [];
for (const url of [`${folder}/micropython.wasm`, `${ROOT}/target/modules/micropython.wasm`]) {
  const interpreter = await loadMicroPython({ url, heapsize: 1 << 20, pystack: 16384 });
  interpreter.runPython(LOOP);
  const loop = interpreter.globals.get("loop");
  let best = Infinity;
  for (let round = 0; round < 10; round++) {
    const start = performance.now();
    loop(20000);
    best = Math.min(best, (performance.now() - start) / 20000);
  }
  nanoseconds.push(best * 1e6);
}
console.log(`MicroPython as it is: ${nanoseconds[0].toFixed(0)} ns/step; packed: ${nanoseconds[1].toFixed(0)} ns/step`);
