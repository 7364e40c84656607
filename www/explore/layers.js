// @ts-check
// The menu of layers shown on the floor.
import { button, byId, make } from "../dom.js";

/** @type {[layer: string, title: string, tip: string][]} */
const LAYERS = [
  ["coverage", "Coverage", "How often each spot was swept."],
  ["dirt", "Dirt", "Dirt left on the floor."],
  ["sensors", "Sensors", "Where the sensors measure: points for cliff sensors, rays for light bumper and laser."],
  ["estimate", "Estimated trail", "Pose and trail estimated from wheel counts, next to the true ones."],
];

/** @param {import("../main.js").App} app @param {boolean} isWanted Opens the menu at once. @returns {(view: import("../types").PageView) => void} */
export function startLayers(app, isWanted) {
  const menu = byId("layers");
  const opener = button("layers-open");
  const boxes = LAYERS.map(([layer]) => make("input", { type: "checkbox", "data-layer": layer }));
  menu.append(...boxes.map((box, i) => make("label", { className: "check", "data-tip": LAYERS[i]?.[2] ?? "" }, box, make("span", { className: "label" }, LAYERS[i]?.[1] ?? ""))));

  /** @param {boolean} open */
  const show = (open) => {
    menu.hidden = !open;
    opener.setAttribute("aria-expanded", String(open));
    if (open) boxes[0]?.focus();
  };
  if (isWanted) show(true);
  opener.addEventListener("click", () => show(menu.hidden === true));
  document.addEventListener("pointerdown", ({ target }) => {
    if (!menu.hidden && target instanceof Node && !menu.contains(target) && !opener.contains(target)) show(false);
  });
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    show(false);
    opener.focus();
  });
  for (const box of boxes) box.addEventListener("change", () => app.act((p) => p.show(box.dataset.layer ?? "", box.checked)));

  return ({ shows }) => {
    for (const box of boxes) {
      const on = shows[/** @type {keyof typeof shows} */ (box.dataset.layer)];
      if (box.checked !== on) box.checked = on;
    }
  };
}
