// @ts-check
// How a drawing or picture is turned, and the angle at which its walls would be straight.
import { button, byId, input, setHidden, setText } from "../dom.js";
import { onNumber, plain, showValue } from "./fields.js";

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startTurn(it) {
  const [angle, straighten] = [input("floor-plan-turn"), button("floor-plan-straighten")];
  const turn = (/** @type {number} */ degrees) => void it.ask({ type: "turn", degrees }, "Turning the floor plan");
  const now = () => it.view?.settings.turn ?? 0;
  onNumber(angle, turn);
  for (const node of byId("floor-plan-turn-group").querySelectorAll("button")) {
    const by = Number(node.dataset.turn);
    if (by) node.addEventListener("click", () => turn(now() + by));
  }
  straighten.addEventListener("click", () => turn(now() - (it.view?.askew ?? 0)));
  return (view) => {
    if (!view) return;
    setHidden(byId("floor-plan-turn-group"), view.kind === "map");
    showValue(angle, plain(view.settings.turn));
    setHidden(straighten, view.askew === null);
    if (view.askew !== null) setText(straighten, `Straighten: walls are ${Math.abs(view.askew).toFixed(1)}° askew`);
  };
}
