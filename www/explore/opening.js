// @ts-check
// The opening scene explains itself: a robot that is ten minutes into its run.
import { byId, setText } from "../dom.js";
import { percent } from "../format.js";

const OPENED = "10 minutes already done";

/** Explains for a while why the robot has already cleaned. */
export function tellOpening() {
  setText(byId("opening"), OPENED);
  setTimeout(endOpening, 15_000);
}

export function endOpening() {
  if (byId("opening").textContent === OPENED) setText(byId("opening"), "");
}

/** Says that some floor was clean when the run began. @param {number} share */
export function tellBefore(share) {
  if (share > 0.005) setText(byId("opening"), `${percent(share)} % from before the change`);
  else if (byId("opening").textContent !== OPENED) setText(byId("opening"), "");
}
