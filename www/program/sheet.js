// @ts-check
// On a phone the program is a sheet over the floor: out of the way while it runs, there when there is something to read.
import { byId } from "../dom.js";

/** Its button in the bar, on a small screen. */
const opener = () => {
  const button = document.querySelector('.sheet-bar [data-sheet="program"]');
  return button instanceof HTMLElement && button.checkVisibility() ? button : undefined;
};

export function openSheet() {
  const button = opener();
  if (button?.getAttribute("aria-expanded") === "false") button.click();
}

export function closeSheet() {
  if (opener()?.getAttribute("aria-expanded") === "true") byId("program").dispatchEvent(new Event("swiped", { bubbles: true }));
}
