// @ts-check
// Driving the simulated robot by hand.
import { button, byId, changed, input, select, setHidden, setText } from "../dom.js";
import { STILL, joystick, rounded } from "../joystick.js";
import { WRITING } from "../keys.js";
import { style } from "../parts.js";
import { isOnFloor } from "../tabs.js";

/** @typedef {import("../main.js").App} App */

/** Whether the browser tells an open menu from a closed one. */
const CAN_BE_OPEN = CSS.supports("selector(:open)");

/** Milliseconds within which letters belong to one name, as in browsers. */
const TYPING = 1000;

/** @param {App} app @returns {Promise<(view: import("../types").PageView) => void>} */
export async function startManual(app) {
  await style(new URL("../manual.css", import.meta.url).href);
  const [floor, pad, knob, menu] = [byId("floor"), byId("pad"), button("knob"), select("algorithm")];
  let sent = STILL;
  /** When a letter was last typed in the menu, ms. */
  let typed = -Infinity;
  /** Whether the setup may still lie over the robot that is to be driven. */
  let isCovered = false;

  const isManual = () => app.catalogue.behaviours.find(({ id }) => id === app.view.algorithm)?.manual ?? false;

  /** @param {import("../joystick.js").Command} command */
  const send = (command) => {
    const next = rounded(command);
    if (next.forward === sent.forward && next.left === sent.left) return;
    sent = next;
    app.act((p) => p.command(next.forward, next.left));
  };
  const end = () => send(STILL);
  const stick = joystick({
    pad,
    knob,
    told: byId("blocked"),
    targets: [floor, knob],
    takes: ({ currentTarget }) => isManual() && !app.view.is_carried && (currentTarget !== floor || app.view.tool === "view"),
    // Taking the controls starts driving.
    begin: () => {
      if (app.view.can.play && app.view.state !== "failed") app.act((p) => p.play());
    },
    end,
    takesHeld: true,
  });
  const stop = () => {
    stick.release();
    end();
  };

  // Wherever else the focus is, letters that mean tools drive; so do all that drive in the menu in which that was chosen.
  const focus = (/** @type {KeyboardEvent} */ event) => {
    const { key, target, ctrlKey, metaKey, altKey, timeStamp } = event;
    // Letters of a name that is typed in the menu.
    const isTyping = target === menu && key.length === 1 && timeStamp - typed < TYPING;
    if (target === menu && key.length === 1) typed = timeStamp;
    if (isTyping) return;
    if (byId("manual").hidden || !input("keys-on").checked || !isOnFloor() || ctrlKey || metaKey || altKey || document.querySelector("dialog[open]")) return;
    const isLetter = "wasd".includes(key.toLowerCase());
    if (!isLetter && !key.startsWith("Arrow")) return;
    // A closed menu would choose another algorithm, and the run by hand would be lost.
    const isMenu = target === menu && CAN_BE_OPEN && !menu.matches(":open");
    const isFree = isLetter && target instanceof Element && target !== floor && target !== knob && !target.matches(WRITING);
    if (!isMenu && !isFree) return;
    floor.focus();
    event.preventDefault();
    event.stopPropagation();
    floor.dispatchEvent(new KeyboardEvent("keydown", { key, code: event.code, cancelable: true }));
  };
  document.addEventListener("keydown", focus, { capture: true });

  return (view) => {
    // Whoever chooses to drive has been drawing, perhaps.
    if (changed(floor, "drives", isManual()) && isManual() && view.tool !== "view") app.act((p) => p.set_tool("view"));
    // Other tools need the keys, and the room on a small screen.
    const manual = isManual() && view.tool === "view";
    if (changed(byId("manual"), "on", manual)) {
      setHidden(byId("manual"), !manual);
      isCovered = manual;
      stop();
    }
    if (!manual) return;
    // On a small screen. The rest of a name that is being typed goes to the menu.
    if (isCovered && !(document.activeElement === menu && performance.now() - typed < TYPING)) {
      isCovered = false;
      if (byId("setup").classList.contains("open")) byId("setup").dispatchEvent(new Event("swiped", { bubbles: true }));
    }
    const { command, hasGamepad } = stick.read();
    // What stands still needs no room for it.
    stick.showBlocked(view.state === "playing" ? view.blocked : null, sent);
    const turned = changed(pad, "state", view.state);
    if (view.state === "playing") {
      send(command);
      stick.show(command);
    } else if (turned) stop();
    setText(byId("manual-note"), `${hasGamepad ? "Gamepad connected." : "Drag, or arrow keys or WASD on the floor."}${view.speed === 1 ? " Time runs at 1×." : ""}`);
  };
}
