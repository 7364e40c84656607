// @ts-check
// Objects on the floor: what is placed, what is selected, and the keys and buttons for it. Dragging is decided in Rust.
import { byId, changed, fill, select, setAttribute, setEnabled, setHidden, setText } from "./dom.js";

/**
 * @typedef {import("./main.js").App} App
 * @typedef {import("./types").View} View
 */

/** What keys do with the selected object. @type {Record<string, string>} */
const MOVES = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Delete: "delete", Backspace: "delete" };
/** With the shift key. @type {Record<string, string>} */
const SHAPES = { ArrowLeft: "turn_left", ArrowRight: "turn_right", ArrowUp: "larger", ArrowDown: "smaller" };

/** @param {App} app @returns {(view: View) => void} */
export function startObjects(app) {
  const canvas = byId("floor");
  const kinds = [...byId("kinds").querySelectorAll("button")];
  for (const node of kinds) {
    node.addEventListener("click", () => app.act((p) => p.set_placing(node.dataset.kind ?? "")));
  }
  const edits = [...byId("selection").querySelectorAll("button")];
  for (const node of edits) {
    node.addEventListener("click", () => {
      if (app.view.selected < 0) return;
      const action = node.dataset.edit ?? "";
      app.act((p) => p.edit_selected(action));
      // The bar may be gone by then.
      if (action === "delete") canvas.focus();
    });
  }
  const menu = select("selected");
  menu.addEventListener("change", () => app.act((p) => p.select_object(menu.value === "" ? undefined : Number(menu.value))));

  const isDriving = () => app.view.tool === "view" && app.catalogue.behaviours.some(({ id, manual }) => manual && id === app.view.algorithm);
  canvas.addEventListener(
    "keydown",
    (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || app.view.selected < 0) return;
      const action = (event.shiftKey ? SHAPES : MOVES)[event.key];
      // Whoever drives by hand drives: objects are moved with the tool that places them.
      if (isDriving() && event.key.startsWith("Arrow")) return;
      if (event.key === "Escape") app.act((p) => p.select_object(undefined));
      else if (action) app.act((p) => p.edit_selected(action));
      else return;
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    { capture: true },
  );

  /** @type {string[]} */
  let names = [];
  return (view) => {
    const { tool, objects, placing, selected } = view;
    setHidden(byId("kinds"), tool !== "place");
    for (const node of kinds) setAttribute(node, "aria-pressed", String(node.dataset.kind === placing));
    setHidden(byId("selection"), objects.length === 0 || (selected < 0 && tool !== "place"));
    if (changed(menu, "names", objects.join())) {
      names = numbered(objects);
      fill(menu, [["", "Nothing selected"], ...names.map((name, index) => /** @type {[string, string]} */ ([String(index), name]))]);
      changed(menu, "selected", undefined);
    }
    if (changed(menu, "selected", selected)) {
      menu.value = selected < 0 ? "" : String(selected);
      const name = names[selected];
      setText(byId("selection-said"), name ? `${name} selected. Arrow keys move it, with shift they turn and resize it, delete removes it.` : "");
    }
    for (const node of edits) setEnabled(node, selected >= 0);
    for (const node of document.querySelectorAll("[data-object]")) {
      setHidden(/** @type {HTMLElement} */ (node), !objects.includes(node.getAttribute("data-object") ?? ""));
    }
  };
}

/** Names of objects; those that share one are numbered. @param {string[]} objects */
function numbered(objects) {
  /** @type {Map<string, number>} */
  const seen = new Map();
  return objects.map((name) => {
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    const shown = name[0]?.toUpperCase() + name.slice(1);
    return objects.indexOf(name) === objects.lastIndexOf(name) ? shown : `${shown} ${count}`;
  });
}

/** Single keys for objects; says whether this was one. @param {App} app @param {string} key */
export function objectKey(app, key) {
  if (key === "o") return app.view.can.edit && app.act((p) => p.set_tool("place"));
  if (key !== "n" || app.view.objects.length === 0) return false;
  byId("floor").focus();
  return app.act((p) => p.select_next());
}
