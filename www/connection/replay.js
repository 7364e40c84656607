// @ts-check
// A recorded session once more: shown as it was, with nothing to be driven.
import { Replay } from "../../workshop.js";
import { button, byId, changed, fill, input, select, setHidden, setText } from "../dom.js";
import { clock } from "../format.js";
import { textOf } from "../messages.js";

/** Milliseconds between views. */
const PAUSE = 50;
/** Largest file that is read, bytes: some hours. */
const MOST = 200e6;
/** @type {[string, string][]} */
const SPEEDS = [["1", "1×"], ["4", "4×"], ["16", "16×"]];

/**
 * @param {import("./tab.js").ConnectionTab} it
 * @param {object} to Where it goes instead of what a connection says.
 * @param {(view: import("./types").ConnectionView) => void} to.show
 * @param {(trace: Float64Array) => void} to.follow
 * @param {(traffic: import("./types").Traffic[]) => void} to.traffic
 * @param {() => void} to.wipe The way so far is to be forgotten.
 * @param {() => void} to.settle What was said before is over.
 * @param {() => void} to.closed Nothing is shown any more.
 */
export function startReplay(it, to) {
  const [file, at, play, speed] = [input("replay-file"), input("replay-at"), button("replay-play"), select("replay-speed")];
  fill(speed, SPEEDS);
  /** @type {Replay | undefined} */
  let replay;
  let isPlaying = false;
  let last = 0;
  let shown = 0;

  button("replay-open").addEventListener("click", () => file.click());
  file.addEventListener("change", async () => {
    const chosen = file.files?.[0];
    file.value = "";
    if (!chosen) return;
    try {
      if (chosen.size > MOST) throw `"${chosen.name}" is too large for a recording.`;
      const read = new Replay(chosen.name, await chosen.text());
      end();
      [replay, isPlaying] = [read, true];
      to.settle();
      at.max = String(read.duration_s());
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
  at.addEventListener("input", () => go(at.valueAsNumber));

  /** @param {number} time */
  const go = (time) => {
    if (!replay) return;
    if (time < replay.time_s()) to.wipe();
    replay.advance(time);
    look();
  };
  const look = () => {
    if (!replay) return;
    to.follow(replay.take_trace());
    to.show({ .../** @type {import("./types").ConnectionState} */ (replay.view()), virtual: null });
    to.traffic(/** @type {import("./types").Traffic[]} */ (replay.take_traffic()));
    const [now, all] = [replay.time_s(), replay.duration_s()];
    if (document.activeElement !== at || isPlaying) at.value = String(now);
    setText(byId("replay-time"), `${clock(now)} of ${clock(all)}`);
  };
  /** Says whether there was one. */
  const end = () => {
    if (!replay) return false;
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
      const elapsed = Math.min(0.25, Math.max(0, (now - last) / 1000));
      last = now;
      if (isPlaying) {
        replay.advance(replay.time_s() + elapsed * Number(speed.value));
        if (replay.time_s() >= replay.duration_s()) isPlaying = false;
      }
      setText(play, isPlaying ? "Pause" : "Play");
      if (!changed(play, "playing", isPlaying) && (!isPlaying || now - shown < PAUSE)) return;
      shown = now;
      look();
    },
  };
}
