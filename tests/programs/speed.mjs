// How long a step of a program takes, without a simulator: readings recorded in the toy room, the best of 10 rounds.
// usage: node tests/programs/speed.mjs
import { example, loaded } from "./files.mjs";
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
