// @ts-check
// The menu of the shelf: opened by its button, walked by arrow keys, closed by Escape or a press elsewhere.
import { button, byId } from "../dom.js";
import { complain, textOf } from "../messages.js";

/** @param {Record<string, () => unknown>} doings What each item does, by its id. */
export function startMenu(doings) {
  const [menu, opener] = [byId("program-menu"), button("program-more")];
  const items = () => [...menu.querySelectorAll("button")].filter((item) => !item.disabled && !item.hidden);
  const open = (/** @type {boolean} */ isOpen) => {
    menu.hidden = !isOpen;
    opener.setAttribute("aria-expanded", String(isOpen));
    if (isOpen) items()[0]?.focus();
  };
  opener.addEventListener("click", () => open(menu.hidden === true));
  menu.addEventListener("keydown", (event) => {
    const [all, step] = [items(), { ArrowDown: 1, ArrowUp: -1 }[event.key] ?? 0];
    if (event.key === "Escape") {
      open(false);
      opener.focus();
    } else if (step) all[(all.findIndex((item) => item === document.activeElement) + step + all.length) % all.length]?.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  document.addEventListener("pointerdown", ({ target }) => target instanceof Node && !menu.contains(target) && !opener.contains(target) && open(false));
  for (const [id, what] of Object.entries(doings)) {
    button(id).addEventListener("click", () => {
      open(false);
      opener.focus();
      void Promise.resolve(what()).catch((error) => complain(textOf(error)));
    });
  }
}
