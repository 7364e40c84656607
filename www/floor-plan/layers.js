// @ts-check
// The layers of a drawing, with what each of them is.
import { byId, changed, fill, make } from "../dom.js";

/** @type {[value: import("./types").Role, label: string][]} */
const ROLES = [["wall", "Wall"], ["obstacle", "Obstacle"], ["ignored", "Ignored"]];

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startLayers(it) {
  const table = byId("floor-plan-layers");
  /** @type {HTMLSelectElement[]} */
  let menus = [];
  return (view) => {
    if (!view) return;
    const list = view.layers.map(({ name, colour, strokes }) => `${name} ${colour} ${strokes}`).join("\n");
    if (changed(table, "layers", `${view.name}\n${list}`)) {
      menus = [];
      table.replaceChildren(
        ...view.layers.map(({ name, colour, strokes }, index) => {
          const menu = make("select", { "aria-label": `What ${name} is` });
          fill(menu, ROLES);
          menu.addEventListener("change", () => {
            const roles = [...(it.wanted()?.roles ?? [])];
            roles[index] = /** @type {import("./types").Role} */ (menu.value);
            void it.set({ roles });
          });
          menus.push(menu);
          const swatch = make("i", { className: "floor-plan-swatch", "aria-hidden": "true" });
          swatch.style.background = colour;
          const title = make("th", { scope: "row", title: name }, swatch, make("span", {}, name));
          return make("tr", {}, title, make("td", {}, strokes.toLocaleString("en")), make("td", {}, menu));
        }),
      );
    }
    menus.forEach((menu, index) => (menu.value = view.layers[index]?.role ?? "ignored"));
  };
}
