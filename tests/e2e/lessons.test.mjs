// Every lesson is gone through as learners do: first with wrong answers, then with right ones.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { openApp } from "./app.mjs";
import { ROOT } from "./harness.mjs";
import { rightAnswer } from "./quizzes.mjs";

/** Runs of a goal or a row; native tests make more, and all of them. */
const RUNS = 1;
/** Programs in Python drive for minutes of a busy machine. */
const PATIENCE_MS = 120_000;

/** A lesson with tables of one row, of a simulated minute: enough for a number. Goals keep their minutes. */
const shortened = (text) =>
  text
    .replace(/^```measure\n[^]*?^```/gm, (table) => table.replace(/^minutes: .*$/m, "minutes: 1").replace(/(^row: .*\n)(row: .*\n)*/m, "$1"))
    .replace(/^runs: \d+$/gm, `runs: ${RUNS}`);

const read = (file) => fs.readFileSync(path.join(ROOT, "lessons", file), "utf8");

/** The blocks of a kind in a lesson: the word behind it, and its lines by their keys; an indented line continues the one above. */
const blocks = (text, kind) =>
  [...text.matchAll(/^```(\w+)(?: (\S+))?\n([^]*?)^```/gm)]
    .filter(([, name]) => name === kind)
    .map(([, , rest, body]) => {
      const lines = body.replace(/\n +/g, " ").matchAll(/^([\w ]+): (.*)$/gm);
      return { rest, body, lines: Object.fromEntries([...lines].map(([, key, value]) => [key, value])) };
    });

const LESSONS = JSON.parse(read("index.json")).map(({ file, ...entry }) => {
  const text = read(file);
  const kinds = Object.fromEntries(["predict", "do", "measure", "goal", "hint", "quiz", "code", "scene"].map((kind) => [kind, blocks(text, kind)]));
  return { ...entry, kinds, answer: JSON.parse(read(`answers/${file.replace(".md", ".json")}`)) };
});

/** A program in the text of a link. */
const packed = (program) => deflateRawSync(JSON.stringify(program)).toString("base64url");

/** What a learner does in a lesson that is open. */
class Learner {
  constructor(page, app) {
    Object.assign(this, { page, app, panel: page.locator("#learn") });
  }

  press(name) {
    return this.panel.getByRole("button", { name, exact: true }).click();
  }

  async open({ title }) {
    if (await this.panel.getByRole("button", { name: "All lessons" }).isVisible()) await this.press("All lessons");
    await this.panel.locator(".lessons button", { hasText: title }).click();
    await this.panel.getByRole("heading", { name: title, exact: true }).waitFor();
  }

  /** Commits each prediction, right or wrong, and reads how it went. */
  async predict({ kinds }, isRight) {
    const parts = this.panel.getByRole("group", { name: "Predict" });
    assert.equal(await parts.count(), kinds.predict.length);
    for (const [index, { lines }] of kinds.predict.entries()) {
      const part = parts.nth(index);
      if (!isRight) {
        await part.getByRole("button", { name: "Commit" }).click();
        await part.getByText("Choose one first").waitFor();
      }
      const right = Number(lines.answer) - 1;
      await part.getByRole("radio").nth(isRight ? right : (right + 1) % 2).check();
      await part.getByRole("button", { name: "Commit" }).click();
      await part.getByRole("button", { name: "Compare with what happened" }).click();
      await part.getByText(isRight ? "As you predicted." : "Not as you predicted. The right answer is").waitFor();
    }
  }

  /** Answers one question of each quiz wrong, or as many right as it asks for. */
  async quiz({ kinds }, isRight) {
    const parts = this.panel.getByRole("region", { name: "Quiz" });
    assert.equal(await parts.count(), kinds.quiz.length);
    for (const [index, { rest, lines }] of kinds.quiz.entries()) {
      const part = parts.nth(index);
      for (let round = 1; round <= (isRight ? Number(lines.rounds) : 1); round++) {
        const picture = part.getByRole("img");
        const right = rightAnswer(await part.locator("p").nth(1).innerText(), (await picture.count()) > 0 && (await picture.getAttribute("aria-label")));
        const options = part.locator("form button:enabled");
        if ((await part.getByRole("textbox").count()) > 0) {
          await part.getByRole("textbox").fill(isRight ? right : rest === "bytes" ? "1 2 3" : "-4711");
          await part.getByRole("button", { name: "Answer" }).click();
        } else await options.filter({ [isRight ? "hasText" : "hasNotText"]: right }).filter({ visible: true }).first().click();
        await part.locator(".outcome").getByText(isRight ? "Right." : "Not so.").waitFor();
        await part.getByText(`Right: ${isRight ? round : 0} of ${lines.rounds}`).waitFor();
        if (isRight && round === Number(lines.rounds)) await part.getByText("done. You can go on for practice").waitFor();
        else await part.getByRole("button", { name: "Next question" }).click();
      }
    }
  }

  /** Hints open one by one, and are there after that. */
  async hints({ kinds }) {
    const hints = this.panel.locator("details.hint");
    assert.equal(await hints.count(), kinds.hint.length);
    for (let index = 0; index < kinds.hint.length; index++) {
      assert.equal(await hints.nth(index).getAttribute("open"), null, "a hint is closed until it is asked for");
      await hints.nth(index).locator("summary").click();
      await hints.nth(index).locator(".prose").waitFor();
    }
  }

  /** Each button that sets the page, and what is there then. */
  async tryAll({ kinds }) {
    for (const { lines } of [...kinds.scene, ...kinds.do]) {
      const wanted = new URLSearchParams(lines.link);
      await this.press(lines.label ? `▶ ${lines.label}` : lines.title);
      // Addresses leave defaults out.
      for (const key of ["tab", "room", "planner", "behaviour", "view"]) {
        if (wanted.has(key)) await this.app.linked(key, (value) => value === wanted.get(key));
      }
      if (!wanted.has("tab")) {
        // The film of a search is shown before the run.
        if (wanted.has("search")) await this.page.waitForFunction(() => !document.getElementById("film").hidden || /playing|finished/.test(document.body.dataset.state));
        else await this.app.until(...(lines.label ? ["playing", "finished"] : ["ready", "paused"]));
      }
      assert.equal(await this.app.message(), "", lines.link);
    }
    await this.rest();
  }

  /** Pauses the run on the floor, if there is one: painting it would be most of what this test costs. */
  rest() {
    return this.page.evaluate(() => document.body.dataset.state === "playing" && document.getElementById("play")?.click());
  }

  /** Each table fills. */
  async measure({ kinds }) {
    for (let index = 0; index < kinds.measure.length; index++) {
      const part = this.panel.locator(".measure").nth(index);
      await part.getByRole("button", { name: "Measure", exact: true }).click();
      await this.app.poll(() => part.locator("tbody td").allTextContents(), (cells) => cells.some((cell) => /^[\d.]+$/.test(cell)), "a number in the table");
    }
  }

  /** Checks what the page is set to, and waits for the verdict. */
  async check(goal, verdict) {
    await goal.getByRole("button", { name: /^Check my/ }).click();
    await goal.locator(".outcome b").waitFor();
    assert.equal(await goal.locator(".outcome b").innerText(), verdict, await goal.locator(".outcome").innerText());
  }

  /** What a lesson starts from misses its goal; its answer reaches it. */
  async goal({ id, kinds, answer }, isRight) {
    const goal = this.panel.getByRole("region", { name: "Goal" });
    assert.equal(await goal.count(), kinds.goal.length);
    for (const { lines } of kinds.goal) {
      const byProgram = lines.change === "program";
      const given = answer.goals[lines.id];
      if (!byProgram) {
        if (isRight) await this.page.evaluate((link) => (location.hash = link), `${given.link}&lesson=${id}`);
        else await goal.getByRole("button", { name: "Set up the task" }).click();
      } else if (isRight) {
        await this.page.evaluate((link) => (location.hash = link), `${given.link.replace("&behaviour=program", "")}&tab=program&code=${packed(given.program)}&lesson=${id}`);
      } else {
        await goal.getByRole("button", { name: "Check my program" }).click();
        await goal.getByText("No program drives the robot yet").waitFor();
        await goal.getByRole("button", { name: "Set up the task" }).click();
        await this.press("Open in Program");
      }
      await this.app.settled();
      if (byProgram) {
        // A program of the page comes without a warning, one by a link with it.
        await this.page.locator("#program-foreign").waitFor({ state: isRight ? "visible" : "hidden" });
        const source = isRight ? given.program.source : kinds.code[0].body;
        await this.page.waitForFunction((text) => [...document.querySelectorAll(".cm-line")].slice(0, 5).map((line) => line.textContent).join("\n") === text, source.split("\n", 5).join("\n"));
        await this.page.locator("#program-run").click();
        // The program before it may still drive until then.
        await this.page.locator("#program-status").filter({ hasText: /^(Change a number|Ends at)/ }).waitFor();
        await this.app.linked("behaviour", (value) => value === "program");
        assert.equal((await this.app.link()).room, new URLSearchParams(lines.in).get("room"));
      }
      await this.rest();
      await this.check(goal, isRight ? "Goal reached." : "Not yet.");
    }
  }
}

// slow: a run of what every lesson starts from, and one of its answer, as long as its goal says; and many clicks
test("every lesson takes wrong and right answers, and its goal is missed by what it starts from and reached by its answer", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&behaviour=bounce" });
  page.setDefaultTimeout(PATIENCE_MS);
  await page.route("**/lessons/*.md", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: shortened(await response.text()) });
  });
  const learner = new Learner(page, app);
  await learner.rest();
  await page.getByRole("button", { name: "Learn", exact: true }).click();
  for (const lesson of LESSONS) {
    await learner.open(lesson);
    await learner.predict(lesson, false);
    await learner.quiz(lesson, false);
    await learner.tryAll(lesson);
    await learner.measure(lesson);
    await learner.goal(lesson, false);
    await learner.hints(lesson);
  }
  await learner.press("All lessons");
  await learner.press("Clear progress");
  await learner.press("Clear it for good");
  for (const lesson of LESSONS) {
    await learner.open(lesson);
    await learner.predict(lesson, true);
    await learner.quiz(lesson, true);
    await learner.goal(lesson, true);
  }
  await learner.press("All lessons");
  assert.deepEqual(await page.locator("#learn .lessons .state").allInnerTexts(), LESSONS.map(() => "done"));
  assert.equal(await app.message(), "");
});
