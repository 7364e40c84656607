// @ts-check
// Light, dark, or as the system has it.
import { button } from "./dom.js";

const ORDER = /** @type {const} */ (["system", "light", "dark"]);

/**
 * Wires the theme button; calls `apply` now and whenever the page turns dark or light.
 * @param {(dark: boolean) => void} apply
 */
export function startTheme(apply) {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const toggle = button("theme");
  const root = document.documentElement;
  let chosen = ORDER.find((name) => name === root.dataset.theme) ?? "system";

  const show = () => {
    if (chosen === "system") delete root.dataset.theme;
    else root.dataset.theme = chosen;
    const label = `Colours: ${chosen === "system" ? "as the system" : chosen}`;
    toggle.setAttribute("aria-label", label);
    toggle.title = label;
    apply(chosen === "system" ? system.matches : chosen === "dark");
  };

  toggle.addEventListener("click", () => {
    // The first click always changes the visible theme.
    const seen = system.matches ? "dark" : "light";
    const other = system.matches ? "light" : "dark";
    chosen = chosen === "system" ? other : chosen === other ? seen : "system";
    try {
      localStorage.setItem("theme", chosen);
    } catch {
      // Without storage the choice lasts as long as the page.
    }
    show();
  });
  system.addEventListener("change", show);
  show();
}
