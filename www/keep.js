// @ts-check
// Keeps rooms that are not in a link: drawn or loaded ones survive a reload in this browser.

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

/** Keeps the room if it is not in the link. @param {App} app @param {string} link */
export function keepRoom(app, link) {
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
