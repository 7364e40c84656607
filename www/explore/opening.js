// @ts-check
// The opening scene explains itself: a robot that began before the page was opened.
import { byId } from "../dom.js";

/** Explains for a while why the robot has already cleaned; and, until the first input, what the page is. */
export function tellOpening() {
  byId("opening").textContent = ": started ten minutes ago";
  setTimeout(endOpening, 15_000);
  byId("welcome").hidden = false;
  for (const sign of ["pointerdown", "keydown"]) addEventListener(sign, () => (byId("welcome").hidden = true), { once: true, capture: true });
}

export function endOpening() {
  const told = byId("opening");
  if (told.textContent) told.textContent = "";
}
