// @ts-check
// What happened in a recording, in words: a list whose entries lead to their moment.
import { byId, make, setAttribute, setText } from "../dom.js";
import { clock, percent } from "../format.js";

/** Seconds of a recording that are examined in a frame: some milliseconds of work. */
const PART = 10;

/**
 * @param {(time: number) => void} go Shows the recording at that time.
 */
export function startTimeline(go) {
  const list = byId("replay-timeline");
  /** @type {import("../../workshop.js").Replay | undefined} */
  let replay;
  let examined = 0;
  /** Entries with their times. @type {[HTMLElement, number][]} */
  let entries = [];
  /** The entry that was chosen last. */
  let chosen = -1;

  const show = (/** @type {import("../../workshop.js").Replay} */ replay) => {
    const timeline = replay.timeline();
    entries = timeline.entries.map(({ time_s: time, text, is_fault: isFault }, index) => {
      const mark = isFault ? make("i", { title: "Fault" }, "!") : make("i");
      const entry = make("button", { type: "button", className: isFault ? "quiet fault" : "quiet" }, make("time", {}, clock(time)), mark, make("span", {}, text));
      entry.addEventListener("click", () => {
        chosen = index;
        go(time);
      });
      return [entry, time];
    });
    list.replaceChildren(...entries.map(([entry]) => make("li", {}, entry)));
    if (timeline.left_out > 0) list.append(make("li", { className: "note" }, `and ${timeline.left_out} more`));
    setText(byId("replay-summary"), `${replay.summary()}.`);
  };

  return {
    /** Begins with another recording, or none. @param {import("../../workshop.js").Replay} [other] */
    begin(other) {
      [replay, examined, entries, chosen] = [other, 0, [], -1];
      list.replaceChildren();
    },
    /** Once a frame. */
    frame() {
      if (!replay) return;
      const hasMore = replay.examine(PART);
      examined += PART;
      if (hasMore) return void setText(byId("replay-summary"), `Examining the recording: ${percent(examined / replay.duration_s(), 0)} %`);
      show(replay);
      replay = undefined;
    },
    /** Marks the last entry before this time; of several at one time, the one that was chosen. @param {number} now */
    mark(now) {
      const at = entries.filter(([, time]) => time <= now).length - 1;
      const marked = entries[chosen]?.[1] === entries[at]?.[1] ? chosen : at;
      for (const [index, [entry]] of entries.entries()) setAttribute(entry, "aria-current", String(index === marked));
    },
  };
}
