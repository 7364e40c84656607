// @ts-check
// Control of the robot: modes, why one was lost, sleep and battery, and the stop button.
import { button, byId, changed, setAttribute, setEnabled, setHidden, setText } from "../dom.js";
import { currentTab } from "../tabs.js";
import { ask } from "./dialogs.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */
/** @typedef {import("./types").ConnectionView} ConnectionView */

/** @param {ConnectionTab} it @returns {(view: ConnectionView) => void} */
export function startControl(it) {
  const stop = () => {
    it.halt();
    void it.request({ do: "stop" });
  };
  button("connection-stop").addEventListener("click", stop);
  startStopKeys(it, stop);
  for (const id of ["connection-arm", "connection-rearm", "connection-bar-arm"]) button(id).addEventListener("click", () => it.view.can.arm && void it.request({ do: "arm", full: false }));
  button("connection-disarm").addEventListener("click", () => it.view.can.disarm && void it.request({ do: "disarm" }));
  button("connection-full").addEventListener("click", async () => {
    if (!it.view.can.arm) return;
    const agreed = await ask({
      title: "Without the robot's own safety stop?",
      points: [
        "In Full mode the robot does not stop at stairs, when it is lifted, or when its charger is plugged in.",
        "Its buttons don't work, and it never sleeps: left alone, it drains its battery until it is damaged.",
        "This page still stops it at obstacles, if its sensors report them in time.",
      ],
      yes: "Full control",
      isWarning: true,
    });
    if (agreed) await it.request({ do: "arm", full: true });
  });

  return (view) => {
    const open = view.is_open && !view.is_recording;
    const isThere = view.phase === "connected" && open;
    setHidden(button("connection-stop"), !open);
    button("connection-stop").classList.toggle("moving", view.is_moving || view.moves_alone || (view.motors & 7) !== 0);
    // Who only watches has nothing to choose.
    for (const id of ["connection-control", "connection-ride"]) setHidden(byId(id), !isThere || view.transport.is_watching);
    for (const row of byId("connection-modes").children) {
      const isIn = row.getAttribute("data-mode") === view.mode;
      setAttribute(row, "class", isIn ? "in" : "");
      setAttribute(row, "aria-current", String(isIn));
    }
    setEnabled(button("connection-arm"), view.can.arm && view.mode !== "Safe");
    // Only marked as disabled: clicking it explains why.
    setAttribute(button("connection-full"), "aria-disabled", String(!view.can.arm));
    setAttribute(button("connection-full"), "data-tip", fullTip(view));
    setHidden(button("connection-bar-arm"), !isThere || !view.can.arm || view.drop !== null);
    setEnabled(button("connection-disarm"), view.can.disarm);
    setText(byId("connection-clock"), view.clock);
    setHidden(byId("connection-drop"), !isThere || view.drop === null);
    setText(byId("connection-drop-text"), view.drop?.text ?? "");
    setText(byId("connection-drop-remedy"), view.drop?.remedy ?? "");
    setHidden(button("connection-rearm"), !view.drop?.can_rearm);
    const { title, note } = view.doing;
    setText(byId("connection-doing"), title);
    setText(byId("connection-doing-note"), note);
    if (changed(byId("connection-said"), "said", title)) setText(byId("connection-said"), `${title}: ${note}`);
  };
}

/** @param {ConnectionView} view */
const fullTip = ({ can, mode }) =>
  can.arm ? "The page drives, and the robot never stops by itself. You have to confirm." : mode === "Full" ? "Already active." : mode === "Safe" ? "Not from Safe: release control first." : "No robot is connected.";

/**
 * Space and Escape stop the robot, wherever the focus is. Buttons are pressed by Enter here: stopping twice must not
 * start the focused action.
 * @param {ConnectionTab} it @param {() => void} stop
 */
function startStopKeys(it, stop) {
  /** @param {KeyboardEvent} event */
  const isStop = (event) => {
    if (currentTab() !== "connection" || !it.view.is_open || it.view.is_recording || (event.key !== " " && event.key !== "Escape")) return false;
    const target = event.target instanceof Element ? event.target : document.body;
    const writes = target.matches("textarea, input:not([type=checkbox], [type=range], [type=radio], [type=file])");
    return event.key === "Escape" || !writes;
  };
  addEventListener("keydown", (event) => {
    if (!isStop(event)) return;
    if (!event.repeat) stop();
    if (event.key === "Escape") return;
    const target = event.target instanceof Element ? event.target : document.body;
    // These know no other key.
    if (target.matches("summary, select, input")) return;
    event.preventDefault();
    event.stopImmediatePropagation();
  }, { capture: true });
  // A button is pressed when the key comes up.
  addEventListener("keyup", (event) => {
    const target = event.target instanceof Element ? event.target : document.body;
    if (event.key === " " && isStop(event) && target.matches("button, a")) event.preventDefault();
  }, { capture: true });
}
