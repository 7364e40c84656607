// @ts-check
// Questions before something that can't be taken back.
import { button, byId, make, setHidden, setText, typed } from "../dom.js";

/**
 * @typedef {object} Question
 * @property {string} title
 * @property {string[]} points
 * @property {string} yes
 * @property {string} [other] Another way to go on.
 * @property {string} [no]
 * @property {boolean} [isWarning]
 */

/** Asks; resolves to whether the answer was yes. @param {Question} question @returns {Promise<boolean>} */
export const ask = async (question) => (await choose(question)) === "yes";

/** Asks; resolves to the answer: "yes", "other" or "no". @param {Question} question @returns {Promise<string>} */
export function choose({ title, points, yes, other = "", no = "Cancel", isWarning = false }) {
  const dialog = typed("connection-ask", HTMLDialogElement);
  setText(byId("connection-ask-title"), title);
  const items = points.map((point) => make("li", {}, point));
  byId("connection-ask-text").replaceChildren(make("ul", { className: "connection-list" }, ...items));
  setText(button("connection-ask-yes"), yes);
  setText(button("connection-ask-other"), other);
  setHidden(button("connection-ask-other"), other === "");
  setText(button("connection-ask-no"), no);
  setHidden(button("connection-ask-no"), no === "");
  dialog.classList.toggle("warning", isWarning);
  dialog.returnValue = "no";
  dialog.showModal();
  // The harmless answer is nearest to a key that was pressed too often.
  (no === "" ? button("connection-ask-yes") : button("connection-ask-no")).focus();
  return new Promise((resolve) => dialog.addEventListener("close", () => resolve(dialog.returnValue), { once: true }));
}

const READ = "connection-safety";

/** Safety notes before the first connection to a real robot. @returns {Promise<boolean>} */
export async function readSafety() {
  if (kept(READ)) return true;
  const agreed = await ask({
    title: "Before it moves",
    points: [
      "Put it on the floor in the middle of a room, never on a table, and away from stairs. It weighs 3.5 kg and drives up to half a metre per second.",
      "Nothing moves until you take control, and then in Safe mode: it stops by itself at a cliff, when a wheel drops, and when its charger is plugged in.",
      "The Stop button, the space bar and Escape stop it. So does hiding or closing this page.",
      "A pulled cable doesn't stop it: the robot continues with the last command. Lift it then; in Safe mode it stops as soon as a wheel drops.",
    ],
    yes: "Understood, connect",
    isWarning: true,
  });
  if (agreed) keep(READ, "read");
  return agreed;
}

/** A value stored in this browser, possibly under its older name. @param {string} key */
export function kept(key) {
  try {
    return localStorage.getItem(key) ?? localStorage.getItem(key.replace(/^connection-/, "link-"));
  } catch {
    return null;
  }
}

/** @param {string} key @param {string} value */
export function keep(key, value) {
  try {
    localStorage.setItem(key, value);
  } catch {
    // Without storage it lasts as long as the page.
  }
}
