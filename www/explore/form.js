// @ts-check
// The controls of the forms: each shows what holds, except while it is being edited.
import { byId, input } from "../dom.js";

/** @typedef {import("../main.js").App["playground"]} Playground */
/** @typedef {ReturnType<typeof startForm>} Form */

/** @param {import("../main.js").App} app */
export function startForm({ act }) {
  /** What was last shown. @type {Map<HTMLElement, string>} */
  const shown = new Map();

  /** @param {(p: Playground) => void} what */
  const change = (what) => {
    // A refused value goes back to what holds.
    if (!act(what)) shown.clear();
  };

  return {
    change,
    /** @param {string} id @param {(p: Playground, value: string) => void} set */
    bind(id, set) {
      const control = byId(id);
      control.addEventListener("change", () => change((p) => set(p, Reflect.get(control, "value"))));
    },
    /** @param {string} id @param {(p: Playground, on: boolean) => void} set */
    bindBox(id, set) {
      input(id).addEventListener("change", () => change((p) => set(p, input(id).checked)));
    },
    /** Shows a value, if it differs from the one that was last shown. @param {HTMLElement} control @param {string} value */
    show(control, value) {
      if (shown.get(control) === value) return;
      shown.set(control, value);
      if (control instanceof HTMLInputElement && control.type === "checkbox") control.checked = value === "true";
      else Reflect.set(control, "value", value);
    },
    /** Shows the value of a control again whatever it displays, or those of all. @param {HTMLElement} [control] */
    refresh(control) {
      if (control) shown.delete(control);
      else shown.clear();
    },
  };
}
