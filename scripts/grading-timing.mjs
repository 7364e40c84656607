// How long `robovac grade` takes for a class: 30 answers, 20 seeds, 20 simulated minutes in the furnished flat.
// usage: cargo build --release -p robovac-cli && node scripts/grading-timing.mjs [python|javascript|built-in] [ANSWERS]
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";

const root = path.resolve(import.meta.dirname, "..");
const [, , only, count = "30"] = process.argv;
const PLACE = "room=flat&robot=roomba600&slip=typical&noise=typical";
const LESSON = `# A class\n\n\`\`\`goal\nid: all\nin: ${PLACE}&behaviour=bounce\nchange: algorithm, program\nruns: 20\nminutes: 20\nneed: median coverage >= 1 %\n\`\`\`\n`;

const example = (name) => fs.readFileSync(path.join(root, "programs/examples", name), "utf8");
const program = (language, name) => ({ name: "Answer", language, kind: "behaviour", source: example(name) });
const ANSWERS = {
  python: [program("python", "follow_the_wall.py"), "behaviour=program"],
  javascript: [program("javascript", "follow_the_wall.js"), "behaviour=program"],
  "built-in": [undefined, "behaviour=bounce"],
};

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-class-"));
const lesson = path.join(folder, "lesson.md");
fs.writeFileSync(lesson, LESSON);
for (const [kind, [source, behaviour]] of Object.entries(ANSWERS)) {
  if (only && kind !== only) continue;
  const files = Array.from({ length: Number(count) }, (_, index) => {
    const file = path.join(folder, `${kind}-${index}.json`);
    const goal = { link: `${PLACE}&${behaviour}`, ...(source && { program: source }), runs: [] };
    fs.writeFileSync(file, JSON.stringify({ robovac_answer: 1, lesson: "a-class", name: `Learner ${index}`, goals: { all: goal } }));
    return file;
  });
  const began = performance.now();
  const { status, stdout, stderr } = spawnSync(path.join(root, "target/release/robovac"), ["grade", lesson, ...files, "--json"], { encoding: "utf8", maxBuffer: 1 << 30 });
  const seconds = (performance.now() - began) / 1000;
  if (status !== 0) throw new Error(stderr);
  const passed = JSON.parse(stdout).filter(({ goals }) => goals[0].verdict?.passed).length;
  console.log(`${kind}: ${count} answers graded in ${seconds.toFixed(1)} s on ${os.availableParallelism()} cores, ${passed} passed`);
}
fs.rmSync(folder, { recursive: true });
