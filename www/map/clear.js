// @ts-check
// Messages never lie on the map, when all of it is shown: it gives way.
import { byId, changed } from "../dom.js";

/** Pixels between a message and the map. */
const GAP = 10;

/** @param {import("./tab.js").MapTab} it @returns {() => void} */
export function startClear({ session }) {
  const stage = byId("map-stage");
  return () => {
    const ends = ["map-end", "map-began", "map-return"].map(byId).filter((message) => message.checkVisibility()).map((message) => message.getBoundingClientRect().bottom + GAP);
    const below = Math.max(0, ...ends.map((end) => end - stage.getBoundingClientRect().top));
    if (changed(stage, "below", below)) session.keep_clear(below);
  };
}
