// @ts-check
// How lines or shades become walls, and which part of the drawing is meant.
import { byId, fill, input, select, setAttribute, setHidden, setText } from "../dom.js";
import { hint } from "./canvas.js";
import { showValue } from "./fields.js";

/** Sides of the room's cells, m; as in crates/robovac-app/src/floor_plan/settings.rs. */
const CELLS = [0.01, 0.02, 0.025, 0.05, 0.1, 0.2, 0.5];

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startWalls(it) {
  const [gap, cell, shade, negate] = [input("floor-plan-gap"), select("floor-plan-cell"), input("floor-plan-shade"), input("floor-plan-negate")];
  fill(cell, CELLS.map((side) => [String(side), `${100 * side} cm`]));
  const told = () => {
    setText(byId("floor-plan-gap-value"), gap.valueAsNumber ? `${gap.valueAsNumber.toFixed(2)} m` : "none");
    setText(byId("floor-plan-shade-value"), `${Math.round(100 * shade.valueAsNumber)} %`);
  };
  for (const range of [gap, shade]) range.addEventListener("input", told);
  gap.addEventListener("change", () => void it.set({ gap: gap.valueAsNumber }));
  shade.addEventListener("change", () => void it.set({ shade: shade.valueAsNumber }));
  cell.addEventListener("change", () => void it.set({ resolution: Number(cell.value) }));
  negate.addEventListener("change", () => void it.set({ negate: negate.checked }));

  const buttons = [...byId("floor-plan-parts").querySelectorAll("button")];
  for (const node of buttons) {
    const part = node.dataset.part ?? "";
    node.addEventListener("click", () => {
      if (part === "whole") {
        it.client.say({ type: "tool", tool: "view" });
        return void it.set({ part: { kind: "whole" } });
      }
      it.client.say({ type: "tool", tool: /** @type {import("./types").DrawingTool} */ (part) });
      it.toCanvas(true);
    });
  }

  return (view) => {
    hint(view);
    if (!view) return;
    const { kind, settings, tool } = view;
    for (const id of ["floor-plan-layer-group", "floor-plan-part-group", "floor-plan-gap-field", "floor-plan-cell-field"]) setHidden(byId(id), kind !== "drawing");
    setHidden(byId("floor-plan-wall-group"), kind === "map");
    for (const id of ["floor-plan-shade-field", "floor-plan-negate-field"]) setHidden(byId(id), kind !== "image");
    showValue(gap, String(settings.gap));
    showValue(shade, String(settings.shade));
    showValue(cell, String(settings.resolution));
    negate.checked = settings.negate;
    told();
    const isTaking = ["rectangle", "polygon", "room"].includes(tool);
    for (const node of buttons) setAttribute(node, "aria-pressed", String(node.dataset.part === (isTaking ? tool : settings.part.kind)));
  };
}
