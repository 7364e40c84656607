// @ts-check
// How large it is: the unit of a drawing, the scale of an image, two points of a known distance.
import { button, byId, changed, fill, input, make, select, setAttribute, setHidden, setText, typed } from "../dom.js";
import { onNumber, plain, showValue } from "./fields.js";

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startScale(it) {
  const [unit, pixel, tool] = [select("floor-plan-unit"), input("floor-plan-pixel"), button("floor-plan-scale")];
  unit.addEventListener("change", () => Number(unit.value) > 0 && void it.set({ metre: Number(unit.value) }));
  onNumber(pixel, (centimetres) => void it.set({ metre: ((it.view?.reduced ?? 1) * centimetres) / 100 }));
  tool.addEventListener("click", () => {
    it.client.say({ type: "tool", tool: it.view?.tool === "scale" ? "view" : "scale" });
    it.toCanvas(true);
  });
  const form = typed("floor-plan-distance-form", HTMLFormElement);
  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    const metres = input("floor-plan-distance").valueAsNumber;
    await it.ask({ type: "scale", metres }, "Tracing the room");
    it.toCanvas(false);
  });
  button("floor-plan-distance-cancel").addEventListener("click", () => it.client.say({ type: "tool", tool: "view" }));

  return (view) => {
    if (!view) return;
    const { settings, units, kind, is_scalable, reduced } = view;
    setHidden(byId("floor-plan-unit-field"), units.length === 0);
    setHidden(byId("floor-plan-pixel-field"), kind === "drawing" || !is_scalable);
    setText(byId("floor-plan-pixel-label"), kind === "image" ? "A pixel is" : "A cell is");
    setHidden(byId("floor-plan-scale"), !is_scalable);
    setText(byId("floor-plan-scale-note"), note(view));
    setAttribute(byId("floor-plan-unit-field"), "data-open", String(kind === "drawing" && settings.metre === null));

    const known = units.find(({ metre }) => metre === settings.metre);
    const own = settings.metre !== null && !known ? `1 ${kind === "drawing" ? "unit" : "pixel"} = ${plain(settings.metre / reduced)} m` : "";
    if (changed(unit, "options", JSON.stringify([units, own, settings.metre === null]))) {
      fill(unit, units.map(({ name, metre, size }) => [String(metre), `${name}: ${size}`]));
      if (settings.metre === null) unit.prepend(make("option", { value: "" }, "Choose…"));
      if (own) unit.prepend(make("option", { value: String(settings.metre) }, own));
    }
    unit.value = settings.metre === null ? "" : String(settings.metre);
    if (settings.metre !== null) showValue(pixel, plain((100 * settings.metre) / reduced));

    setAttribute(tool, "aria-pressed", String(view.tool === "scale"));
    const wasHidden = form.hidden;
    setHidden(form, !view.is_measured);
    if (wasHidden && view.is_measured) {
      openSheetOf(form);
      const distance = input("floor-plan-distance");
      distance.value = view.measured_m ? plain(view.measured_m, 3) : "";
      distance.focus();
      distance.select();
    }
  };
}

/** Where panels are sheets, opens the one in which `node` is. @param {HTMLElement} node */
function openSheetOf(node) {
  const opener = document.querySelector(`[data-sheet="${node.closest(".sheet")?.id}"][aria-expanded=false]`);
  if (opener instanceof HTMLElement && opener.checkVisibility()) opener.click();
}

/** @param {import("./types").FloorPlanView} view */
function note({ kind, settings, is_scalable, assumed_pixel }) {
  if (!is_scalable) return "A scenario is measured in metres.";
  if (kind === "drawing") return settings.metre === null ? "The file doesn't give its unit. Choose the one that gives the right size, or scale it by two points." : "";
  return assumed_pixel && `The image doesn't give its scale: ${assumed_pixel} a pixel is assumed. Scale it by two points whose distance you know.`;
}
