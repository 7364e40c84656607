// Learn: lessons beside the live floor, their goals and quizzes, exercises from files and by link, and handing in.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { openApp, taken } from "./app.mjs";
import { ROOT } from "./harness.mjs";
import { robovac } from "./serial/robot.mjs";

const LESSON = `# Small

\`\`\`lesson
id: small
\`\`\`

<script>window.hacked = 1</script> <img src=x onerror="window.hacked = 2"> [bad](javascript:window.hacked=3)

\`\`\`goal
id: more
in: room=thesis8&robot=roomba600&behaviour=bounce&p.least=180&p.most=180
change: algorithm, params
runs: 3
minutes: 2
need: median coverage >= 40 %
\`\`\`

\`\`\`hint
Turn by another angle.
\`\`\`

\`\`\`measure
in: room=thesis8&robot=roomba600
row: Bounce | behaviour=bounce
runs: 2
minutes: 2
show: coverage, time to 99 %
\`\`\`
`;

const INDEX = JSON.parse(fs.readFileSync(path.join(ROOT, "lessons/index.json"), "utf8"));

/** Cells that are reached from S, by the description of the picture. */
function reached(description) {
  const rows = /rows from the top: ([#.S ]+);/.exec(description)[1].trim().split(" ");
  const open = rows.flatMap((row, y) => [...row].flatMap((sign, x) => (sign === "S" ? [[x, y]] : [])));
  const seen = new Set(open.map(String));
  while (open.length > 0) {
    const [x, y] = open.pop();
    for (const [a, b] of [[x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]]) {
      if (!".S".includes(rows[b]?.[a] ?? "#") || seen.has(`${a},${b}`)) continue;
      seen.add(`${a},${b}`);
      open.push([a, b]);
    }
  }
  return seen.size;
}

/** Drops a file on the page. */
const drop = (page, name, text) =>
  page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], name));
      for (const kind of ["dragenter", "drop"]) document.body.dispatchEvent(new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true }));
    },
    [name, text],
  );

test("a lesson stands beside the floor, takes predictions, and marks right and wrong answers", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=thesis8&behaviour=bounce" });
  await page.getByRole("button", { name: "Learn", exact: true }).click();
  await page.getByRole("button", { name: /Who wins\?/ }).click();
  const panel = page.locator("#learn");
  await panel.getByRole("heading", { name: "Who wins?" }).waitFor();
  const [floor, lesson] = [await page.locator("#floor").boundingBox(), await panel.boundingBox()];
  assert.ok(floor.width > 250 && floor.x + floor.width <= lesson.x + 1, "the floor is beside the lesson");
  await screenshot("learn");

  await panel.getByRole("button", { name: "Commit" }).first().click();
  await panel.getByText("Choose one first").waitFor();
  await panel.getByRole("radio").first().check();
  await panel.getByRole("button", { name: "Commit" }).first().click();
  assert.ok(await panel.getByRole("radio").nth(1).isDisabled(), "what was committed stays");
  await panel.getByRole("button", { name: "Compare with what happened" }).first().click();
  await panel.getByText(/As you predicted|Not as you predicted\. The right answer is “/).waitFor();

  const quiz = panel.getByRole("region", { name: "Quiz" }).first();
  const answer = async (by) => {
    const right = reached(await quiz.getByRole("img").getAttribute("aria-label"));
    await quiz.getByRole("textbox").fill(String(right + by));
    await quiz.getByRole("button", { name: "Answer" }).click();
  };
  await answer(1);
  await quiz.getByText("Not so.").waitFor();
  await quiz.getByRole("button", { name: "Next question" }).click();
  await answer(0);
  await quiz.getByText("Right: 1 of 2").waitFor();

  // A scene sets the page, and the lesson stays, also over a reload.
  await panel.getByRole("button", { name: /Set the scene/ }).click();
  await app.settled();
  assert.equal(await page.locator("#room").inputValue(), "living");
  await page.waitForFunction(() => /lesson=who-wins$/.test(location.hash));
  await page.reload();
  await app.until("ready", "paused", "playing", "finished");
  await panel.getByRole("heading", { name: "Who wins?" }).waitFor();
  assert.ok(await panel.getByRole("radio").first().isDisabled(), "progress is kept");

  await page.setViewportSize({ width: 390, height: 844 });
  const [small, sheet] = [await page.locator("#floor").boundingBox(), await panel.boundingBox()];
  assert.ok(small.height > 120 && small.y + small.height <= sheet.y + 1, "on a phone the floor is above the lesson");
  await screenshot("learn-phone");
});

test("all lessons open, and lecture mode turns their pages", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&behaviour=bounce&lesson=who-wins" });
  const panel = page.locator("#learn");
  for (const { id, title } of INDEX) {
    await page.evaluate((lesson) => (location.hash = `room=thesis8&behaviour=bounce&lesson=${lesson}`), id);
    await panel.getByRole("heading", { name: title, exact: true }).waitFor();
    assert.ok((await panel.locator(".learn-body > *").count()) > 5, id);
  }
  await panel.getByRole("button", { name: /Lecture mode/ }).click();
  await page.waitForFunction(() => /^1 of \d+$/.test(document.getElementById("learn").dataset.page));
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => /^2 of/.test(document.getElementById("learn").dataset.page));
  assert.equal(await panel.getByText("Compare with what happened").filter({ visible: true }).count(), 0);
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.getElementById("learn").dataset.page === "");
  assert.equal(await app.message(), "");
});

test("in lecture mode even small type is large enough for the last row", async (t) => {
  const { page } = await openApp(t, { address: "#room=thesis8&behaviour=bounce&lesson=who-wins", viewport: { width: 1440, height: 900 } });
  const panel = page.locator("#learn");
  await panel.getByRole("heading", { name: "Who wins?", exact: true }).waitFor();
  /** The smallest type of all that has text, px. */
  const smallest = () =>
    panel.locator(".learn-body").evaluate((body) => {
      const walker = document.createTreeWalker(body, NodeFilter.SHOW_TEXT);
      const sizes = [];
      while (walker.nextNode()) if (walker.currentNode.textContent.trim() && walker.currentNode.parentElement.checkVisibility() && !walker.currentNode.parentElement.closest("svg")) sizes.push(parseFloat(getComputedStyle(walker.currentNode.parentElement).fontSize));
      return Math.min(...sizes);
    });
  const before = await smallest();
  await panel.getByRole("button", { name: /Lecture mode/ }).click();
  const pages = Number(/^1 of (\d+)$/.exec(await panel.getAttribute("data-page"))[1]);
  assert.ok(pages > 3, `${pages} pages`);
  for (let number = 1; number <= pages; number++) {
    await page.waitForFunction((wanted) => document.getElementById("learn").dataset.page.startsWith(`${wanted} of`), number);
    const size = await smallest();
    assert.ok(size >= 20 && size > 1.4 * before, `page ${number}: ${size} px, and ${before} px outside a lecture`);
    assert.ok(await panel.locator(".learn-body").evaluate((body) => body.scrollWidth <= body.clientWidth + 1), `page ${number} is too wide`);
    await page.keyboard.press("ArrowRight");
  }
});

test("each lesson prints to one or two pages", async (t) => {
  const { page } = await openApp(t, { address: "#room=thesis8&behaviour=bounce&lesson=who-wins" });
  for (const { id, title } of INDEX) {
    await page.evaluate((lesson) => (location.hash = `room=thesis8&behaviour=bounce&lesson=${lesson}`), id);
    await page.locator("#learn").getByRole("heading", { name: title, exact: true }).waitFor();
    const pages = (await page.pdf({ format: "A4" })).toString("latin1").match(/\/Type\s*\/Page\b/g)?.length;
    assert.ok(pages === 1 || pages === 2, `${id}: ${pages} pages`);
  }
});

test("an exercise from a file is safe, checked, handed in, and graded natively with the same digests", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&behaviour=bounce" });
  await drop(page, "small.md", LESSON);
  const panel = page.locator("#learn");
  await panel.getByRole("heading", { name: "Small" }).waitFor();
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.equal(await panel.locator("script, img, a[href^=javascript]").count(), 0);

  await panel.getByRole("button", { name: "Set up the task" }).click();
  await app.settled();
  await panel.getByRole("button", { name: "Check my settings" }).click();
  await panel.getByText("Not yet.").waitFor();
  await panel.getByText(/median coverage ≥ 40 %: [\d.]+ %, missed/).waitFor();
  await app.choose("algorithm", "boustrophedon");
  await panel.getByRole("button", { name: "Check my settings" }).click();
  await panel.getByText("Goal reached.").waitFor();
  await panel.getByRole("button", { name: "Measure" }).click();
  await page.waitForFunction(() => /^\d/.test(document.querySelector("#learn .measure tbody td")?.textContent ?? ""));

  await panel.getByRole("textbox", { name: "Your name" }).fill("Ada");
  const [download] = await taken(page, 1, () => panel.getByRole("button", { name: "Hand in" }).click());
  assert.equal(download.suggestedFilename(), "small-ada.json");
  await panel.getByText("Saved, with everything that the lesson asks for.").waitFor();
  const folder = fs.mkdtempSync(path.join(ROOT, "target/learn-"));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  const [lesson, answer] = [path.join(folder, "small.md"), path.join(folder, "ada.json")];
  fs.writeFileSync(lesson, LESSON);
  await download.saveAs(answer);
  const grade = () => JSON.parse(execFileSync(robovac(), ["grade", lesson, answer, "--json"], { encoding: "utf8" }))[0];
  const { name, passed, goals } = grade();
  assert.deepEqual({ name, passed, misfits: goals[0].misfits }, { name: "Ada", passed: true, misfits: [] });
  const cheat = JSON.parse(fs.readFileSync(answer, "utf8"));
  cheat.goals.more.runs[0].digest = "0123456789abcdef";
  fs.writeFileSync(answer, JSON.stringify(cheat));
  assert.equal(grade().goals[0].misfits.length, 1);
});

const AMISS = `# Corners

\`\`\`goal
in: room=own&flat=7&robot=roomba600&behaviour=bounce
runs: 2
minutes: 1
need: median coverage >= 1 %
\`\`\`

\`\`\`measure
in: room=own&flat=7&robot=roomba600
row: Bounce | behaviour=bounse
row: Lanes | planner=boustrophedon
runs: 1
minutes: 1
show: coverage
\`\`\`

\`\`\`quiz median
rounds: 1
\`\`\`
`;

test("a dropped lesson tells its author what is amiss; a generated flat is the room of a goal, here and when it is graded", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&behaviour=bounce" });
  const panel = page.locator("#learn");
  await drop(page, "slip.md", AMISS.replace("```quiz", "```quizz"));
  await panel.getByText('line 19: there is no block "quizz median"; did you mean "quiz"?').waitFor();
  await drop(page, "amiss.md", AMISS);
  const notes = panel.getByRole("region", { name: "For its author" });
  await notes.getByText('line 12: there is no behaviour "bounse"; did you mean "bounce"?').waitFor();
  await notes.getByText(/line 3: the goal doesn't say what may be changed/).waitFor();
  await notes.getByText(/the lesson has no id, so answers are for "corners"/).waitFor();
  assert.equal(await notes.getByRole("listitem").count(), 3);

  await panel.getByRole("button", { name: "Set up the task" }).click();
  await page.waitForFunction(() => /room=own&flat=7&/.test(location.hash));
  await app.settled();
  await panel.getByRole("button", { name: "Check my settings" }).click();
  await panel.getByText("Goal reached.").waitFor();
  assert.equal(await panel.getByText("You can't change these here").count(), 0);
  const quiz = panel.getByRole("region", { name: "Quiz" });
  await quiz.getByRole("textbox").fill("abc");
  await quiz.getByRole("button", { name: "Answer" }).click();
  await quiz.getByText("Give a number, e.g. 72.").waitFor();
  const [download] = await taken(page, 1, () => panel.getByRole("button", { name: "Hand in" }).click());
  await panel.getByText('Not in the file: the quiz "quiz-1" (right: 0 of 1).').waitFor();
  const folder = fs.mkdtempSync(path.join(ROOT, "target/learn-"));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  const [lesson, answer] = [path.join(folder, "lesson.md"), path.join(folder, "answer.json")];
  fs.writeFileSync(lesson, AMISS.replace("bounse", "bounce"));
  await download.saveAs(answer);
  const [{ goals, quizzes }] = JSON.parse(execFileSync(robovac(), ["grade", lesson, answer, "--json"], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));
  assert.deepEqual({ passed: goals[0].verdict.passed, misfits: goals[0].misfits, right: quizzes[0].right }, { passed: true, misfits: [], right: 0 });
});

test("on paper a table has the names of its rows, and nothing that only works on a screen", async (t) => {
  const { page } = await openApp(t, { address: "#room=thesis8&behaviour=bounce" });
  await drop(page, "small.md", LESSON);
  const panel = page.locator("#learn");
  await panel.getByRole("heading", { name: "Small" }).waitFor();
  await page.emulateMedia({ media: "print" });
  t.after(() => page.emulateMedia({ media: null }));
  const shown = await panel.innerText();
  assert.match(shown, /Bounce/);
  assert.doesNotMatch(shown, /Hand in|Press a name|Measure\b/);

  // The list is printed, too.
  await page.emulateMedia({ media: null });
  await panel.getByRole("button", { name: "All lessons" }).click();
  await panel.getByRole("button", { name: "Template" }).waitFor();
  await page.emulateMedia({ media: "print" });
  const list = await panel.innerText();
  for (const { title } of INDEX) assert.ok(list.includes(title), title);
  assert.doesNotMatch(list, /Template|Clear progress|of your own/);
});

test("in lecture mode page keys scroll a section that is longer than the window, and then turn", async (t) => {
  const { page } = await openApp(t, { address: "#room=thesis8&behaviour=bounce&lesson=lost", viewport: { width: 1440, height: 900 } });
  const panel = page.locator("#learn");
  await panel.getByRole("heading", { name: "Lost", exact: true }).waitFor();
  await panel.getByRole("button", { name: /Lecture mode/ }).click();
  const state = () => page.evaluate(() => {
    const body = document.querySelector(".learn-body");
    return { page: Number.parseInt(document.getElementById("learn").dataset.page), top: body.scrollTop, left: body.scrollHeight - body.clientHeight - body.scrollTop };
  });
  let now = await state();
  while (now.left < 100) {
    await page.keyboard.press("ArrowRight");
    now = await state();
  }
  await page.keyboard.press("ArrowDown");
  const line = await state();
  assert.ok(line.top > 0 && line.page === now.page, JSON.stringify(line));
  let last = line;
  for (const key of ["Space", "PageDown"].flatMap((key) => Array(6).fill(key))) {
    await page.keyboard.press(key);
    const next = await state();
    assert.ok(next.page === last.page ? next.top > last.top : last.left < 2 && next.top === 0 && next.page === last.page + 1, `${JSON.stringify(last)} ${key} ${JSON.stringify(next)}`);
    if (next.page > last.page) break;
    last = next;
  }
  await page.keyboard.press("PageUp");
  assert.equal((await state()).page, now.page);
});

test("a lesson from elsewhere is fetched only after the reader agreed; what can't be opened says why", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&behaviour=bounce", allow: [/CORS|ERR_FAILED|failed: https:/] });
  let asked = 0;
  await page.route("https://teacher.example/*", (route) => {
    asked += 1;
    const forbids = route.request().url().endsWith("closed.md");
    return route.fulfill({ body: LESSON, headers: { "access-control-allow-origin": forbids ? "https://other.example" : "*" } });
  });
  const go = (lesson) => page.evaluate((address) => (location.hash = `room=thesis8&behaviour=bounce&lesson=${address}`), lesson);
  const panel = page.locator("#learn");
  await go("https://teacher.example/small.md");
  await panel.getByText("teacher.example", { exact: true }).waitFor();
  assert.equal(asked, 0);
  await panel.getByRole("button", { name: "Fetch the lesson" }).click();
  await panel.getByRole("heading", { name: "Small" }).waitFor();
  assert.equal(asked, 1);
  await go("https://teacher.example/closed.md");
  await panel.getByRole("button", { name: "Fetch the lesson" }).click();
  await panel.getByText(/forbids other sites to read the file/).waitFor();
  await page.waitForFunction(() => decodeURIComponent(location.hash).endsWith("lesson=https://teacher.example/closed.md"));
  await panel.getByRole("button", { name: "Try again" }).click();
  await panel.getByRole("button", { name: "Fetch the lesson" }).waitFor();
  await go("http://teacher.example/small.md");
  await panel.getByText(/by https only/).waitFor();
  await drop(page, "broken.md", "# T\n```goal\nin: room=flat&robot=roomba600\n```\n");
  await panel.getByText(/line 2: the block "goal" has no line "need"/).waitFor();
  assert.equal(await app.message(), "");
});

test("the page shows itself around in four steps, once", async (t) => {
  const { page } = await openApp(t, { viewport: { width: 1300, height: 800 } });
  await page.mouse.move(400, 300);
  await page.locator(".tagline").getByRole("button", { name: "Show me" }).click();
  const card = page.getByRole("dialog", { name: "Show me" });
  for (const head of ["What the robot does", "Change the room", "Compare", "Where to go next"]) {
    await card.getByRole("heading", { name: head }).waitFor();
    await card.getByRole("button", { name: /Next|Done/ }).click();
  }
  await card.waitFor({ state: "detached" });
  await page.reload();
  await page.locator("#play").waitFor();
  await page.mouse.move(420, 300);
  await page.waitForFunction(() => performance.getEntriesByType("resource").some(({ name }) => name.includes("learn/offer.js")));
  assert.equal(await page.getByRole("button", { name: "Show me", exact: true }).count(), 0);
});

const BY_PROGRAM = `# By program

\`\`\`lesson
id: by-program
\`\`\`

\`\`\`code javascript
function* run(robot) {
  for (;;) {
    yield robot.forward(10);
    yield robot.forward(-0.05);
    yield robot.turn(90 + 90 * robot.random());
  }
}
\`\`\`

\`\`\`goal
id: drive
in: room=thesis8&robot=roomba600&behaviour=wall_follow&slip=typical
change: program
runs: 3
minutes: 2
need: median coverage >= 20 %
\`\`\`
`;

test("a program reaches a goal in a room of the task's, is handed in, and graded natively with the same digests", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=bedroom&behaviour=bounce" });
  await drop(page, "by-program.md", BY_PROGRAM);
  const panel = page.locator("#learn");
  await panel.getByRole("button", { name: "Check my program" }).click();
  await panel.getByText(/No program drives the robot yet/).waitFor();
  // What the robot does elsewhere is no part of the task.
  await page.locator("#play").click();
  await page.waitForFunction(() => document.getElementById("n-time").textContent !== "0:00");
  assert.equal(await panel.locator(".live").textContent(), "");
  await panel.getByRole("button", { name: "Hand in" }).click();
  await panel.getByText('Not in the file: the goal "drive", which you haven\'t checked.').waitFor();
  await panel.getByRole("button", { name: "Set up the task" }).click();
  await page.locator("body[data-tab=program]").waitFor();
  await panel.getByRole("button", { name: "Open in Program" }).click();
  await page.locator("#program-foreign").waitFor();
  await page.locator("#program-run").click();
  await page.waitForFunction(() => /behaviour=program/.test(location.hash));
  await panel.getByRole("button", { name: "Check my program" }).click();
  await panel.getByText("Goal reached.").waitFor();
  const [download] = await taken(page, 1, () => panel.getByRole("button", { name: "Hand in" }).click());
  const folder = fs.mkdtempSync(path.join(ROOT, "target/learn-"));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  const [lesson, answer] = [path.join(folder, "lesson.md"), path.join(folder, "answer.json")];
  fs.writeFileSync(lesson, BY_PROGRAM);
  await download.saveAs(answer);
  const [{ passed, goals }] = JSON.parse(execFileSync(robovac(), ["grade", lesson, answer, "--json", "--unconfined"], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }));
  assert.deepEqual({ passed, misfits: goals[0].misfits, runs: goals[0].verdict.runs.length }, { passed: true, misfits: [], runs: 3 });
  // What is written but not run would be marked as the program before it.
  await page.locator(".cm-content").click();
  await page.keyboard.press("ControlOrMeta+End");
  await page.keyboard.insertText("\n// changed\n");
  await panel.getByRole("button", { name: "Check my program" }).click();
  await panel.getByText("The program was changed since it last ran").waitFor();
  await page.locator("#program-run").click();
  await panel.getByRole("button", { name: "Check my program" }).click();
  await panel.getByText("Goal reached.").waitFor();
  assert.equal(await app.message(), "");
});

test("a definition leads to the lesson that explains it, by pointer and by key", async (t) => {
  const { page } = await openApp(t, { address: "#room=thesis8&behaviour=bounce" });
  await page.mouse.move(400, 300);
  const term = page.locator("#metrics").getByRole("button", { name: "Position error" });
  await term.focus();
  // Focus by key shows the definition; that of a script doesn't.
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Tab");
  await page.locator("#tip").getByRole("button", { name: /Explained in lesson 7/ }).waitFor();
  await page.keyboard.press("F1");
  await page.locator("#learn").getByRole("heading", { name: "Lost", exact: true }).waitFor();
  await page.locator("#numbers").getByRole("button", { name: "Coverage" }).hover();
  await page.locator("#tip").getByRole("button", { name: /Explained in lesson 1/ }).click();
  await page.locator("#learn").getByRole("heading", { name: "Who wins?" }).waitFor();
});

/** Where the numbers and controls are that lessons explain. */
const PLACES = [
  "room=thesis8&planner=boustrophedon", "room=thesis8&behaviour=bounce", "room=living&behaviour=wall_follow", "room=stairs&behaviour=bounce",
  "room=thesis8&behaviour=bounce&tab=map", "room=thesis8&tab=compare&view=numbers", "room=thesis8&tab=compare&view=runs", "room=thesis8&robot=roomba600&slip=typical&tab=compare&view=runs&runs=explore_edge&paths=&times=3&minutes=2",
];

test("every definition is a sentence, and each label that a lesson explains leads to it from where it stands on the page", async (t) => {
  const { page, app } = await openApp(t, { address: `#${PLACES[0]}` });
  await page.mouse.move(400, 300);
  const found = new Map();
  for (const place of PLACES) {
    await page.evaluate((hash) => (location.hash = hash), place);
    await app.settled();
    const tab = new URLSearchParams(place).get("tab") ?? "explore";
    await page.locator(`#panel-${tab} [data-tip]`).first().waitFor({ state: "attached" });
    // The rows of the numbers come with the first frame after that.
    if (tab === "explore") await page.locator("#metrics-plan [data-tip]").last().waitFor({ state: "attached" });
    if (place.includes("explore_")) {
      await page.locator("#runs-go").click();
      await page.locator("#panel-compare th").filter({ hasText: "90 % found" }).waitFor();
    }
    const tips = await page.evaluate(async (panel) => {
      const { lessonOf } = await import(new URL("www/learn/explains.js", document.baseURI).href);
      const owners = [...document.querySelectorAll(`#panel-${panel} [data-tip]:not([data-tip=""])`)];
      return Promise.all(owners.map(async (owner) => [owner.getAttribute("data-tip"), owner.textContent, (await lessonOf(owner))?.id, ((owner.querySelector(".term, .label") ?? owner).firstChild?.textContent ?? "").replace(/,.*/, "").trim()]));
    }, tab);
    for (const [tip, text, lesson, label] of tips) {
      assert.match(tip, /^[^a-z].*[.?)]$/s, `"${text}" has no sentence: ${tip}`);
      if (lesson) found.set(label.toLowerCase(), lesson);
    }
  }
  const lost = INDEX.flatMap(({ id, explains }) => explains.filter((label) => found.get(label.toLowerCase()) !== id));
  assert.deepEqual(lost, [], "nothing on the page leads from these to their lessons");
});
