// @ts-check
// Undo and redo of what was chosen for a floor plan, and of opening another one, by their keys.
import { byId } from "../dom.js";
import { toast } from "../messages.js";

/** Most changes that can be undone. */
const MOST = 100;

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startUndo(it) {
  /** @typedef {{ files: File[], settings: string }} State */
  /** States before the present one, and those that were undone, the latest last. @type {[past: State[], undone: State[]]} */
  let [past, undone] = [[], []];
  /** @type {State | undefined} */
  let now;
  let isGoing = false;

  /** @param {State[]} from @param {State[]} to @param {string} what */
  const go = async (from, to, what) => {
    const next = from.at(-1);
    if (isGoing) return;
    if (!next || !now) return toast(`Nothing to ${what}`);
    isGoing = true;
    const [before, settings] = [now, JSON.parse(next.settings)];
    const isOther = next.files !== now.files;
    const isDone = await (isOther ? it.ask({ type: "restore", files: next.files, settings }, "Opening the floor plan") : it.ask({ type: "set", settings }, "Tracing the room"));
    isGoing = false;
    if (!isDone) return;
    from.pop();
    to.push(before);
    if (isOther) toast(`Back to ${next.files.map(({ name }) => name).join(" and ")}`);
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
    if (!view) return;
    const state = { files: it.client.files, settings: JSON.stringify(view.settings) };
    if (now?.files === state.files && now.settings === state.settings) return;
    if (now && !isGoing) [past, undone] = [[...past, now].slice(-MOST), []];
    now = state;
  };
}
