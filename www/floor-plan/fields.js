// @ts-check
// Fields of the Floor plan tab: they show the settings unless they are being edited.
import { changed } from "../dom.js";

/**
 * Shows a value, unless one is typing another one.
 * @param {HTMLInputElement | HTMLSelectElement} field @param {string} value
 */
export function showValue(field, value) {
  if (document.activeElement === field && field instanceof HTMLInputElement && field.type !== "range" && field.value !== "") {
    if (!changed(field, "value", value)) return;
  } else changed(field, "value", value);
  field.value = value;
}

/**
 * A number that was chosen, once it is one.
 * @param {HTMLInputElement} field @param {(value: number) => void} take
 */
export function onNumber(field, take) {
  field.addEventListener("change", () => {
    const value = field.valueAsNumber;
    if (Number.isFinite(value)) take(value);
  });
}

/** A comma that is typed into a number is a point: browsers would leave it out. @param {HTMLElement} within */
export function takeCommas(within) {
  within.addEventListener("beforeinput", (event) => {
    if (!(event.target instanceof HTMLInputElement) || event.target.type !== "number" || !event.data?.includes(",")) return;
    event.preventDefault();
    document.execCommand("insertText", false, event.data.replaceAll(",", "."));
  });
}

/** Without noise of floating point. @param {number} value */
export const plain = (value, digits = 4) => String(Number(value.toPrecision(digits)));
