// @ts-check
// Errors with remedies: the message bar, the fatal cover, the short confirmation.
import { button, byId, setAttribute, setHidden, setText } from "./dom.js";
import { currentTab } from "./tabs.js";

let local = "";
let dismissed = "";
/** @type {ReturnType<typeof setTimeout> | undefined} */
let toastTimer;

/** The text of anything that was thrown. @param {unknown} error */
export const textOf = (error) => (error instanceof Error ? error.message : String(error));

/** Errors of Rust begin small, to stand behind others. Names of files stay as they are. @param {string} text */
export const sentence = (text) => (/^\S+\.\w+\s/.test(text) ? text : text.charAt(0).toUpperCase() + text.slice(1));

/** Shows an error until it is dismissed or something else succeeds. @param {string} text */
export function complain(text) {
  local = sentence(text);
  dismissed = "";
}

/** Hides our error, as the next attempt has succeeded. */
export function forgive() {
  local = "";
}

/** Shows ours, or else what the session says. @param {{ message: string, message_kind: string }} view */
export function updateMessage(view) {
  const text = local || view.message;
  const isError = local !== "" || view.message_kind === "error";
  // A dismissed message comes back if it went away in between.
  if (text !== dismissed) dismissed = "";
  setHidden(byId("message"), text === "" || text === dismissed);
  setText(byId("message-text"), text);
  setAttribute(byId("message"), "data-kind", isError ? "error" : "notice");
  setAttribute(byId("message-icon"), "href", isError ? "#i-alert" : "#i-info");
}

export function startMessages() {
  button("message-close").addEventListener("click", () => {
    dismissed = byId("message-text").textContent ?? "";
    local = "";
    const floor = byId("floor");
    (floor.checkVisibility() ? floor : byId(`tab-${currentTab()}`)).focus();
  });
  button("cover-reload").addEventListener("click", () => location.reload());
}

/**
 * A short confirmation that disappears by itself, or a progress message until the task is over.
 * @param {string} text @param {boolean} goesOn
 */
export function toast(text, goesOn = false) {
  const node = byId("toast");
  node.textContent = text;
  node.hidden = false;
  node.setAttribute("aria-busy", String(goesOn));
  clearTimeout(toastTimer);
  if (!goesOn) toastTimer = setTimeout(hideToast, Math.max(2500, 60 * text.length));
}

export function hideToast() {
  byId("toast").hidden = true;
}

/**
 * Covers the floor: the page can't go on.
 * @param {"unsupported" | "failed"} state
 * @param {string} title
 * @param {string} text
 */
export function cover(state, title, text) {
  document.body.dataset.boot = state;
  // Nothing there works any more.
  for (const id of ["setup", "playbar"]) byId(id).inert = true;
  byId("cover-title").textContent = title;
  byId("cover-text").textContent = text;
  const reload = button("cover-reload");
  reload.hidden = state === "unsupported";
  if (!reload.hidden) reload.focus();
}

/** Whether the wasm module can't be used any more after this error. @param {unknown} error */
export function isFatal(error) {
  return error instanceof WebAssembly.RuntimeError || /recursive use|unreachable|null pointer/.test(String(error));
}
