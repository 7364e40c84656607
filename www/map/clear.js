// @ts-check
// Messages never lie on the map, when all of it is shown: it gives way.
import { byId, changed } from "../dom.js";
import { GAP, lowerEnd } from "../shared/corner.js";

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
  /** Where beside a lesson the palette is all that floats over the map; as in learn.css. */
  const isTight = matchMedia("(max-width: 780px), (max-width: 900px) and (max-height: 540px)");
  const isBare = () => isTight.matches && document.body.classList.contains("learning");
  /** Where the card with the button to start lies over all of the map's width. */
  const isLow = matchMedia("(max-width: 900px) and (max-height: 540px)");
  const low = (/** @type {string} */ id) => lowerEnd(byId(id), stage);
  /** Width and height of that card's corner. @returns {[number, number]} */
  const corner = () => {
    const hint = byId("map-hint");
    if (!(isLow.matches || isBare()) || !hint.checkVisibility()) return [0, 0];
    const [box, all] = [hint.getBoundingClientRect(), stage.getBoundingClientRect()];
    return [all.right - box.left + GAP, all.bottom - box.top + GAP];
  };
  return () => {
    // The map stays while one presses where to put the robot.
    if (!isPressed) held = low("map-held");
    // The end stays; what it does before changes all the time.
    const end = isSmall.matches && it.view.phase === "finished" ? low("map-activity") : 0;
    const palette = isBare() ? lowerEnd(byId("map-tools"), stage, 2) : 0;
    const told = Math.max(palette, held, end, ...["map-end", "map-began", "map-return", "message"].map(low));
    const clear = /** @type {const} */ ([told, isBare() ? 0 : undefined, ...corner()]);
    if (changed(stage, "clear", clear.join())) session.keep_clear(...clear);
  };
}
