// @ts-check
// Objects on the floor: the keys for them, and the legend of those that are there. Dragging is decided in Rust.
import { byId, setHidden } from "../dom.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("../types").PageView} View
 */

/** Actions of keys on the selected object. @type {Record<string, string>} */
const MOVES = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Delete: "delete", Backspace: "delete" };
/** With the shift key. @type {Record<string, string>} */
const SHAPES = { ArrowLeft: "turn_left", ArrowRight: "turn_right", ArrowUp: "larger", ArrowDown: "smaller" };

/** @param {App} app @returns {(view: View) => void} */
export function startObjects(app) {
  const isDriving = () => app.view.tool === "view" && app.catalogue.behaviours.some(({ id, manual }) => manual && id === app.view.algorithm);
  byId("floor").addEventListener(
    "keydown",
    (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || app.view.selected < 0) return;
      const action = (event.shiftKey ? SHAPES : MOVES)[event.key];
      // In manual driving keys drive; objects are then moved with the tool that places them.
      if (isDriving() && event.key.startsWith("Arrow")) return;
      if (event.key === "Escape") app.act((p) => p.select_object(undefined));
      else if (action) app.act((p) => p.edit_selected(action));
      else return;
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    { capture: true },
  );

  return ({ objects }) => {
    for (const node of document.querySelectorAll("[data-object]")) {
      setHidden(/** @type {HTMLElement} */ (node), !objects.includes(node.getAttribute("data-object") ?? ""));
    }
  };
}

/** Single keys for objects; says whether this was one. @param {App} app @param {string} key */
export function objectKey(app, key) {
  if (key === "o") return app.view.can.edit && app.act((p) => p.set_tool("place"));
  if (key !== "n" || app.view.objects.length === 0) return false;
  byId("floor").focus();
  return app.act((p) => p.select_next());
}
