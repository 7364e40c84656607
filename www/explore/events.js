// @ts-check
// The list of events: what happened to the robot, latest first; each leads back to its time.
import { byId, changed, make, setHidden, setText } from "../dom.js";
import { clock } from "../format.js";
import { moreVersion, withMore } from "./more-events.js";
import { atMostEvery } from "../shared/frame-pacer.js";

/**
 * @typedef {{ time: number, text: string, felt: boolean }} Entry
 * @typedef {{ item: HTMLLIElement, time: HTMLElement, text: HTMLElement }} Line
 */

/** Most events that are listed. */
const MOST = 100;
/** Least time between changes of the list, ms, so that it can be read. */
const PAUSE = 250;

/** @param {import("../main.js").App} app @returns {(view: import("../types").PageView) => void} */
export function startEvents(app) {
  const list = byId("events");
  /** @type {Line[]} */
  const lines = [];
  /** @type {Entry[]} */
  let entries = [];
  /** Those of the session. @type {Entry[]} */
  let known = [];
  const isDue = atMostEvery(PAUSE);

  const add = () => {
    const [time, text] = [make("span", { className: "when" }), make("span", { className: "what" })];
    const index = lines.length;
    const go = make("button", { type: "button", className: "event" }, time, text);
    go.addEventListener("click", () => {
      const entry = entries[index];
      if (entry && app.view.can.seek) app.act((p) => (p.pause(), p.seek(entry.time)));
    });
    const item = make("li", {}, go);
    lines.push({ item, time, text });
    list.append(item);
  };

  return (view) => {
    // The list doesn't move under the pointer.
    const held = view.state === "playing" && list.matches(":hover, :focus-within");
    const key = `${view.diary} ${view.run_end_s < (known[0]?.time ?? 0)} ${view.state === "playing" || view.time_s} ${moreVersion()}`;
    // Another run of a program: nothing of the one before is ahead.
    if (changed(list, "run", String(view.program?.version ?? ""))) known = [];
    if (held || !isDue(() => list.checkVisibility() && changed(list, "entries", key))) return;
    known = merged(known, read(app.playground.diary()), view);
    entries = withMore(known, view.time_s, MOST);
    while (lines.length < entries.length) add();
    lines.forEach(({ item, time, text }, index) => {
      const entry = entries[index];
      setHidden(item, !entry);
      if (!entry) return;
      setText(time, clock(entry.time));
      setText(text, entry.text);
      const kind = entry.time > view.time_s + 0.01 ? "ahead" : entry.felt ? "felt" : "";
      if (changed(item, "kind", kind)) item.className = kind;
    });
    setHidden(byId("events-none"), entries.length > 0);
  };
}

/** @param {unknown[]} flat @returns {Entry[]} */
function read(flat) {
  const entries = [];
  for (let i = 0; i + 2 < flat.length; i += 3) entries.push({ time: Number(flat[i]), text: String(flat[i + 1]), felt: flat[i + 2] === true });
  return entries;
}

/** What is known from before of the time ahead, when time was wound back, and what there is. @param {Entry[]} known @param {Entry[]} entries @param {import("../types").PageView} view */
function merged(known, entries, view) {
  const ahead = known.filter(({ time }) => time > view.time_s + 0.001 && time <= view.run_end_s);
  const latest = entries[0]?.time ?? -1;
  return [...ahead.filter(({ time }) => time > latest), ...entries].slice(0, MOST);
}
