// @ts-check
// A quiz: questions made from seeds, marked by the page.
import { mark, question } from "../../learn.js";
import { make } from "../dom.js";
import { press } from "./blocks.js";

/** @param {import("./blocks.js").Context} context @param {Extract<import("../types").LessonBlock, { kind: "quiz" }>} quiz */
export function quiz({ done, changed }, { id, about, rounds }) {
  const state = (done.quizzes[id] ??= { answers: [] });
  const box = make("section", { className: "part quiz", "aria-label": "Quiz" }, make("h4", {}, "Quiz"));
  const score = make("p", { className: "note" });
  const place = make("div");
  const outcome = make("div", { className: "outcome", role: "status" });
  box.append(score, place, outcome);
  const tell = () => {
    const right = new Set(state.answers.filter(([, , isRight]) => isRight).map(([seed]) => seed)).size;
    const more = right > rounds ? ` So far ${right - rounds} more ${right === rounds + 1 ? "is" : "are"} right.` : "";
    score.textContent = `Right: ${Math.min(right, rounds)} of ${rounds}${right >= rounds ? `, done. You can go on for practice.${more}` : ""}`;
  };

  const ask = () => {
    const seed = crypto.getRandomValues(new Uint32Array(1))[0] ?? 1;
    const { text, room, options, example } = question(about, seed);
    outcome.textContent = "";
    const next = press("Next question", ask);
    next.hidden = true;
    /** @param {string} answer */
    const answered = (answer) => {
      const [isRight, because] = mark(about, seed, answer);
      if (isRight === null) {
        outcome.textContent = because;
        return;
      }
      state.answers.push([seed, answer, isRight]);
      changed();
      tell();
      outcome.replaceChildren(make("b", {}, isRight ? "Right. " : "Not so. "), because);
      form.querySelectorAll("button, input").forEach((control) => control !== next && control.setAttribute("disabled", ""));
      next.hidden = false;
      next.focus();
    };
    const form = make("form", { className: "act" });
    if (options.length > 0) form.append(...options.map((option, index) => press(option, () => answered(String(index)))));
    else {
      const field = make("input", { type: "text", placeholder: example, "aria-label": "Answer", inputMode: "text", autocomplete: "off" });
      form.append(field, make("button", { type: "submit" }, "Answer"));
      form.addEventListener("submit", (event) => {
        event.preventDefault();
        if (field.value.trim()) answered(field.value);
      });
    }
    form.addEventListener("submit", (event) => event.preventDefault());
    form.append(next);
    place.replaceChildren(make("p", {}, text), ...(room.length > 0 ? [picture(room), make("p", { className: "note room-key" }, make("i", { className: "wall" }), "Wall ", make("i"), "Floor")] : []), form);
  };
  tell();
  ask();
  return box;
}

/** A room as a picture: `#` wall, `.` floor, `S` start. @param {string[]} rows */
function picture(rows) {
  const NAME = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(NAME, "svg");
  const width = rows[0]?.length ?? 0;
  svg.setAttribute("viewBox", `-0.1 -0.1 ${width + 0.2} ${rows.length + 0.2}`);
  svg.setAttribute("class", "room");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", `Room of ${width} by ${rows.length} cells, rows from the top: ${rows.join(" ")}; # is wall, . is floor`);
  svg.style.maxWidth = `${width * 2}rem`;
  rows.forEach((row, y) =>
    [...row].forEach((sign, x) => {
      const cell = document.createElementNS(NAME, "rect");
      for (const [name, value] of Object.entries({ x, y, width: 1, height: 1 })) cell.setAttribute(name, String(value));
      cell.setAttribute("class", sign === "#" ? "wall" : "floor");
      svg.append(cell);
      if (sign !== "S") return;
      const start = document.createElementNS(NAME, "text");
      start.setAttribute("x", String(x + 0.5));
      start.setAttribute("y", String(y + 0.72));
      start.textContent = "S";
      svg.append(start);
    }),
  );
  return svg;
}
