// @ts-check
// All names that programs can use, in the language of the program that is shown: made when they are first opened.
import { byId, changed, input, make, typed } from "../dom.js";
import { about, parts } from "./complete.js";

/** Groups of programs/interface.json in words. @type {Record<string, string>} */
const GROUPS = {
  program: "Functions",
  commands: "Commands",
  motions: "Motions, to yield in run",
  sensors: "Sensors",
  odometry: "Odometry and time",
  facts: "Facts about the robot",
  chance: "Chance",
  drawing: "Drawing on the floor",
  room: "The room, for planners",
};

/** @param {() => import("./editor.js").Language} language */
export function startNames(language) {
  const box = typed("program-names", HTMLDetailsElement);
  const search = input("program-names-search");
  const find = () => {
    const wanted = search.value.trim().toLowerCase();
    for (const group of byId("program-names-list").children) {
      const entries = [.../** @type {HTMLElement} */ (group).querySelectorAll(".cm-about")];
      for (const entry of entries) /** @type {HTMLElement} */ (entry).hidden = !entry.textContent?.toLowerCase().includes(wanted);
      const isFound = entries.some((entry) => !(/** @type {HTMLElement} */ (entry).hidden));
      /** @type {HTMLElement} */ (group).hidden = !isFound;
      if (wanted && isFound) /** @type {HTMLDetailsElement} */ (group).open = true;
    }
  };
  const fill = () => {
    if (!box.open || !changed(box, "language", language())) return;
    const groups = Object.entries(GROUPS).map(([group, title]) => {
      const entries = parts().filter((part) => part.group === group);
      return make("details", { className: "program-group" }, make("summary", {}, title), ...entries.map((part) => about(part, language())));
    });
    byId("program-names-list").replaceChildren(...groups);
    find();
  };
  box.addEventListener("toggle", fill);
  search.addEventListener("input", find);
  /** To be called when another program is shown. */
  return fill;
}
