// @ts-check
// On a small screen the panels are sheets over the floor, one at a time.
import { byId } from "./dom.js";

/** Puts a sheet away that hides what was asked for. @param {string} id */
export function dismissSheet(id) {
  const close = document.querySelector(`#${id}.open .sheet-close`);
  if (close instanceof HTMLElement) close.click();
  return close !== null;
}

/** @param {HTMLElement} root The tab whose panels they are; some come later. @param {HTMLElement} floor */
export function startSheets(root, floor) {
  const openers = () => [...root.querySelectorAll("button[data-sheet]")];

  /** @param {string} name The sheet to show, "" for none. */
  const open = (name) => {
    for (const opener of openers()) {
      const id = opener.getAttribute("data-sheet") ?? "";
      const isOpen = id === name;
      byId(id).classList.toggle("open", isOpen);
      // Panels that fold beside the floor are always open in a sheet.
      const fold = isOpen && byId(id).querySelector("details.fold");
      if (fold instanceof HTMLDetailsElement) fold.open = true;
      opener.setAttribute("aria-expanded", String(isOpen));
    }
  };
  const current = () => openers().find((opener) => opener.getAttribute("aria-expanded") === "true");

  // A sheet that is swiped down.
  root.addEventListener("swiped", () => open(""));
  const close = () => {
    const opener = current();
    open("");
    if (opener instanceof HTMLElement) opener.focus();
  };

  root.addEventListener("click", ({ target }) => {
    const pressed = target instanceof Element && target.closest("button[data-sheet], .sheet-close");
    if (!pressed) return;
    if (pressed.matches(".sheet-close")) return close();
    const name = pressed === current() ? "" : (pressed.getAttribute("data-sheet") ?? "");
    open(name);
    if (name) byId(name).querySelector("button")?.focus();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && current()) close();
  });
  floor.addEventListener("pointerdown", () => open(""));
}
