// @ts-check
// A lesson as elements of the page.
import { LessonText } from "../../learn.js";
import { make } from "../dom.js";
import { complain, toast } from "../messages.js";
import { act, code, hint, predict, press, prose, scene } from "./blocks.js";
import { goal, measure } from "./goal.js";
import { handIn } from "./hand-in.js";
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
  return { title: lesson.title, parts: [...forAuthor(app, text, source), head(lesson), ...parts, foot(context, source, open)] };
}

/** What may be amiss, for who has opened the file. @param {import("../main.js").App} app @param {LessonText} text @param {import("./source.js").Source} source */
function forAuthor({ catalogue: { rooms, robots, planners, behaviours } }, text, { isFile }) {
  const notes = isFile ? text.notes(...names(rooms, robots, planners, behaviours)) : [];
  return notes.length > 0 ? [make("section", { className: "part wrong", "aria-label": "For its author" }, make("b", {}, "For its author"), make("ul", {}, ...notes.map((note) => make("li", {}, `${note}${/[.?!]$/.test(note) ? "" : "."}`))))] : [];
}

/** @param {{ id: string }[][]} lists @returns {[string, string, string, string]} */
const names = (...lists) => /** @type {[string, string, string, string]} */ (lists.map((list) => list.map(({ id }) => id).join(", ")));

/** @param {import("../types").Lesson} lesson */
function head({ minutes, audience, outcomes }) {
  const facts = [minutes > 0 ? `${minutes} min` : "", audience].filter(Boolean).join(", ");
  const goals = outcomes.length > 0 ? [make("p", {}, "Afterwards you can:"), make("ul", {}, ...outcomes.map((outcome) => make("li", {}, outcome)))] : [];
  return make("div", { className: "prose outcomes" }, make("p", { className: "note" }, facts), ...goals);
}

/** @param {import("./blocks.js").Context} context @param {import("./source.js").Source} source @param {(id: string) => void} open */
function foot(context, source, open) {
  const { lesson } = context;
  const next = make("p", { className: "act" });
  if (source.isOurs) {
    void lessons().then((all) => {
      const found = all[all.findIndex(({ id }) => id === lesson.id) + 1];
      if (found) next.append(press(`Next lesson: ${found.title}`, () => open(found.id), "primary"));
    });
  }
  const name = make("input", { type: "text", autocomplete: "name", "aria-label": "Your name", placeholder: "Your name" });
  const told = make("p", { className: "note", role: "status" });
  const hand = press("Hand in", () => {
    const missing = handIn(context, name.value);
    told.textContent = missing.length > 0 ? `Saved. Not in the file: ${missing.join("; ")}.` : "Saved, with everything that the lesson asks for.";
  });
  const sources = lesson.sources.length > 0 ? [make("h3", {}, "Sources"), ...lesson.sources.map((html) => prose(html, "source"))] : [];
  return make(
    "footer",
    {},
    ...sources,
    make("h3", { className: "on-screen" }, "Hand in"),
    make("p", { className: "note" }, "Saves a file with your settings, the numbers of the runs and their digests. Anyone can repeat the runs with robovac grade."),
    make("p", { className: "act" }, name, hand, press("Get a link to send", () => void send(source)), press("Print", () => window.print())),
    told,
    next,
  );
}

/** @param {import("./source.js").Source} source */
async function send({ place }) {
  if (!place) return complain("This lesson is too long for a link. Put the file on the web, and send this page's address followed by #lesson= and the file's address.");
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
