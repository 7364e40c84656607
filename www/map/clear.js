// @ts-check
// Messages never lie on the map, when all of it is shown: it gives way.
import { byId, changed } from "../dom.js";

/** Pixels between a message and the map. */
const GAP = 10;

/** @param {import("./tab.js").MapTab} it @returns {() => void} */
export function startClear(it) {
  const { session } = it;
  const stage = byId("map-stage");
  /** Where what the robot does is said over the map; as in map.css. */
  const isSmall = matchMedia("(max-width: 900px)");
  let isPressed = false;
  /** Where the note about a robot in the hand ends. */
  let held = 0;
  addEventListener("pointerdown", () => (isPressed = true), { capture: true });
  for (const end of ["pointerup", "pointercancel"]) addEventListener(end, () => (isPressed = false), { capture: true });
  const low = (/** @type {string} */ id) => (byId(id).checkVisibility() ? byId(id).getBoundingClientRect().bottom + GAP - stage.getBoundingClientRect().top : 0);
  return () => {
    // The map stays while one presses where to put the robot.
    if (!isPressed) held = low("map-held");
    // The end stays; what it does before changes all the time.
    const end = isSmall.matches && it.view.phase === "finished" ? low("map-activity") : 0;
    const below = Math.max(held, end, ...["map-end", "map-began", "map-return"].map(low));
    if (changed(stage, "below", below)) session.keep_clear(below);
  };
}
