// @ts-check
// Undo and redo of what was chosen for a floor plan, by their keys.
import { byId } from "../dom.js";
import { toast } from "../messages.js";

/** Most changes that can be undone. */
const MOST = 100;

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startUndo(it) {
  /** Settings before the present ones, and those that were undone, the latest last. @type {[past: string[], undone: string[]]} */
  let [past, undone] = [[], []];
  let now = "";
  /** The files that they are for. @type {File[]} */
  let files = [];
  /** What is being gone to, and whether it still is. */
  let [wanted, isGoing] = ["", false];

  /** @param {string[]} from @param {string[]} to @param {string} what */
  const go = async (from, to, what) => {
    const next = from.at(-1);
    if (isGoing) return;
    if (!next) return toast(`Nothing to ${what}`);
    [wanted, isGoing] = [next, true];
    const before = now;
    const isDone = await it.ask({ type: "set", settings: JSON.parse(next) }, "Tracing the room");
    isGoing = false;
    if (!isDone) return void (wanted = "");
    from.pop();
    to.push(before);
  };
  document.addEventListener("keydown", (event) => {
    const isUndo = event.key.toLowerCase() === "z";
    if (!(event.ctrlKey || event.metaKey) || event.altKey || !(isUndo || event.key.toLowerCase() === "y")) return;
    if (!it.view || !byId("panel-floor-plan").checkVisibility()) return;
    // Where one types, the browser undoes letters.
    if (event.target instanceof HTMLInputElement && event.target.type !== "range" && event.target.type !== "checkbox") return;
    event.preventDefault();
    void (isUndo && !event.shiftKey ? go(past, undone, "undo") : go(undone, past, "redo"));
  });

  return (view) => {
    if (!view || files !== it.client.files) [past, undone, now, files] = [[], [], "", it.client.files];
    const settings = view ? JSON.stringify(view.settings) : "";
    if (settings === now) return;
    if (now && settings !== wanted) [past, undone] = [[...past, now].slice(-MOST), []];
    [now, wanted] = [settings, ""];
  };
}
