// @ts-check
// The menu of layers shown on the floor.
import { button, byId } from "../dom.js";

/** @param {import("../main.js").App} app @returns {(view: import("../types").PageView) => void} */
export function startLayers(app) {
  const menu = byId("layers");
  const opener = button("layers-open");
  const boxes = [...menu.querySelectorAll("input")];
  opener.disabled = false;

  /** @param {boolean} open */
  const show = (open) => {
    menu.hidden = !open;
    opener.setAttribute("aria-expanded", String(open));
    if (open) boxes[0]?.focus();
  };
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
