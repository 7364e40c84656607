// @ts-check
// A recorded session once more: shown as it was, with nothing to be driven.
import { Replay } from "../../workshop.js";
import { button, byId, changed, input, select, setHidden, setText } from "../dom.js";
import { download } from "../files.js";
import { clock } from "../format.js";
import { textOf } from "../messages.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { startRange } from "../shared/range.js";
import { fillSpeeds } from "../shared/time-line.js";
import { startTimeline } from "./timeline.js";
import { startTwin } from "./twin.js";

/** Milliseconds between views. */
const PAUSE = 50;
/** Largest file that is read, bytes: some hours. */
const MOST = 200e6;
/** Times real time. */
const SPEEDS = [1, 4, 16];

/**
 * @param {import("./tab.js").ConnectionTab} it
 * @param {object} to Where it goes instead of what a connection says.
 * @param {(view: import("./types").ConnectionView) => void} to.show
 * @param {(trace: Float64Array) => void} to.follow
 * @param {(traffic: import("./types").Traffic[]) => void} to.traffic
 * @param {() => void} to.wipe The way so far is to be forgotten.
 * @param {() => void} to.settle Hides earlier messages.
 * @param {() => void} to.closed Nothing is shown any more.
 */
export function startReplay(it, to) {
  const [file, play, speed] = [input("replay-file"), button("replay-play"), select("replay-speed")];
  fillSpeeds(speed, SPEEDS);
  /** @type {Replay | undefined} */
  let replay;
  let isPlaying = false;
  let last = 0;
  let name = "";
  const isDue = atMostEvery(PAUSE);

  button("replay-open").addEventListener("click", () => file.click());
  file.addEventListener("change", async () => {
    const chosen = file.files?.[0];
    file.value = "";
    if (!chosen) return;
    try {
      if (chosen.size > MOST) throw `"${chosen.name}" is too large for a recording.`;
      const text = await chosen.text();
      const read = new Replay(chosen.name, text);
      end();
      [replay, isPlaying, name] = [read, true, chosen.name.replace(/\.[^.]*$/, "")];
      timeline.begin(read);
      twin.begin({ text, name });
      to.settle();
      setHidden(byId("replay"), false);
      last = performance.now();
      look();
      to.wipe();
    } catch (error) {
      it.complain(textOf(error));
    }
  });
  play.addEventListener("click", () => {
    isPlaying = !isPlaying;
    if (isPlaying && replay && replay.time_s() >= replay.duration_s()) go(0);
  });

  /** @param {number} time */
  const go = (time) => {
    if (!replay) return;
    if (time < replay.time_s()) to.wipe();
    replay.advance(time);
    look();
  };
  const timeline = startTimeline(go);
  const twin = startTwin(it.app);
  button("replay-csv").addEventListener("click", () => replay && download(`${name}.csv`, replay.csv(), "text/csv"));
  button("replay-bag").addEventListener("click", () => {
    try {
      if (replay) download(`${name}.mcap`, /** @type {BlobPart} */ (replay.bag()), "application/x-mcap");
    } catch (error) {
      it.complain(textOf(error));
    }
  });
  const showRange = startRange("replay-at", go);
  const look = () => {
    if (!replay) return;
    to.follow(replay.take_trace());
    to.show({ ...replay.view(), virtual: null });
    to.traffic(replay.take_traffic());
    const [now, all] = [replay.time_s(), replay.duration_s()];
    showRange(all, now);
    setText(byId("replay-time"), `${clock(now)} of ${clock(all)}`);
    timeline.mark(now);
  };
  /** Says whether there was one. */
  const end = () => {
    if (!replay) return false;
    timeline.begin();
    twin.begin();
    replay.free();
    replay = undefined;
    setHidden(byId("replay"), true);
    to.closed();
    return true;
  };

  return {
    end,
    /** @param {number} now */
    frame(now) {
      if (!replay) return;
      timeline.frame();
      const elapsed = Math.min(0.25, Math.max(0, (now - last) / 1000));
      last = now;
      if (isPlaying) {
        replay.advance(replay.time_s() + elapsed * Number(speed.value));
        if (replay.time_s() >= replay.duration_s()) isPlaying = false;
      }
      setText(play, isPlaying ? "Pause" : "Play");
      const isOther = changed(play, "playing", isPlaying);
      if (isDue(() => isOther || isPlaying, isOther)) look();
    },
  };
}
