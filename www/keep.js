// @ts-check
// Keeps rooms that are not in a link: drawn or loaded ones survive a reload in this browser.

/** @typedef {import("./main.js").App} App */

const KEY = "own-room";
/** What `link` says for a room that does not ship. */
const OWN = "room=own";

/**
 * Brings back what the address asks for.
 * @param {App} app @param {string} link
 */
export function restoreLink(app, link) {
  if (link.split("&").includes(OWN)) {
    const saved = read();
    if (!saved) {
      app.act((p) => p.restore(link));
      app.act((p) => p.report_error("The room of this link was drawn or loaded in another browser; ask for its scenario file and load that."));
      return;
    }
    const bytes = new TextEncoder().encode(saved);
    if (!app.act((p) => p.load_files([{ name: "the room kept in this browser", bytes }]))) return;
  }
  app.act((p) => p.restore(link));
}

/** Keeps the room if it is not in the link. @param {App} app @param {string} link */
export function keepRoom(app, link) {
  if (!link.split("&").includes(OWN)) return;
  try {
    localStorage.setItem(KEY, app.playground.scenario_json());
  } catch {
    // Private windows and full disks: the room then lives as long as the page.
  }
}

function read() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
