// @ts-check
// The list of lessons, with how far each is.
import { make } from "../dom.js";
import { press } from "./blocks.js";
import { lessons } from "./source.js";
import { clearAll, exportAll, progress } from "./store.js";

/**
 * @param {import("../main.js").App} app
 * @param {(next: string | File) => void} open
 * @param {() => void} again Shows the list again.
 */
export async function showList(app, open, again) {
  const list = make("ol", { className: "lessons" });
  for (const [index, { id, title, minutes, about }] of (await lessons()).entries()) {
    const [done, parts] = progress(id);
    const state = parts === 0 ? `${minutes} min` : done >= parts ? "done" : `${done} of ${parts}`;
    const button = make("button", { type: "button", onclick: () => open(id) }, make("span", { className: "number" }, `${index + 1}`), make("b", {}, title), make("span", { className: "note" }, about), make("span", { className: "state", title: "Predictions, goals and quizzes done" }, state));
    list.append(make("li", {}, button));
  }
  const picker = make("input", { type: "file", accept: ".md,text/markdown", hidden: true, "aria-label": "Lesson file" });
  picker.addEventListener("change", () => {
    const file = picker.files?.[0];
    picker.value = "";
    if (file) open(file);
  });
  const clear = press("Clear progress", () => {
    if (clear.dataset.sure) {
      clearAll();
      again();
    } else {
      clear.dataset.sure = "yes";
      clear.textContent = "Clear it for good";
    }
  });
  const tour = press("Show me around (90 s)", () => void import("./tour.js").then(({ startTour }) => startTour(app)));
  return make(
    "div",
    {},
    make("p", {}, "Ten lessons beside the live floor: predict, run, measure. What you do is kept in this browser only."),
    make("p", { className: "act" }, tour),
    list,
    make("h3", {}, "A lesson of your own"),
    make("p", { className: "note" }, "A lesson is one Markdown file. Drop it anywhere on the page, or open it here; then you get a link to send."),
    make("p", { className: "act" }, press("Open a file…", () => picker.click()), picker, press("Template", () => void import("./template.js").then(({ saveTemplate }) => saveTemplate()))),
    make("h3", {}, "Your progress"),
    make("p", { className: "act" }, press("Export", exportAll), clear),
  );
}
