// @ts-check
// The floor: what hands and keys do to it, and its tools.
import { button, byId, typed } from "../dom.js";
import { pickUp, startCarry } from "./carry.js";
import { undo } from "../keep.js";
import { fitSize, startHands, startZoom } from "../shared/pan-zoom.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("../shared/pan-zoom.js").Spot} Spot
 */

/** @param {App} app */
export function startStage(app) {
  const canvas = typed("floor", HTMLCanvasElement);
  const picture = {
    pan: (/** @type {number} */ dx, /** @type {number} */ dy) => app.act((p) => p.pan(dx, dy)),
    zoom: (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ factor) => app.act((p) => p.zoom(x, y, factor)),
    fit: () => app.act((p) => p.fit()),
  };
  startPointers(app, canvas, picture);
  startToolbar(app);
  startCarry(app, canvas);
  return { resized: () => fitSize(canvas, app.playground), key: startZoom(byId("stage"), picture) };
}

/** How far a mouse moves, px, until it leads a robot that is in the hand. */
const LED = 8;

/** @param {App} app @param {HTMLCanvasElement} canvas @param {import("../shared/pan-zoom.js").Picture} picture */
function startPointers(app, canvas, picture) {
  /** Where the pointer lay when a key was pressed: a robot moved by keys isn't taken from there by a trembling mouse. @type {Spot | undefined} */
  let lay;
  let hover = { x: 0, y: 0 };
  addEventListener("keydown", () => (lay = hover));
  const isLed = (/** @type {Spot} */ at) => {
    hover = at;
    if (lay && Math.hypot(at.x - lay.x, at.y - lay.y) < LED) return false;
    lay = undefined;
    return true;
  };
  const hasTool = () => app.view.tool !== "view";

  startHands(canvas, picture, {
    // The effect of a tool is decided in Rust.
    pointer: (kind, x, y, button) => button === 0 && void app.act((p) => p.pointer(kind, x, y)),
    draws: true,
    hasTool,
    // Hovering shows where a tool would act, and carries a robot that is held.
    hover: (at) => (hasTool() || (app.view.is_carried && isLed(at))) && app.act((p) => p.pointer("move", at.x, at.y)),
    key(action) {
      if (app.view.is_carried) return true;
      if (action === "escape" || !hasTool()) return false;
      app.act((p) => p.key_edit(action));
      return true;
    },
  });
}

/** @param {App} app */
function startToolbar(app) {
  for (const node of byId("tools").querySelectorAll("button[data-tool]")) {
    const tool = /** @type {import("../types").FloorTool} */ (node.getAttribute("data-tool"));
    node.addEventListener("click", () => {
      if (tool === "view" || app.view.can.edit) app.act((p) => p.set_tool(tool));
    });
  }
  button("lift").addEventListener("click", () => pickUp(app));
  button("undo").addEventListener("click", () => void undo(app));
  button("redo").addEventListener("click", () => app.view.can.redo && app.act((p) => p.redo()));
  button("planning-cancel").addEventListener("click", () => app.cancelPlanning());
  button("planning-keep").addEventListener("click", () => app.view.can.keep && app.keepPlan());
}
