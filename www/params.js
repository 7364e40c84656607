// @ts-check
// Forms for parameters, made from their descriptions.
import { fill, make } from "./dom.js";

/** @typedef {import("./types").Param} ParamSpec */

/**
 * The field of one parameter, which reports its value as text, and the controls that show it.
 * @param {ParamSpec} spec
 * @param {(text: string) => void} tell
 * @param {string} scope Makes ids of the same parameter in other forms different.
 * @returns {{ field: HTMLElement, controls: HTMLElement[] }}
 */
export function paramField(spec, tell, scope = "explore") {
  const label = make("span", { className: "label" }, spec.label);
  if (spec.kind === "flag") {
    const box = make("input", { type: "checkbox", onchange: () => tell(String(box.checked)) });
    return { field: make("label", { className: "field check", "data-tip": spec.help }, box, label), controls: [box] };
  }
  if (spec.kind === "choice") {
    const menu = make("select", { onchange: () => tell(menu.value) });
    fill(menu, spec.options ?? []);
    return { field: make("label", { className: "field inline", "data-tip": spec.help }, label, menu), controls: [menu] };
  }
  const limits = { min: String(spec.min ?? 0), max: String(spec.max ?? 1), step: String(spec.step ?? "any") };
  // "map-speed" is the play bar's.
  const id = `${scope}-param-${spec.id}`;
  const box = make("input", { type: "number", id, ...limits, onchange: () => tell(box.value) });
  // The number field is accessible to users who can't see or drag the slider.
  const slider = make("input", {
    type: "range",
    ...limits,
    tabIndex: -1,
    "aria-hidden": "true",
    oninput: () => (box.value = slider.value),
    onchange: () => tell(slider.value),
  });
  const name = make("label", { className: "label", for: id }, spec.label);
  const head = make("span", { className: "param-head" }, name, make("span", { className: "with-unit" }, box, spec.unit ?? ""));
  return { field: make("div", { className: "field number", "data-tip": spec.help }, head, slider), controls: [box, slider] };
}
