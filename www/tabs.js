// @ts-check
// The places of the page: tabs above, one of them shown, its name in the address.
import { byId } from "./dom.js";

/** @typedef {"explore" | "compare" | "map" | "draft" | "robot"} Place */

/** @type {Place[]} */
const PLACES = ["explore", "compare", "map", "draft", "robot"];

/** @type {Place} */
let current = "explore";

export const place = () => current;

/** @param {Place} next */
export function go(next) {
  current = next;
  for (const name of PLACES) {
    byId(`place-${name}`).hidden = name !== next;
    const tab = byId(`tab-${name}`);
    if (name === next) tab.setAttribute("aria-current", "page");
    else tab.removeAttribute("aria-current");
  }
  document.body.dataset.place = next;
  // Messages are seen wherever one is.
  byId(`place-${next}`).querySelector(".notices")?.prepend(byId("message"));
}

/** The place that a link leads to. @param {string} link @returns {Place} */
export function placeOf(link) {
  const name = new URLSearchParams(link).get("place");
  return PLACES.find((known) => known === name) ?? "explore";
}

/** @param {(next: Place) => void} enter Goes to a place, once all is there that it needs. */
export function startPlaces(enter) {
  for (const name of PLACES) byId(`tab-${name}`).addEventListener("click", () => enter(name));
}
