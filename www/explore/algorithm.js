// @ts-check
// The algorithm: its menu, its parameters, and what is said about it.
import { byId, changed, make, select, setText } from "../dom.js";
import { explain } from "../explainer.js";
import { paramField } from "../params.js";

/**
 * @typedef {import("../types").PageView} View
 * @typedef {import("../types").CatalogueEntry} AlgorithmEntry
 */

/** Parameters beyond these fold away. */
const FEW = 2;
/** Milliseconds for which browsers take letters typed in a menu as one word. */
const WORD = 1000;
/** The menu's entry for a path from the tab Floor plan. */
const PATH = "path";

/** Returns what shows the algorithm, and says what it is called. @param {import("../main.js").App} app @param {import("./form.js").Form} form @returns {(view: View) => string} */
export function startAlgorithm({ catalogue }, form) {
  const { rooms, planners, behaviours } = catalogue;
  const algorithms = [...planners, ...behaviours];
  const menu = select("algorithm");
  menu.replaceChildren(group("Path planners", planners), group("Reactive behaviours", behaviours));
  form.bind("algorithm", (p, id) => p.select_algorithm(id));
  // From then on the keys drive, and don't go on in the menu; but the letters that chose it there may not be the last ones.
  let isTyped = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let typing;
  const drive = () => {
    if (document.activeElement === menu && behaviours.some(({ id, manual }) => manual && id === menu.value)) byId("floor").focus();
    typing = undefined;
  };
  const wait = () => {
    clearTimeout(typing);
    typing = setTimeout(drive, WORD);
  };
  menu.addEventListener("keydown", (event) => {
    isTyped = event.key.length === 1;
    if (typing === undefined) return;
    if (isTyped) return wait();
    clearTimeout(typing);
    // Tab goes on from here.
    if (event.key === "Tab") return;
    event.preventDefault();
    drive();
  });
  menu.addEventListener("pointerdown", () => (isTyped = false));
  menu.addEventListener("change", () => (isTyped ? wait() : drive()));

  /** @param {View} view */
  const showMenu = ({ algorithm, path_corners, program }) => {
    if (program && changed(menu, "program", `${algorithm} ${program.name}`)) {
      menu.querySelector("option[value^=program]")?.remove();
      menu.prepend(new Option(`Your program: ${program.name}`, algorithm));
      form.refresh(menu);
    }
    if (changed(menu, "path", path_corners > 0)) {
      menu.querySelector(`option[value=${PATH}]`)?.remove();
      if (path_corners) menu.prepend(new Option("Path from Floor plan", PATH));
      form.refresh(menu);
    }
    form.show(menu, path_corners ? PATH : algorithm);
  };

  /** @type {Map<string, HTMLElement[]>} */
  let controls = new Map();
  let title = "";

  /** @param {AlgorithmEntry["params"]} params */
  const buildParams = (params) => {
    controls = new Map();
    const fields = params.map((spec) => {
      const built = paramField(spec, (text) => form.change((p) => p.set_param(spec.id, text)));
      controls.set(spec.id, built.controls);
      return built.field;
    });
    byId("params").replaceChildren(...fields.slice(0, FEW));
    byId("params-more").replaceChildren(...fields.slice(FEW));
  };

  /** @param {AlgorithmEntry} algorithm @param {number} corners Of the planned path; 0 without one. */
  const showAlgorithm = (algorithm, corners) => {
    buildParams(corners ? [] : algorithm.params);
    title = corners ? "Planned path" : algorithm.title;
    setText(byId("algorithm-kind"), corners ? "planned path" : algorithm.manual ? "you drive" : algorithm.kind === "planner" ? "path planner" : "reactive behaviour");
    setText(byId("algorithm-note"), corners ? `Planned in the tab Floor plan: ${corners.toLocaleString("en")} corners, driven as they are` : algorithm.summary);
    setText(byId("explainer-title"), algorithm.title);
    void explain(byId("explainer-text"), algorithm, rooms, (room) => form.change((p) => p.select_room(room)));
  };

  /** @param {string} name */
  const showProgram = (name) => {
    buildParams([]);
    title = name;
    setText(byId("algorithm-kind"), "your program");
    setText(byId("algorithm-note"), "");
    setText(byId("explainer-title"), name);
    byId("explainer-text").dataset.about = "program";
    byId("explainer-text").replaceChildren(make("p", {}, "Your own program. Read and change it in the tab Program."));
  };

  return (view) => {
    showMenu(view);
    const algorithm = algorithms.find(({ id }) => id === view.algorithm);
    const isNew = changed(byId("params"), "algorithm", `${view.algorithm} ${view.program?.name ?? view.path_corners}`);
    if (isNew && view.program) showProgram(view.program.name);
    else if (isNew && algorithm) showAlgorithm(algorithm, view.path_corners);
    for (const [id, of] of controls) {
      const value = view.params[id];
      if (value !== undefined) for (const control of of) form.show(control, String(value));
    }
    return title;
  };
}

/** @param {string} label @param {AlgorithmEntry[]} entries */
function group(label, entries) {
  return make("optgroup", { label }, ...entries.map(({ id, title }) => make("option", { value: id }, title)));
}
