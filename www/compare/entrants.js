// @ts-check
// Algorithms as they take part: a box to tick, a mark, parameters.
import { changed, make } from "../dom.js";
import { paramField } from "../params.js";

/**
 * @typedef {object} Doings What one can do with an entrant.
 * @property {(takesPart: boolean) => void} choose
 * @property {(param: string, text: string) => void} setParam
 * @property {(() => void) | undefined} [about]
 * @property {(() => void) | undefined} [copy] Adds it once more, to be given other parameters.
 * @property {(() => void) | undefined} [remove]
 */

/** The mark of an algorithm. @param {import("../types").Mark} [mark] */
export function swatch(mark) {
  const node = make("i", { className: "swatch", "aria-hidden": "true" });
  Object.assign(node.dataset, mark);
  return node;
}

/**
 * The name of an algorithm; what tells it from its copies stays when it is cut off.
 * @param {{ title: string, distinction: string } | undefined} entrant
 */
export function nameOf({ title, distinction } = { title: "", distinction: "" }) {
  const start = title.slice(0, title.length - distinction.length);
  return [make("span", { className: "cut" }, start.trimEnd()), ...(distinction ? [make("span", { className: "uncut" }, `\u00a0${distinction}`)] : [])];
}

/**
 * An item of a list of algorithms.
 * @param {{ id: string, title: string, params: import("../types").Param[] }} algorithm
 * @param {HTMLElement} mark
 * @param {string} scope Makes ids different from those of other lists.
 * @param {Doings} doings
 */
export function entrantItem({ id, title, params }, mark, scope, { choose, setParam, about, copy, remove }) {
  const box = make("input", { type: "checkbox", id: `${scope}-${id}`, onchange: () => choose(box.checked) });
  const name = make("label", { for: `${scope}-${id}` }, mark, title);
  const item = make("li", { "data-id": id }, box, name, make("span", { className: "status" }));
  if (about) {
    const button = make("button", { type: "button", className: "quiet square small", "aria-label": `About ${title}`, onclick: about });
    button.innerHTML = '<svg class="icon" aria-hidden="true"><use href="#i-info" /></svg>';
    item.append(button);
  }
  if (params.length > 0) {
    const fields = params.map((spec) => {
      const { field, controls } = paramField(spec, (text) => setParam(spec.id, text), `${scope}-${id}`);
      for (const control of controls) control.dataset.param = spec.id;
      return field;
    });
    const more = make("div", { className: "params" }, ...fields);
    if (copy) more.append(make("button", { type: "button", onclick: copy, "data-tip": "Adds this algorithm once more. Give the copy other parameters to compare the two." }, "Add a copy"));
    if (remove) more.append(make("button", { type: "button", onclick: remove }, "Remove this copy"));
    const fold = make("details", { className: "tuning" }, make("summary", {}, "Parameters"), more);
    // A copy is there for its parameters.
    fold.open = remove !== undefined;
    item.append(fold);
  }
  return item;
}

/** A program can get another name, a copy another value. @param {Element | null | undefined} item @param {string} title */
export function showTitle(item, title) {
  if (item && changed(/** @type {HTMLElement} */ (item), "title", title)) item.querySelector("label")?.lastChild?.replaceWith(title);
}

/**
 * Shows the choices in an item.
 * @param {Element | null | undefined} item
 * @param {{ chosen: boolean, lacks: string, params: Record<string, string | number | boolean> }} entrant `lacks`: why it can't take part.
 */
export function showChoice(item, { chosen, lacks, params }) {
  const box = item?.querySelector("input");
  if (!item || !box) return;
  if (changed(item, "chosen", chosen)) box.checked = chosen;
  if (changed(item, "lacks", lacks)) box.disabled = lacks !== "";
  item.classList.toggle("lacks", lacks !== "");
  if (!changed(item, "params", JSON.stringify(params))) return;
  for (const control of item.querySelectorAll("[data-param]")) {
    const value = params[/** @type {HTMLElement} */ (control).dataset.param ?? ""];
    if (control instanceof HTMLInputElement && control.type === "checkbox") control.checked = value === true;
    else Reflect.set(control, "value", String(value));
  }
}
