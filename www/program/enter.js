// @ts-check
// The tab Program with all that it needs. Loaded when it is first opened, or when a link says that a program drives.
import { byId, make } from "../dom.js";
import { style, text } from "../parts.js";
import { setInterface } from "./complete.js";
import { startProgram } from "./tab.js";

/** @type {ReturnType<typeof load> | undefined} */
let coming;

/** @param {import("../main.js").App} app */
export function enterProgram(app) {
  coming ??= load(app).catch((error) => {
    coming = undefined;
    throw error;
  });
  return coming;
}

/** @param {import("../main.js").App} app */
async function load(app) {
  const [fragment, list] = await Promise.all([
    text(new URL("./program.html", import.meta.url)),
    text(new URL("../../programs/interface.json", import.meta.url)).catch(() => "{}"),
    style(new URL("./program.css", import.meta.url).href),
  ]);
  setInterface(Object.values(JSON.parse(list)).flat());
  byId("setup").after(make("section", { className: "rail program sheet", id: "program", "aria-label": "Program", innerHTML: fragment }));
  const opener = make("button", { type: "button", "data-sheet": "program", "aria-expanded": "false", "aria-controls": "program", innerHTML: '<svg class="icon" aria-hidden="true"><use href="#i-code" /></svg>Program' });
  document.querySelector("#panel-explore .sheet-bar")?.prepend(opener);
  return startProgram(app);
}
