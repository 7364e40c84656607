// @ts-check
// Keeps the state over a reload: in the address, and in this browser a room that is not in a link, drawn or loaded.

import { toast } from "./messages.js";

/** @typedef {import("./main.js").App} App */

const KEY = "own-room";
/** Whether it has been said that there is no room for the room. */
let warned = false;
/** The value in `link` of a room that isn't built in. */
const OWN = "room=own";

/**
 * Restores the state of the address; an own room is read in a worker.
 * @param {App} app @param {string} link
 */
export async function restoreLink(app, link) {
  if (link.split("&").includes(OWN)) {
    const saved = read();
    if (!saved) {
      app.act((p) => p.restore(link));
      app.act((p) => p.report_error("This link's room was drawn or loaded in another browser. Ask its author for the scenario file and load that."));
      return;
    }
    const bytes = new TextEncoder().encode(saved);
    if (!(await app.takeFiles([{ name: "the room kept in this browser", bytes }]))) return;
  }
  app.act((p) => p.restore(link));
}

/** What was kept last. */
let kept = "";

/** Keeps the state if it has changed. @param {App} app */
export function keepState(app) {
  const link = app.link();
  const hash = link.startsWith("#") ? link : `#${link}`;
  if (hash !== location.hash) history.replaceState(null, "", hash);
  const version = `${link} ${app.playground.room_version()}`;
  if (version !== kept) keepRoom(app, link);
  kept = version;
}

/** Keeps the room if it is not in the link. @param {App} app @param {string} link */
function keepRoom(app, link) {
  if (!link.split("&").includes(OWN)) return;
  try {
    localStorage.setItem(KEY, app.playground.scenario_json());
  } catch (error) {
    // A private window has no storage at all, and the room isn't expected to stay.
    if (warned || !(error instanceof DOMException) || error.name !== "QuotaExceededError") return;
    warned = true;
    toast("This room is too large to keep in this browser. Save it before you leave.");
  }
}

function read() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
