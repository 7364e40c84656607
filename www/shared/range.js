// @ts-check
// A time line that is a plain range.
import { changed, input } from "../dom.js";

/** @param {string} id @param {(seconds: number) => void} seek @returns {(range: number, at?: number) => void} Sets the
 * range, and a time unless it is being dragged. */
export function startRange(id, seek) {
  const node = input(id);
  let isHeld = false;
  node.addEventListener("pointerdown", () => (isHeld = true));
  for (const end of ["pointerup", "pointercancel", "blur"]) node.addEventListener(end, () => (isHeld = false));
  node.addEventListener("input", () => seek(node.valueAsNumber));
  return (range, at) => {
    if (changed(node, "max", range)) node.max = String(range);
    if (!isHeld && at !== undefined) node.value = String(at);
  };
}
