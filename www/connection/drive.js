// @ts-check
// Driving the robot by hand. The worker stops it when it hasn't heard for 200 ms.
import { button, byId, setHidden, setText } from "../dom.js";
import { STILL, joystick, rounded } from "../joystick.js";
import { currentTab } from "../tabs.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */

/** How often a command is said again while it is held, ms. */
const AGAIN_MS = 40;

/** Elements that use arrows or letters themselves. */
const OWN_KEYS = "input:not([type=checkbox], [type=button], [type=file]), textarea, select, .console, [contenteditable]";

/** @param {ConnectionTab} it */
export function startDrive(it) {
  const [floor, knob] = [byId("connection-floor"), button("connection-knob")];
  const mayDrive = () => currentTab() === "connection" && it.view.can.steer;
  let isDriving = false;
  /** Whether all controls were released since driving became possible: taking control must not start motion. */
  let wasStill = false;

  const end = () => {
    if (!isDriving) return;
    isDriving = false;
    // A hidden page has given control back already.
    if (!document.hidden) void it.request({ do: "drive", ...STILL });
  };
  const here = byId("panel-connection");
  /** Buttons don't use arrows, so driving is possible with one focused. @param {EventTarget | null} target */
  const isFree = (target) => target === document.body || (target instanceof Element && here.contains(target) && !target.matches(OWN_KEYS));
  const stick = joystick({
    pad: byId("connection-pad"),
    knob,
    told: byId("connection-blocked"),
    targets: [document.body, floor, knob],
    takes: ({ target }) => mayDrive() && isFree(target) && !document.querySelector("dialog[open]"),
    begin: () => {
      // Not what a gamepad says all along.
      wasStill = true;
    },
    end,
  });
  const stop = () => {
    stick.release();
    wasStill = false;
    end();
  };

  setInterval(() => {
    if (!mayDrive() || document.hidden) {
      if (isDriving) stop();
      wasStill = false;
      stick.showBlocked(null, STILL);
      return;
    }
    const command = rounded(stick.read().command);
    const isStill = command.forward === 0 && command.left === 0;
    wasStill ||= isStill;
    // Not with the next view, which can be late.
    stick.showBlocked(it.view.ride?.blocked ?? null, wasStill ? command : STILL);
    if (!wasStill) return;
    stick.show(command);
    if (isStill) {
      end();
      return;
    }
    isDriving = true;
    void it.request({ do: "drive", ...command }).then((worked) => worked || stop());
  }, AGAIN_MS);

  return {
    stop,
    /** @param {import("./types").ConnectionView} view */
    update({ can }) {
      setHidden(byId("connection-manual"), !can.steer);
      if (!can.steer) return;
      const { hasGamepad } = stick.read();
      setText(byId("connection-manual-note"), hasGamepad ? "Gamepad connected." : "Drag, or arrow keys or WASD.");
    },
  };
}
