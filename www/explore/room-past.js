// @ts-check
// Earlier states of own rooms, kept in this browser: their changes can be undone after a reload.

/** @typedef {import("../main.js").App} App */

/** Most states of a room, and letters of all of them. */
const MOST = { states: 20, letters: 1_500_000 };

/** What isn't back yet of each lineage's past, as in `read`; nothing of what was done since. @type {Map<number, string[]>} */
const missing = new Map();
/** The lineages whose past is coming back. @type {Map<number, Promise<void>>} */
const coming = new Map();

/** A stroke is one change, however often it is kept meanwhile: the room before it. @type {{ id: string, before: string } | undefined} */
let held;
// Fingers make nothing active.
const isDrawing = () => document.getElementById("floor")?.matches(".pressed") === true;

/** @param {string} id */
const keyOf = (id) => `own-room-${id}-past`;

/** The oldest first: scenarios, or the id of the built-in room that it began with. @param {string} id @returns {string[]} */
function read(id) {
  try {
    const past = JSON.parse(localStorage.getItem(keyOf(id)) ?? "[]");
    return Array.isArray(past) ? past.filter((state) => typeof state === "string") : [];
  } catch {
    return [];
  }
}

/** What a scenario says of the room alone. @param {string} scenario */
function room(scenario) {
  try {
    const { width, height, resolution, rows, objects = [] } = JSON.parse(scenario);
    return JSON.stringify([width, height, resolution, rows, objects]);
  } catch {
    return scenario;
  }
}

/** The room was `before`, if it was, and is another one now. @param {string} id @param {string | null | undefined} before @param {string} now */
export function keepPast(id, before, now) {
  if (held?.id !== id) held = before ? { id, before } : undefined;
  if (held && !isDrawing()) settlePast(id, now);
}

/** The stroke has ended, if there was one: the room is now another. @param {string} id @param {string | null} now */
export function settlePast(id, now) {
  if (isDrawing() || held?.id !== id || !now) return;
  const { before } = held;
  held = undefined;
  const past = read(id);
  // What is undone isn't the past any more.
  if (past.length > 0 && room(past[past.length - 1] ?? "") === room(now)) past.pop();
  else if (room(before) !== room(now)) past.push(before);
  while (past.length > MOST.states || past.reduce((sum, { length }) => sum + length, 0) > MOST.letters) past.shift();
  try {
    localStorage.setItem(keyOf(id), JSON.stringify(past));
  } catch {
    forgetPast(id);
  }
}

/** @param {string} id */
export function forgetPast(id) {
  try {
    localStorage.removeItem(keyOf(id));
  } catch {
    // Without storage there is nothing to forget.
  }
}

/** Once for each lineage, lets the changes of the shown room be undone that were made before the page was loaded. @param {App} app @param {number} lineage @param {string} id Empty for a new room. */
export function recall(app, lineage, id) {
  const past = missing.get(lineage) ?? (id ? read(id) : []);
  missing.set(lineage, past);
  if (past.length === 0 || coming.has(lineage)) return;
  const back = bringBack(app, lineage, past).catch((error) => {
    past.length = 0;
    console.warn(error);
  });
  coming.set(lineage, back.finally(() => void coming.delete(lineage)));
}

/** When what is shown can be undone as far as it is known. @param {number} lineage */
export const pastIsBack = (lineage) => coming.get(lineage);

/** @param {App} app @param {number} lineage @param {string[]} past */
async function bringBack(app, lineage, past) {
  const { readMap } = await import("../workers.js");
  for (let state = past.at(-1); state; state = past.at(-1)) {
    const map = state.startsWith("{") ? await readMap([{ name: "room.json", bytes: new TextEncoder().encode(state) }]) : undefined;
    // Another room may have been chosen meanwhile. The rest comes back with this one.
    if (app.playground.room_lineage() !== lineage) return;
    past.pop();
    app.act((p) => (map ? p.recall_map(map) : p.recall_room(state)));
  }
}
