// @ts-check
// Messages over the floor never lie on the room, when all of that is shown, nor does the joystick: the room gives way.
import { byId, changed } from "../dom.js";
import { GAP, joystickCorner, lowerEnd } from "../shared/corner.js";

/** Height of the bar of a selected object, pixels. */
const BAR = 50;

/** @param {import("../main.js").App} app @returns {(view: import("../types").PageView) => void} */
export function startClear(app) {
  const stage = byId("stage");
  const isNarrow = matchMedia("(max-width: 900px)");
  /** Where the bar of a selected object takes the place of the legend; as in placing.css. */
  const isLow = matchMedia("(max-width: 900px) and (max-height: 540px)");
  /** The lower end of the text about a search, which never moves up, so that the pictures of its film stay in place. */
  let told = 0;
  /** That of the palette and the bar of a selected object: the room moves once, and not whenever something else is selected. */
  let palette = 0;
  /** That of the note about a robot in the hand: the room stays while one presses where to put it. */
  let carried = 0;
  addEventListener("resize", () => (told = palette = 0));
  let isPressed = false;
  addEventListener("pointerdown", () => (isPressed = true), { capture: true });
  for (const end of ["pointerup", "pointercancel"]) addEventListener(end, () => (isPressed = false), { capture: true });
  const below = (/** @type {string} */ what, gap = GAP) => lowerEnd(document.querySelector(what), stage, gap);
  const above = (/** @type {Element} */ node) => (node.checkVisibility() ? stage.getBoundingClientRect().bottom - node.getBoundingClientRect().top + GAP : 0);

  /** Width and height of the lower right corner that the joystick takes, or in a small frame the zoom; beside a lesson on a
   * phone there is the scale alone, which any width stands for. @returns {[number, number]} */
  const corner = () => {
    const taken = joystickCorner(stage);
    if (taken || !isSmallFrame()) return taken ?? [0, 0];
    const zoom = byId("zoom-in");
    return [zoom.checkVisibility() ? stage.getBoundingClientRect().right - zoom.getBoundingClientRect().left + GAP : GAP, above(zoom)];
  };

  const isSmallFrame = () => [byId("legend"), byId("tools")].every((node) => !node.checkVisibility());

  /** Width and height of the lower left corner that the legend takes, or what is in its place. @returns {[number, number]} */
  const legendCorner = () => {
    const bar = isLow.matches && document.getElementById("selection");
    const there = bar && bar.checkVisibility() ? bar : byId("legend");
    return there.checkVisibility() ? [there.getBoundingClientRect().right - stage.getBoundingClientRect().left + GAP, above(there)] : [0, 0];
  };

  return ({ search: { film, text } }) => {
    told = film === null && !text ? 0 : Math.max(told, below("#search-box"));
    // Nor under the pointer; what is placed is selected, and its bar is below the palette.
    const bars = isLow.matches ? below("#kinds") : Math.max(below("#kinds", GAP + BAR), below("#selection"));
    if (!isPressed) carried = below("#carry-note");
    // On a phone the floor needs the room again.
    if (!isPressed) palette = isNarrow.matches || (bars === 0 && stage.dataset.tool === "view") ? bars : Math.max(palette, bars);
    const next = Math.max(told, palette, below("#message"), carried, below("#ending"), below("#game"), below(".over-floor"), below(".embed .to-page"), below("#tools", 2));
    // In a frame, on the full screen, beside a lesson on a phone.
    const isBare = stage.checkVisibility() && !byId("tools").checkVisibility();
    const foot = isBare ? (isSmallFrame() ? 0 : Math.max(above(byId("legend")), above(byId("zoom-in")))) : undefined;
    const [[right, low], [left, deep]] = [corner(), legendCorner()];
    if (changed(stage, "clear", [next, foot, right, low, left, deep].join())) app.playground.keep_clear(next, foot, right, low, left, deep);
  };
}
