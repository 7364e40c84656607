// @ts-check
// What floats over a floor: the room keeps clear of it.
import { byId } from "../dom.js";

/** Pixels between what floats over the floor and the room. */
export const GAP = 10;
/** Height of a note above the joystick, pixels: the room doesn't move whenever one comes or goes. */
const NOTE = 48;

const isNarrow = matchMedia("(max-width: 900px)");

/** Where what floats over a stage ends, with the gap below it, pixels from the upper edge; 0 if it isn't there, lies beside the stage or over its lower end. @param {Element | null} node @param {Element} stage */
export function lowerEnd(node, stage, gap = GAP) {
  if (!node?.checkVisibility()) return 0;
  const [box, all] = [node.getBoundingClientRect(), stage.getBoundingClientRect()];
  const isOver = box.left < all.right && box.top < all.bottom && (box.bottom < all.bottom || box.top < all.top + all.height / 3);
  return isOver ? box.bottom - all.top + gap : 0;
}

/**
 * Width and height of the lower right corner with the joystick, pixels; `undefined` if there is none.
 * @param {HTMLElement} stage @param {string} [before] What the ids of this tab's joystick begin with. @returns {[number, number] | undefined}
 */
export function joystickCorner(stage, before = "") {
  const manual = byId(`${before}manual`);
  if (!manual.checkVisibility()) return undefined;
  const { right, bottom } = stage.getBoundingClientRect();
  // On a phone they are beside it.
  const notes = isNarrow.matches ? 0.2 : byId(`${before}manual-note`).checkVisibility() ? 2 : 1;
  return [right - manual.getBoundingClientRect().left + GAP, bottom - byId(`${before}pad`).getBoundingClientRect().top + notes * NOTE];
}
