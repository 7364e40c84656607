// @ts-check
// The answer file: settings and programs of the goals, the numbers of their runs, answers to quizzes, predictions.
import { download } from "../files.js";

/** Saves the answer; returns what the lesson asks for and the file hasn't. @param {import("./blocks.js").Context} context @param {string} name */
export function handIn({ app, lesson, done }, name) {
  const missing = [];
  const goals = Object.fromEntries(Object.entries(done.goals).map(([id, { passed: _, ...answer }]) => [id, answer]));
  for (const block of lesson.blocks) {
    if (block.kind === "quiz") {
      const right = new Set((done.quizzes[block.id]?.answers ?? []).filter(([, , isRight]) => isRight).map(([seed]) => seed)).size;
      if (right < block.rounds) missing.push(`the quiz "${block.id}" (right: ${right} of ${block.rounds})`);
    }
    if (block.kind !== "goal") continue;
    const known = goals[block.id];
    const program = known ? undefined : programOf(app, block);
    if (program) {
      goals[block.id] = { link: app.playground.link(), program, runs: [] };
      missing.push(`runs for the goal "${block.id}", which you haven't checked (your program is in it)`);
    } else if (!known) missing.push(`the goal "${block.id}", which you haven't checked`);
    else if (known.runs.length === 0) missing.push(`runs for the goal "${block.id}", as the check failed (your program is in it)`);
    else if (!done.goals[block.id]?.passed) missing.push(`an entry that reaches the goal "${block.id}"`);
  }
  /** @type {import("../types").Answer} */
  const answer = {
    robovac_answer: 1,
    lesson: lesson.id,
    lesson_digest: lesson.digest,
    name: name.trim(),
    goals,
    quizzes: Object.fromEntries(Object.entries(done.quizzes).map(([id, { answers }]) => [id, { answers: answers.map(([seed, text]) => /** @type {[number, string]} */ ([seed, text])) }])),
    predictions: done.predictions,
  };
  const file = [lesson.id, name.trim().toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-")].filter(Boolean).join("-");
  download(`${file}.json`, JSON.stringify(answer, null, 1), "application/json");
  return missing;
}

/** The program that drives now, if the goal can be reached by one. @param {import("../main.js").App} app @param {import("../types").Goal} goal */
function programOf({ playground }, { changes }) {
  return changes.includes("program") && playground.link_outline(playground.link()).has_program ? playground.program() : undefined;
}
