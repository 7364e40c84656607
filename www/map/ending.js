// @ts-check
// The end of cleaning with a map: what the robot estimates, what is true, and what to try next.
import { byId, changed, make, setHidden } from "../dom.js";
import { percent } from "../format.js";

/** @returns {(view: import("../types").MapView) => void} */
export function startEnding() {
  const words = make("p", { role: "status" });
  const lose = make("button", { type: "button", className: "link", onclick: () => byId("map-lose").click() }, "kidnap the robot, and let it relocalise on this map");
  const next = make("p", { className: "ending-next" }, "Try next: ", lose, ".");
  const close = make("button", { type: "button", className: "quiet square", "aria-label": "Dismiss" });
  close.append(/** @type {Node} */ (byId("message-close").firstElementChild).cloneNode(true));
  const card = make("div", { className: "message ending", id: "map-end", hidden: true }, make("div", {}, words, next), close);
  byId("map-return").before(card);
  let isDismissed = false;
  close.addEventListener("click", () => {
    isDismissed = true;
    byId("map-floor").focus();
  });

  return ({ phase, by_map, coverage, activity, can }) => {
    const isOver = phase === "finished" && by_map !== null && activity.startsWith("done");
    if (!isOver) isDismissed = false;
    setHidden(card, !isOver || isDismissed);
    if (!isOver) return;
    const [swept, all] = by_map;
    const estimated = `By its map the robot has swept ${percent(swept / Math.max(all, 1e-9))} %; the other ${(all - swept).toFixed(1)} m² are spots too small or too narrow.`;
    const text = `${estimated} Actually swept: ${percent(coverage)} % of the floor, as neither map nor position is exact.`;
    if (changed(card, "text", text)) words.textContent = text;
    setHidden(next, !can.open || !can.use_map);
  };
}
