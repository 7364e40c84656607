// @ts-check
// The canvas of the Floor plan tab: size, pointers, keys. Their effects are decided in the worker.
import { byId, changed, setAttribute, setHidden, setText } from "../dom.js";
import { lowerEnd } from "../shared/corner.js";
import { startHands, startZoom } from "../shared/pan-zoom.js";

/** @typedef {import("./tab.js").FloorPlanTab} FloorPlanTab */

/** @type {Record<string, string>} */
const HINTS = matchMedia("(hover: none)").matches ? {
  // One line each, above the plan.
  scale: "Tap two points whose distance you know.",
  rectangle: "Drag over the part to clean.",
  polygon: "Tap the corners; a double tap closes the polygon.",
  room: "Tap the room to clean.",
} : {
  scale: "Click two points whose distance you know. Keyboard: arrows move the crosshair, Enter sets a point, Escape ends.",
  rectangle: "Drag over the part to clean, or click two corners. Keyboard: arrows and Enter.",
  polygon: "Click the corners; Enter or a double click closes the polygon, Escape cancels it. Keyboard: arrows and Enter, twice to close.",
  room: "Click into the room to clean. Open doors bound it if gaps of their width are closed. Keyboard: arrows and Enter.",
};

/** `onStage` is to be called for every new canvas. @param {FloorPlanTab} it */
export function startCanvas(it) {
  const stage = byId("floor-plan-stage");
  const size = () => {
    const { clientWidth: width, clientHeight: height } = stage;
    if (width > 0 && height > 0) it.client.say({ type: "resize", width, height, ratio: devicePixelRatio });
  };
  new ResizeObserver(size).observe(stage);
  const picture = pictureOf(it);
  const onStage = (/** @type {HTMLCanvasElement} */ canvas) => {
    size();
    /** @param {string} kind @param {number} x @param {number} y */
    const pointer = (kind, x, y) => it.client.say({ type: "pointer", kind, x, y });
    startHands(canvas, picture, {
      pointer,
      hover: ({ x, y }) => pointer("move", x, y),
      hasTool: () => it.view?.tool !== "view",
      key(action, event) {
        it.client.say({ type: "key", action, fine: event.shiftKey });
        // Escape closes other things where no tool is in the hand; whether one is, the worker knows first.
        const isOurs = action !== "escape" || it.view?.tool !== "view";
        if (isOurs) event.stopPropagation();
        return isOurs;
      },
    });
  };
  return {
    onStage,
    /** Messages never lie on the drawing, when all of it is shown: it gives way. */
    clear() {
      const height = lowerEnd(byId("message"), stage);
      const canvas = byId("floor-plan-floor");
      if (changed(canvas, "clear", height)) it.client.say({ type: "clear", height });
    },
    key: startZoom(stage, picture),
  };
}

/** The drawing, as far as hands move it. @param {FloorPlanTab} it @returns {import("../shared/pan-zoom.js").Picture} */
const pictureOf = ({ client }) => ({
  pan: (dx, dy) => client.say({ type: "pan", dx, dy }),
  zoom: (x, y, factor) => client.say({ type: "zoom", x, y, factor }),
  fit: () => client.say({ type: "fit" }),
});

/** The hint for the current tool. @param {import("./types").FloorPlanView | undefined} view */
export function hint(view) {
  const text = view && HINTS[view.tool];
  setHidden(byId("floor-plan-hint"), !text || view?.is_measured === true);
  setText(byId("floor-plan-hint"), text ?? "");
  setAttribute(byId("floor-plan-stage"), "data-tool", view?.tool ?? "view");
}
