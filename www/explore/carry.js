// @ts-check
// The robot in the hand: picked up, carried by keys, put down. Carrying by pointer is decided in Rust.
import { byId } from "../dom.js";

/** @typedef {import("../main.js").App} App */

/** @type {Record<string, string>} */
const MOVES = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Enter: "apply", Escape: "back" };
/** With the shift key. @type {Record<string, string>} */
const TURNS = { ArrowLeft: "turn_left", ArrowRight: "turn_right" };

/** Picks the robot up, or puts it down. @param {App} app */
export function pickUp(app) {
  const { can, is_lifted } = app.view;
  if (!can.lift && !is_lifted) return false;
  const worked = app.act((p) => (p.set_tool("view"), p.pick_up()));
  if (!is_lifted) byId("floor").focus();
  return worked;
}

/** @param {App} app @param {HTMLCanvasElement} canvas */
export function startCarry(app, canvas) {
  document.addEventListener(
    "keydown",
    (event) => {
      if (!app.view.is_carried || event.ctrlKey || event.metaKey || event.altKey) return;
      // Escape puts it back, whatever has the focus.
      const isHere = event.target === canvas || event.key === "Escape";
      const action = isHere && (event.shiftKey ? TURNS : MOVES)[event.key];
      if (!action) return;
      event.preventDefault();
      event.stopPropagation();
      app.act((p) => p.carry(action));
    },
    { capture: true },
  );
}
