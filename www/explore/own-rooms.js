// @ts-check
// Rooms that were drawn or loaded: kept in this browser under a name, each by itself, as scenarios.
import { toast } from "../messages.js";
import { aboutRoom, settingsOf } from "../settings-link.js";
import { flatOf } from "./flat.js";
import { pack } from "./pack.js";
import { forgetPast, keepPast, pastIsBack, recall, settlePast } from "./room-past.js";
import { renamed, roomIn } from "./scenario.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {{ id: string, name: string }} OwnRoom
 */

/** The list of rooms. */
const LIST = "own-rooms";
/** Where versions without a list kept the last room: as if its id were empty, and without the dash. */
export const OLD = "";
/** Longest packed room in the address: some programs cut longer ones off. */
export const MOST_PACKED = 8000;

/** Id of the room of each lineage: undo and redo bring it back. @type {Map<number, string>} */
const ids = new Map();
/** Versions that are stored, and packed rooms. @type {Map<string, number>} */
const stored = new Map();
/** @type {Map<string, string>} */
const packed = new Map();
let warned = false;

/** @param {string} id */
const keyOf = (id) => (id === OLD ? "own-room" : `own-room-${id}`);

/** The rooms, the latest last. @returns {OwnRoom[]} */
export function list() {
  try {
    const found = JSON.parse(localStorage.getItem(LIST) ?? "[]");
    return Array.isArray(found) ? found.filter((room) => typeof room?.id === "string" && typeof room.name === "string") : [];
  } catch {
    return [];
  }
}

/** The scenario of a room. @param {string} id */
export function scenarioOf(id) {
  try {
    return localStorage.getItem(keyOf(id));
  } catch {
    return null;
  }
}

const isFrame = () => new URLSearchParams(location.search).has("embed");

/** Keeps a room; a new one comes last. @param {OwnRoom} room @param {string} scenario */
export function put({ id, name }, scenario) {
  // A frame in another page shows a room; nobody made one there.
  if (isFrame()) return;
  try {
    localStorage.setItem(keyOf(id), scenario);
    const rooms = list();
    const known = rooms.find((room) => room.id === id);
    if (known) known.name = name;
    else rooms.push({ id, name });
    localStorage.setItem(LIST, JSON.stringify(rooms));
  } catch (error) {
    // A private window has no storage at all, and the room isn't expected to stay.
    if (warned || !(error instanceof DOMException) || error.name !== "QuotaExceededError") return;
    warned = true;
    toast("There is no space left to keep this room in this browser. Save it before you leave, or delete other rooms.");
  }
}

/** @param {string} id */
export function remove(id) {
  forgetPast(id);
  try {
    localStorage.removeItem(keyOf(id));
    localStorage.setItem(LIST, JSON.stringify(list().filter((room) => room.id !== id)));
  } catch {
    // Without storage there is nothing to remove.
  }
}

export const newId = () => Array.from(crypto.getRandomValues(new Uint8Array(5)), (n) => (n % 36).toString(36)).join("") + Date.now().toString(36).slice(-3);

/** A name that no other room has. @param {string} name @param {string} [id] The room that may have it. */
export function freeName(name, id) {
  const taken = new Set(list().filter((room) => room.id !== id).map((room) => room.name));
  let free = name;
  for (let number = 2; taken.has(free); number += 1) free = `${name} ${number}`;
  return free;
}

/** The room that is shown, if it is an own one. @param {App} app */
export const currentId = (app) => (app.view.room.id ? undefined : ids.get(app.playground.room_lineage()));

/** When the changes of the shown room that were made before the page was loaded can be undone. @param {App} app */
export const pastOf = (app) => pastIsBack(app.playground.room_lineage());

/** The pair of links that tells the shown room from other own ones. @param {App} app */
export function pairOf(app) {
  const flat = flatOf(app);
  return flat ? `flat=${flat}` : `kept=${currentId(app)}`;
}

/** Shows a scenario as the room with that id. @param {App} app @param {string} id @param {string} name @param {string} scenario @param {boolean} isRoom Whether its other choices are left out. */
export async function show(app, id, name, scenario, isRoom) {
  const bytes = new TextEncoder().encode(scenario);
  if (!(await app.takeFiles([{ name: `the room "${name}"`, bytes }], isRoom))) return false;
  // Undo takes back what was changed in it, not the way through the rooms.
  for (const [lineage, one] of [...ids].reverse()) {
    if (one === id) app.act((p) => p.resume_room(lineage));
    if (app.playground.room_lineage() === lineage) break;
  }
  ids.set(app.playground.room_lineage(), id);
  stored.set(id, app.playground.room_version());
  void repack(id, scenario);
  return true;
}

/** Shows a room of the list, with all that was chosen in it or only the room. @param {App} app @param {string} id @param {boolean} isRoom */
export async function openRoom(app, id, isRoom = false) {
  const [room, scenario] = [list().find((one) => one.id === id), scenarioOf(id)];
  if (!room || !scenario) return false;
  return show(app, id, room.name, scenario, isRoom);
}

/** Adds a room and shows it. @param {App} app @param {string} name @param {string} scenario */
export async function addRoom(app, name, scenario) {
  const id = newId();
  const free = freeName(name);
  const named = renamed(scenario, free);
  put({ id, name: free }, named);
  return show(app, id, free, named, false);
}

/** The kept room that is the one of a scenario. @param {string} scenario */
export function keptAs(scenario) {
  const room = roomIn(scenario);
  return room ? list().find(({ id }) => roomIn(scenarioOf(id)) === room) : undefined;
}

/** Keeps the shown room if it is an own one; returns the link with it. @param {App} app @param {string} link */
export function keep(app, link) {
  const { playground } = app;
  // The room may have changed since the last frame.
  const view = (app.view = playground.view());
  const lineage = playground.room_lineage();
  if (view.room.id) {
    // All changes of a built-in room were undone.
    const gone = ids.get(lineage);
    if (gone) remove(gone);
    ids.delete(lineage);
    return link;
  }
  // A generated flat is its name, unless something else has to be kept with it.
  if (flatOf(app) && settingsOf(link).get("path") !== "kept") return aboutRoom(link, pairOf(app));
  let id = ids.get(lineage);
  const isNew = !id;
  // A file that is opened again is the room that it was; what is drawn in a built-in room is a new one.
  if (!id) ids.set(lineage, (id = (!playground.room_began_as() && keptAs(playground.scenario_json())?.id) || newId()));
  recall(app, lineage, isNew ? "" : id);
  if (stored.get(id) !== playground.room_version()) {
    const name = list().find((room) => room.id === id)?.name ?? freeName(view.room.title, id);
    // What is shown has the name that the list has.
    if (name !== view.room.title) playground.rename_room(name);
    stored.set(id, playground.room_version());
    const scenario = renamed(playground.scenario_json(), name);
    keepPast(id, isNew ? playground.room_began_as() : scenarioOf(id), scenario);
    put({ id, name }, scenario);
    packed.delete(id);
    void repack(id, scenario);
  } else settlePast(id, scenarioOf(id));
  const map = packed.get(id);
  return aboutRoom(link, `kept=${id}${map ? `&map=${map}` : ""}`);
}

/** @param {string} id @param {string} scenario */
async function repack(id, scenario) {
  const map = await pack(scenario).catch(() => "");
  if (map && map.length <= MOST_PACKED && scenarioOf(id) === scenario) packed.set(id, map);
}
