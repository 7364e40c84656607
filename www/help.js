// @ts-check
// The text of the dialog Help, loaded when that is first opened.
import { text } from "./parts.js";

/** @type {Promise<string> | undefined} */
let told;

/** @param {HTMLElement} into */
export async function fillHelp(into) {
  told ??= text(new URL("./help.html", import.meta.url));
  try {
    into.innerHTML = await told;
  } catch (error) {
    told = undefined;
    throw error;
  }
}
