// @ts-check
// The opening scene explains itself: a robot that began before the page was opened.
import { byId, setText } from "../dom.js";
import { percent } from "../format.js";

const OPENED = ": started ten minutes ago";

/** Explains for a while why the robot has already cleaned; and, until the first input, what the page is. */
export function tellOpening() {
  setText(byId("opening"), OPENED);
  setTimeout(endOpening, 15_000);
  byId("welcome").hidden = false;
  for (const sign of ["pointerdown", "keydown"]) addEventListener(sign, () => (byId("welcome").hidden = true), { once: true, capture: true });
}

export function endOpening() {
  if (byId("opening").textContent === OPENED) setText(byId("opening"), "");
}

/** Says that some floor was clean when the run began. @param {number} share */
export function tellBefore(share) {
  if (share > 0.005) setText(byId("opening"), `: ${percent(share, 0)} % from before the change`);
  else if (byId("opening").textContent !== OPENED) setText(byId("opening"), "");
}
