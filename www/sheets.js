// @ts-check
// On a small screen the panels are sheets over the floor, one at a time.
import { byId } from "./dom.js";

/** @param {ParentNode} root The tab whose panels they are. @param {HTMLElement} floor */
export function startSheets(root, floor) {
  // Some come with their tab.
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
    if (!(target instanceof Element)) return;
    if (target.closest(".sheet-close")) return close();
    const opener = target.closest("button[data-sheet]");
    if (!opener) return;
    const name = opener === current() ? "" : (opener.getAttribute("data-sheet") ?? "");
    open(name);
    if (name) byId(name).querySelector("button")?.focus();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && current()) close();
  });
  floor.addEventListener("pointerdown", () => open(""));
}
