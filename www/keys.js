// @ts-check
// Keys that work everywhere on the page, and the dialog that lists them.
import { pickUp } from "./explore/carry.js";
import { button, byId, input, typed } from "./dom.js";
import { objectKey } from "./explore/objects.js";
import { undo } from "./keep.js";
import { currentTab, isOnFloor } from "./tabs.js";

/**
 * @typedef {import("./main.js").App} App
 * @typedef {{ key(key: string): boolean }} Part What says whether it used a key.
 */

/** Where keys write. */
export const WRITING = "select, textarea, [contenteditable] *, [contenteditable], input:not([type=checkbox], [type=range])";

/** @type {Record<string, import("./types").FloorTool>} */
const TOOLS = { v: "view", w: "wall", e: "erase", s: "start" };

/** @param {App} app @param {Part[]} parts */
export function startKeys(app, parts) {
  const dialog = typed("help", HTMLDialogElement);
  button("help-open").addEventListener("click", () => openHelp(dialog));
  // A click beside the dialog closes it.
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });

  const singleKeys = input("keys-on");
  singleKeys.checked = remembered() !== "off";
  singleKeys.addEventListener("change", () => remember(singleKeys.checked ? "on" : "off"));

  // Before anything that Escape closes is closed: it does one thing at a time.
  const cancel = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== "Escape" || !cancels(app, event)) return;
    event.stopPropagation();
    event.preventDefault();
    app.cancelPlanning();
  };
  document.addEventListener("keydown", cancel, { capture: true });

  document.addEventListener("keydown", (event) => {
    if (document.querySelector("dialog[open]") || event.defaultPrevented || event.altKey) return;
    const target = event.target instanceof Element ? event.target : document.body;
    if (target.matches(WRITING)) return;
    const used = event.ctrlKey || event.metaKey ? withControl(app, event) : singleKeys.checked && single(app, event, target, dialog, parts);
    if (used) event.preventDefault();
  });
}

/** Whether Escape means the planner: nothing else is open or being written. @param {App} app @param {KeyboardEvent} event */
function cancels({ view }, { target, ctrlKey, metaKey, altKey }) {
  if (!isOnFloor() || !view.can.cancel || ctrlKey || metaKey || altKey) return false;
  const isOpen = document.querySelector("dialog[open], .sheet.open, #layers:not([hidden]), #tip:not([hidden])");
  return !isOpen && !(target instanceof Element && target.matches(WRITING));
}

/** Ctrl or Cmd and a key. @param {App} app @param {KeyboardEvent} event */
function withControl(app, event) {
  const { act, view } = app;
  if (!isOnFloor() && currentTab() !== "compare") return false;
  const key = event.key.toLowerCase();
  if (key === "y" || (key === "z" && event.shiftKey)) return view.can.redo && act((p) => p.redo());
  if (key !== "z" || !view.can.undo) return false;
  void undo(app);
  return true;
}

/** @param {App} app @param {KeyboardEvent} event @param {Element} target @param {HTMLDialogElement} dialog @param {Part[]} parts */
function single(app, event, target, dialog, parts) {
  const { act, view } = app;
  const key = event.key.toLowerCase();
  // Space presses the button that has the focus.
  if (key === " " && target.matches("button, summary, input, a")) return false;
  if (key === "?") {
    openHelp(dialog);
    return true;
  }
  if (!isOnFloor()) return app.tabKey(key);
  const tool = TOOLS[key];
  if (tool) return (tool === "view" || view.can.edit) && act((p) => p.set_tool(tool));
  switch (key) {
    case "p":
      return pickUp(app);
    case "l":
      button("layers-open").click();
      return true;
    default:
      return parts.some((part) => part.key(key)) || objectKey(app, key);
  }
}

/** @param {HTMLDialogElement} dialog */
function openHelp(dialog) {
  dialog.showModal();
  import("./help.js")
    .then(({ fillHelp }) => fillHelp(byId("help-text")))
    .catch(() => (byId("help-text").textContent = "The help could not be loaded. Check the connection, then open it again."));
}

function remembered() {
  try {
    return localStorage.getItem("keys");
  } catch {
    return null;
  }
}

/** @param {string} value */
function remember(value) {
  try {
    localStorage.setItem("keys", value);
  } catch {
    // Without storage the choice lasts as long as the page.
  }
}
