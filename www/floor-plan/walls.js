// @ts-check
// How lines or shades become walls, and which part of the drawing is meant.
import { byId, fill, input, select, setAttribute, setHidden, setText } from "../dom.js";
import { hint } from "./canvas.js";
import { showValue } from "./fields.js";

/** Sides of the room's cells, m; as in crates/robovac-app/src/floor_plan/settings.rs. */
const CELLS = [0.01, 0.02, 0.025, 0.05, 0.1, 0.2, 0.5];

/** @param {import("./types").FloorPlanView} view */
const closesDoors = ({ settings }) => ["indoors", "whole"].includes(settings.part.kind);

/**
 * Whether openings as wide as outer doors are closed: only another width has a slider, as the panel has to fit on a laptop.
 * @param {import("./types").FloorPlanView} view
 */
const hasUsualDoors = (view) => closesDoors(view) && view.settings.outer === view.outer_door;

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startWalls(it) {
  const [gap, outer, shade, contrast, specks, negate] = ["gap", "outer", "shade", "contrast", "specks", "negate"].map((name) => input(`floor-plan-${name}`));
  const [cell, method] = [select("floor-plan-cell"), select("floor-plan-method")];
  fill(cell, CELLS.map((side) => [String(side), `${100 * side} cm`]));
  const told = () => {
    for (const range of [gap, outer]) setText(byId(`${range.id}-value`), range.valueAsNumber ? `${range.valueAsNumber.toFixed(2)} m` : "none");
    const { view } = it;
    if (view && hasUsualDoors(view) && gap.valueAsNumber < view.outer_door) {
      const inner = gap.valueAsNumber ? gap.valueAsNumber.toFixed(2) : "none";
      // As long as the scale is the assumed one, the front door is closed, however wide it is.
      setText(byId("floor-plan-gap-value"), view.assumed_pixel ? `${inner}${gap.valueAsNumber ? " m" : ""}, outer doors` : `${inner}, outer ${view.outer_door} m`);
    }
    for (const [name, range] of /** @type {const} */ ([["shade", shade], ["contrast", contrast]])) setText(byId(`floor-plan-${name}-value`), `${Math.round(100 * range.valueAsNumber)} %`);
    setText(byId("floor-plan-specks-value"), specks.valueAsNumber ? `${Math.round(100 * specks.valueAsNumber)} cm` : "none");
  };
  for (const range of [gap, outer, shade, contrast, specks]) range.addEventListener("input", told);
  // The picture follows the hand, one change after the other.
  let isSetting = false;
  const follow = async (/** @type {"shade" | "contrast"} */ name, /** @type {HTMLInputElement} */ range) => {
    if (isSetting) return;
    isSetting = true;
    for (let last = NaN; last !== range.valueAsNumber; ) {
      last = range.valueAsNumber;
      await it.set({ [name]: last });
    }
    isSetting = false;
  };
  shade.addEventListener("input", () => void follow("shade", shade));
  contrast.addEventListener("input", () => void follow("contrast", contrast));
  gap.addEventListener("change", () => void it.set({ gap: gap.valueAsNumber }));
  outer.addEventListener("change", () => void it.set({ outer: outer.valueAsNumber }));
  specks.addEventListener("change", () => void it.set({ specks: specks.valueAsNumber }));
  method.addEventListener("change", () => void it.set({ method: /** @type {import("./types").ShadeMethod} */ (method.value) }));
  cell.addEventListener("change", () => void it.set({ resolution: Number(cell.value) }));
  negate.addEventListener("change", () => void it.set({ negate: negate.checked }));

  const buttons = [...byId("floor-plan-parts").querySelectorAll("button")];
  for (const node of buttons) {
    const part = node.dataset.part ?? "";
    node.addEventListener("click", () => {
      if (part === "whole" || part === "indoors") {
        it.client.say({ type: "tool", tool: "view" });
        return void it.set({ part: { kind: part } });
      }
      it.client.say({ type: "tool", tool: /** @type {import("./types").DrawingTool} */ (part) });
      it.toCanvas(true);
    });
  }

  return (view) => {
    hint(view);
    if (!view) return;
    const { kind, settings, tool } = view;
    const [isDrawing, isImage] = [kind === "drawing", kind === "image"];
    const hidden = { "layer-group": !isDrawing, "part-group": kind === "map", "wall-group": kind === "map", "cell-field": !view.has_cells, "method-field": !isImage };
    const own = isImage && settings.method !== "map";
    const more = { "gap-field": !isDrawing && !own, "outer-field": !closesDoors(view) || hasUsualDoors(view) || (!isDrawing && !own), "shade-field": !isImage || settings.method !== "level", "contrast-field": !isImage || settings.method !== "local", "specks-field": !own, "negate-field": !isImage, "shade-key": !own };
    for (const [id, isHidden] of Object.entries({ ...hidden, ...more })) setHidden(byId(`floor-plan-${id}`), isHidden);
    showValue(gap, String(settings.gap));
    // What is as wide as a gap that is closed is closed, too.
    showValue(outer, String(Math.max(settings.outer, settings.gap)));
    if (!isSetting) {
      showValue(shade, String(settings.shade));
      showValue(contrast, String(settings.contrast));
    }
    showValue(specks, String(settings.specks));
    showValue(cell, String(settings.resolution));
    showValue(method, settings.method);
    negate.checked = settings.negate;
    told();
    const isTaking = ["rectangle", "polygon", "room"].includes(tool);
    for (const node of buttons) setAttribute(node, "aria-pressed", String(node.dataset.part === (isTaking ? tool : settings.part.kind)));
  };
}
