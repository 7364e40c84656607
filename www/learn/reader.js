// @ts-check
// A lesson as elements of the page.
import { LessonText } from "../../learn.js";
import { make } from "../dom.js";
import { complain, toast } from "../messages.js";
import { download } from "../files.js";
import { act, code, hint, predict, press, prose, scene } from "./blocks.js";
import { goal, measure } from "./goal.js";
import { quiz } from "./quiz.js";
import { lessons } from "./source.js";
import { done, keep, nothing } from "./store.js";

/** Parts that count as something to do. */
const COUNTED = ["predict", "goal", "quiz"];

/**
 * @param {import("../main.js").App} app
 * @param {import("./source.js").Source} source
 * @param {{ isLecture: boolean, signal: AbortSignal, ticks: (() => void)[], open: (id: string) => void }} how In a lecture nothing of the reader's is shown or kept.
 */
export function readLesson(app, source, { isLecture, signal, ticks, open }) {
  const text = new LessonText(source.text);
  signal.addEventListener("abort", () => text.free());
  const lesson = text.view();
  const key = source.isOurs ? lesson.id : `${lesson.id}@${lesson.digest}`;
  const state = isLecture ? nothing() : done(key);
  state.parts = lesson.blocks.filter(({ kind }) => COUNTED.includes(kind)).length;
  const changed = () => void (isLecture || keep());
  changed();
  const context = { app, text, lesson, isOurs: source.isOurs, done: state, changed, signal, ticks };

  let hints = 0;
  const parts = lesson.blocks.map((block, index) => {
    switch (block.kind) {
      case "prose":
        return prose(block.html);
      case "scene":
        return scene(context, block);
      case "do":
        return act(context, block);
      case "predict":
        return predict(context, block);
      case "hint":
        return hint(context, block, hints++);
      case "code":
        return code(context, block);
      case "goal":
        return goal(context, block);
      case "measure":
        return measure(context, block, index);
      case "quiz":
        return quiz(context, block);
    }
  });
  return { title: lesson.title, parts: [head(lesson), ...parts, foot(source, lesson, state, open)] };
}

/** @param {import("../types").Lesson} lesson */
function head({ minutes, audience, outcomes }) {
  const facts = [minutes > 0 ? `${minutes} min` : "", audience].filter(Boolean).join(", ");
  const goals = outcomes.length > 0 ? [make("p", {}, "Afterwards you can:"), make("ul", {}, ...outcomes.map((outcome) => make("li", {}, outcome)))] : [];
  return make("div", { className: "prose outcomes" }, make("p", { className: "note" }, facts), ...goals);
}

/** @param {import("./source.js").Source} source @param {import("../types").Lesson} lesson @param {import("./store.js").Done} state @param {(id: string) => void} open */
function foot(source, lesson, state, open) {
  const next = make("p", { className: "act" });
  if (source.isOurs) {
    void lessons().then((all) => {
      const found = all[all.findIndex(({ id }) => id === lesson.id) + 1];
      if (found) next.append(press(`Next lesson: ${found.title}`, () => open(found.id), "primary"));
    });
  }
  const name = make("input", { type: "text", autocomplete: "name", "aria-label": "Your name", placeholder: "Your name" });
  const sources = lesson.sources.length > 0 ? [make("h3", {}, "Sources"), ...lesson.sources.map((html) => prose(html, "source"))] : [];
  return make(
    "footer",
    {},
    ...sources,
    make("h3", {}, "Hand in"),
    make("p", { className: "note" }, "Saves a file with your settings, the numbers of the runs and their digests. Anybody can repeat it with robovac grade."),
    make("p", { className: "act" }, name, press("Hand in", () => handIn(lesson, state, name.value)), press("Get a link to send", () => void send(source)), press("Print", () => window.print())),
    next,
  );
}

/** @param {import("../types").Lesson} lesson @param {import("./store.js").Done} state @param {string} name */
function handIn(lesson, state, name) {
  /** @type {import("../types").Answer} */
  const answer = {
    robovac_answer: 1,
    lesson: lesson.id,
    lesson_digest: lesson.digest,
    name: name.trim(),
    goals: Object.fromEntries(Object.entries(state.goals).map(([id, { passed: _, ...answer }]) => [id, answer])),
    quizzes: Object.fromEntries(Object.entries(state.quizzes).map(([id, { answers }]) => [id, { answers: answers.map(([seed, text]) => /** @type {[number, string]} */ ([seed, text])) }])),
    predictions: state.predictions,
  };
  const file = [lesson.id, name.trim().toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-")].filter(Boolean).join("-");
  download(`${file}.json`, JSON.stringify(answer, null, 1), "application/json");
}

/** @param {import("./source.js").Source} source */
async function send({ place }) {
  if (!place) return complain("This lesson is too long for a link. Put the file on the web, and send this page's address with #lesson= and the file's address behind it.");
  const link = new URL(location.href);
  link.hash = `lesson=${encodeURIComponent(place)}`;
  try {
    await navigator.clipboard.writeText(link.href);
    toast("Link copied");
  } catch {
    history.replaceState(null, "", link.hash);
    toast("The link is in the address bar");
  }
}
