// @ts-check
// The simple parts of a lesson: text, scenes, predictions, buttons, hints, programs.
import { make } from "../dom.js";
import { toast } from "../messages.js";
import { pack } from "../explore/pack.js";
import { DEFAULTS, applyLink, applyScenario } from "./scene.js";

/**
 * @typedef {import("../types").LessonBlock} Block
 * @typedef {object} Context What the parts of a lesson share.
 * @property {import("../main.js").App} app
 * @property {import("../../learn.js").LessonText} text
 * @property {import("../types").Lesson} lesson
 * @property {boolean} isOurs Whether the lesson comes with the page.
 * @property {import("./store.js").Done} done
 * @property {() => void} changed Something was done: keeps it.
 * @property {AbortSignal} signal Ends with the lesson.
 * @property {(() => void)[]} ticks Called some times a second.
 */

/** Safe: Rust has made it from Markdown, raw HTML is shown as text. @param {string} html @param {string} [className] */
export function prose(html, className = "") {
  const box = make("div", { className: `prose ${className}` });
  box.innerHTML = html;
  return box;
}

/** @param {string} text @param {() => unknown} onclick @param {string} [className] */
export const press = (text, onclick, className = "") => make("button", { type: "button", className, onclick }, text);

/** @param {Context} context @param {Extract<Block, { kind: "scene" }>} block */
export function scene({ app }, { title, link, scenario }) {
  return make("p", { className: "act" }, press(title, () => (scenario ? applyScenario(app, scenario) : applyLink(app, link, false))));
}

/** @param {Context} context @param {Extract<Block, { kind: "do" }>} block */
export function act({ app }, { label, link }) {
  return make("p", { className: "act" }, press(`▶ ${label}`, () => applyLink(app, link, true), "primary"));
}

/** A question whose answer is committed before the run. @param {Context} context @param {Extract<Block, { kind: "predict" }>} block */
export function predict({ done, changed }, { id, question, options, right, because }) {
  const box = make("fieldset", { className: "part predict" }, make("legend", {}, "Predict"), make("p", {}, question));
  const inputs = options.map((_, index) => make("input", { type: "radio", name: `learn-${id}`, value: String(index) }));
  options.forEach((option, index) => box.append(make("label", { className: "option" }, /** @type {HTMLInputElement} */ (inputs[index]), option)));
  const outcome = make("div", { className: "outcome", role: "status" });
  const commit = press("Commit", () => {
    const chosen = inputs.findIndex(({ checked }) => checked);
    if (chosen < 0) {
      outcome.textContent = "Choose one first: a prediction that can't be wrong teaches nothing.";
      return;
    }
    done.predictions[id] = chosen;
    changed();
    show();
  });
  const reveal = press("Compare with what happened", () => {
    const chosen = done.predictions[id];
    outcome.replaceChildren(make("b", {}, chosen === right ? "As you predicted. " : `Not as you predicted. The right answer is “${options[right]}”.`), prose(because));
    reveal.hidden = true;
  });
  const show = () => {
    const chosen = done.predictions[id];
    const isCommitted = chosen !== undefined;
    inputs.forEach((input, index) => {
      input.checked = index === chosen;
      input.disabled = isCommitted;
    });
    commit.hidden = isCommitted;
    reveal.hidden = !isCommitted;
    outcome.textContent = isCommitted ? "Committed. Now try it." : "";
  };
  box.append(make("p", { className: "act" }, commit, reveal), outcome);
  show();
  return box;
}

/** Hints are opened one by one. @param {Context} context @param {Extract<Block, { kind: "hint" }>} block @param {number} index */
export function hint({ done, changed }, { html }, index) {
  const details = make("details", { className: "hint", open: index < done.hints }, make("summary", {}, `Hint ${index + 1}`), prose(html));
  details.addEventListener("toggle", () => {
    if (!details.open || done.hints > index) return;
    done.hints = index + 1;
    changed();
  });
  return details;
}

/** @param {Context} context @param {Extract<Block, { kind: "code" }>} block */
export function code({ app, lesson, isOurs }, { language, text }) {
  const copy = press("Copy", () => {
    navigator.clipboard.writeText(text).then(
      () => toast("Program copied"),
      () => toast("This browser doesn't let the page copy; select the text"),
    );
  });
  const row = make("p", { className: "act" }, copy);
  const open = async () => {
    // A program of this page needs no warning about its author.
    if (isOurs) {
      const { freeName, freshId, isTrusted, put } = await import("../program/own-programs.js");
      if (!isTrusted(text)) put({ id: freshId(), name: freeName(lesson.id), language: /** @type {"python" | "javascript"} */ (language), source: text });
    }
    const packed = await pack(JSON.stringify({ name: lesson.id, language, source: text }));
    // Where the goal is: the robot on the floor drives there, too.
    const goal = lesson.blocks.find((block) => block.kind === "goal" && !block.scene);
    location.hash = `${goal?.kind === "goal" ? `${DEFAULTS}&${goal.start}` : app.playground.link()}&tab=program&code=${packed}`;
  };
  if (document.getElementById("tab-program")) row.append(press("Open in Program", open, "primary"));
  return make("div", { className: "part" }, make("pre", { tabIndex: 0, "aria-label": `Program in ${language === "python" ? "Python" : "JavaScript"}` }, make("code", {}, text)), row);
}
