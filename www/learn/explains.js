// @ts-check
// Which lesson explains a number or control, by the label that it has on the page.
import { lessons } from "./source.js";

/** @param {string} text */
const plain = (text) => text.replace(/,.*/, "").trim().toLowerCase();

/** The lesson that explains what has this definition, with its number. @param {Element} owner */
export async function lessonOf(owner) {
  const label = plain((owner.querySelector(".term, .label") ?? owner).firstChild?.textContent ?? "");
  const all = await lessons();
  const at = all.findIndex(({ explains }) => explains.some((name) => name.toLowerCase() === label));
  const lesson = all[at];
  return lesson && { number: at + 1, ...lesson };
}
