// @ts-check
// Driving by hand: keys, a gamepad, and a joystick on the screen.
import { button, byId, changed, setAttribute, setHidden, setText } from "./dom.js";

/**
 * @typedef {import("./main.js").App} App
 * @typedef {import("./types").View} View
 * @typedef {"forward" | "left" | "right" | "backward"} Way
 * @typedef {{ forward: number, left: number }} Command
 */

/** Share of a gamepad's stick that counts as the middle: worn sticks don't come back to it. */
const DEAD_ZONE = 0.15;
/** Reach of the knob, as a share of the pad's width. */
const REACH = 0.3;
/** Buttons of a standard gamepad's cross. @type {[button: number, forward: number, left: number][]} */
const CROSS = [[12, 1, 0], [13, -1, 0], [14, 0, 1], [15, 0, -1]];
/** @type {Record<string, [forward: number, left: number]>} */
const KEYS = {
  ArrowUp: [1, 0], KeyW: [1, 0],
  ArrowDown: [-1, 0], KeyS: [-1, 0],
  ArrowLeft: [0, 1], KeyA: [0, 1],
  ArrowRight: [0, -1], KeyD: [0, -1],
};
const STILL = { forward: 0, left: 0 };

/** @param {App} app @returns {(view: View) => void} */
export function startManual(app) {
  const [pad, knob] = [byId("pad"), button("knob")];
  const held = new Set();
  /** @type {Command} */
  let stick = STILL;
  let sent = STILL;

  const isManual = () => app.catalogue.behaviours.find(({ id }) => id === app.view.algorithm)?.manual ?? false;

  /** Whoever takes the controls wants to drive. */
  const begin = () => {
    if (app.view.can.play && app.view.state !== "failed") app.act((p) => p.play());
  };
  const stop = () => {
    held.clear();
    stick = STILL;
    show(STILL);
    send(STILL);
  };
  /** @param {Command} command */
  const send = (command) => {
    const rounded = { forward: Math.round(command.forward * 50) / 50, left: Math.round(command.left * 50) / 50 };
    if (rounded.forward === sent.forward && rounded.left === sent.left) return;
    sent = rounded;
    app.act((p) => p.command(rounded.forward, rounded.left));
  };
  /** @param {Command} command */
  const show = ({ forward, left }) => {
    knob.style.setProperty("--x", String(-left));
    knob.style.setProperty("--y", String(-forward));
  };

  /** @param {KeyboardEvent} event */
  const press = (event) => {
    if (!KEYS[event.code] || event.ctrlKey || event.metaKey || event.altKey || !isManual() || app.view.is_carried) return;
    if (event.currentTarget === byId("floor") && app.view.tool !== "view") return;
    // Neither the view nor a tool gets it.
    event.preventDefault();
    event.stopImmediatePropagation();
    if (event.repeat) return;
    held.add(event.code);
    begin();
  };
  for (const target of [byId("floor"), knob]) {
    target.addEventListener("keydown", press, { capture: true });
    target.addEventListener("blur", stop);
  }
  addEventListener("keyup", ({ code }) => held.delete(code));
  addEventListener("blur", stop);
  document.addEventListener("visibilitychange", () => document.hidden && stop());

  /** @param {PointerEvent} event */
  const drag = (event) => {
    const box = pad.getBoundingClientRect();
    const reach = REACH * box.width;
    const [x, y] = [(event.clientX - box.left - box.width / 2) / reach, (event.clientY - box.top - box.height / 2) / reach];
    const length = Math.max(1, Math.hypot(x, y));
    stick = { forward: -y / length, left: -x / length };
  };
  pad.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pad.setPointerCapture(event.pointerId);
    pad.classList.add("held");
    begin();
    drag(event);
  });
  pad.addEventListener("pointermove", (event) => pad.hasPointerCapture(event.pointerId) && drag(event));
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
    pad.addEventListener(end, () => {
      stick = STILL;
      pad.classList.remove("held");
    });
  }

  return (view) => {
    // Other tools need the keys, and the room on a small screen.
    const manual = isManual() && view.tool === "view";
    if (changed(byId("manual"), "on", manual)) {
      setHidden(byId("manual"), !manual);
      stop();
    }
    if (!manual) return;
    const gamepad = gamepadCommand();
    const keys = [...held].reduce((sum, code) => ({ forward: sum.forward + (KEYS[code]?.[0] ?? 0), left: sum.left + (KEYS[code]?.[1] ?? 0) }), STILL);
    const command = limited(stick, keys, gamepad ?? STILL);
    showBlocked(view.blocked, sent);
    const turned = changed(pad, "state", view.state);
    if (view.state === "playing") {
      send(command);
      show(command);
    } else if (turned) stop();
    setText(byId("manual-note"), `${gamepad ? "Gamepad connected." : "Drag, or arrow keys or WASD on the floor."}${view.speed === 1 ? " Time runs at 1×." : ""}`);
  };
}

/** In the order of `View.blocked`. @type {Way[]} */
const WAYS = ["forward", "left", "right", "backward"];

/** Which directions are open, which are asked for, and why those that aren't open are not. @param {View["blocked"]} blocked @param {Command} command */
function showBlocked(blocked, { forward, left }) {
  const asked = { forward: forward > 0, backward: forward < 0, left: left > 0, right: left < 0 };
  /** @param {Way} way */
  const why = (way) => blocked?.[WAYS.indexOf(way)];
  for (const way of WAYS) {
    const mark = byId("pad").querySelector(`[data-way=${way}]`);
    if (mark) setAttribute(mark, "class", why(way) ? "way shut" : asked[way] ? "way used" : "way");
  }
  const shut = WAYS.filter(why);
  // What one is trying first; all of them as long as one tries nothing.
  const first = shut.filter((way) => asked[way]);
  const told = first.length > 0 ? first : shut;
  const reasons = new Set(told.map(why));
  const names = told.join(" and ");
  setText(byId("blocked"), told.length > 0 ? `${names.charAt(0).toUpperCase()}${names.slice(1)} blocked: ${[...reasons].join("; ")}` : "");
}

/** All together, no more than full. @param {...Command} commands @returns {Command} */
function limited(...commands) {
  const limit = (/** @type {number} */ value) => Math.max(-1, Math.min(1, value));
  return { forward: limit(commands.reduce((sum, c) => sum + c.forward, 0)), left: limit(commands.reduce((sum, c) => sum + c.left, 0)) };
}

/** What the first gamepad says; `undefined` without one. @returns {Command | undefined} */
function gamepadCommand() {
  const gamepad = navigator.getGamepads?.().find((pad) => pad?.connected);
  if (!gamepad) return undefined;
  const axis = (/** @type {number} */ index) => {
    const value = gamepad.axes[index] ?? 0;
    const over = Math.abs(value) - DEAD_ZONE;
    return over > 0 ? (-Math.sign(value) * over) / (1 - DEAD_ZONE) : 0;
  };
  const pressed = CROSS.filter(([index]) => gamepad.buttons[index]?.pressed);
  return limited({ forward: axis(1), left: axis(0) }, ...pressed.map(([, forward, left]) => ({ forward, left })));
}
