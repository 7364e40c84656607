// @ts-check
// The state stored at the moment in which the page is left. The browser's database takes longer than a page has then;
// its local storage is written at once, has room for a few megabytes, and holds the mapping run until the database has
// it.

/**
 * @typedef {import("./database.js").Kept} Kept
 * @typedef {{ recipe: string, end: number, entries: Kept[] }} Last The mapping run that was left, how far it had come (s), and what
 *   is to be kept of it, as far as there was room.
 */

const LAST = "map-last";

/** Keeps at once. @param {Last} last */
export function keepLast(last) {
  for (const entries of [last.entries, []]) {
    try {
      localStorage.setItem(LAST, JSON.stringify({ ...last, entries }));
      return;
    } catch {
      // There is no storage, or no room: then at least how far it had come.
    }
  }
}

/** The state stored so, if any. @returns {Last | undefined} */
export function theLast() {
  try {
    const { recipe, end, entries } = JSON.parse(localStorage.getItem(LAST) ?? "");
    const isEntry = (/** @type {Kept} */ kept) => typeof kept.recipe === "string" && typeof kept.text === "string" && typeof kept.saved === "number";
    if (typeof recipe === "string" && typeof end === "number" && Array.isArray(entries) && entries.every(isEntry)) return { recipe, end, entries };
  } catch {
    // None, or by another version.
  }
  return undefined;
}

/** The database has it. */
export function dropLast() {
  try {
    localStorage.removeItem(LAST);
  } catch {
    // Without storage there is none.
  }
}
