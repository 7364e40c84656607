// @ts-check
// Manual input: keys, a gamepad, and a joystick on the screen, all at once.
import { setAttribute, setText } from "./dom.js";

/**
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
/** @type {Command} */
export const STILL = { forward: 0, left: 0 };

/**
 * A joystick on the screen, the keys that do the same, and a gamepad.
 * @param {object} parts
 * @param {HTMLElement} parts.pad
 * @param {HTMLElement} parts.knob
 * @param {Element} parts.told The element for blocked directions.
 * @param {HTMLElement[]} parts.targets Where keys drive.
 * @param {(event: KeyboardEvent) => boolean} parts.takes Whether a key that could drive is meant to.
 * @param {() => void} parts.begin Called when a person takes the controls.
 * @param {() => void} parts.end They were let go at once: focus, window or page are gone.
 * @param {boolean} [parts.takesHeld] Whether a key drives that was held before the controls could be taken. Not for real robots: one
 *   that was stopped must not go on.
 */
export function joystick({ pad, knob, told, targets, takes, begin, end, takesHeld = false }) {
  const held = new Set();
  /** Those that have driven since they were pressed: a stop holds until they are pressed again. */
  const used = new Set();
  let stick = STILL;

  const release = () => {
    held.clear();
    stick = STILL;
    show(STILL);
  };
  const stop = () => {
    release();
    end();
  };
  /** @param {Command} command */
  const show = ({ forward, left }) => {
    knob.style.setProperty("--x", String(-left));
    knob.style.setProperty("--y", String(-forward));
  };
  /** @param {KeyboardEvent} event */
  const press = (event) => {
    if (!KEYS[event.code] || event.ctrlKey || event.metaKey || event.altKey || !takes(event)) return;
    // Neither the view nor a tool gets it.
    event.preventDefault();
    event.stopImmediatePropagation();
    if (event.repeat && (!takesHeld || used.has(event.code))) return;
    held.add(event.code);
    used.add(event.code);
    begin();
  };
  for (const target of targets) {
    target.addEventListener("keydown", press, { capture: true });
    target.addEventListener("blur", stop);
  }
  addEventListener("keyup", ({ code }) => [held, used].forEach((codes) => codes.delete(code)));
  addEventListener("blur", stop);
  document.addEventListener("visibilitychange", () => document.hidden && stop());

  /** The pad's position when it was pressed: layout changes under a finger must not affect the command. */
  let box = pad.getBoundingClientRect();
  /** @param {PointerEvent} event */
  const drag = (event) => {
    const reach = REACH * box.width;
    const [x, y] = [(event.clientX - box.left - box.width / 2) / reach, (event.clientY - box.top - box.height / 2) / reach];
    const length = Math.max(1, Math.hypot(x, y));
    stick = { forward: -y / length, left: -x / length };
  };
  pad.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pad.setPointerCapture(event.pointerId);
    pad.classList.add("held");
    box = pad.getBoundingClientRect();
    begin();
    drag(event);
  });
  pad.addEventListener("pointermove", (event) => pad.hasPointerCapture(event.pointerId) && drag(event));
  for (const gone of ["pointerup", "pointercancel", "lostpointercapture"]) {
    pad.addEventListener(gone, () => {
      stick = STILL;
      pad.classList.remove("held");
    });
  }

  return {
    release,
    show,
    /** The current command, and whether a gamepad is connected. */
    read() {
      const gamepad = gamepadCommand();
      const keys = [...held].reduce((sum, code) => ({ forward: sum.forward + (KEYS[code]?.[0] ?? 0), left: sum.left + (KEYS[code]?.[1] ?? 0) }), STILL);
      return { command: limited(stick, keys, gamepad ?? STILL), hasGamepad: gamepad !== undefined };
    },
    /** @param {import("./types").PageView["blocked"]} blocked @param {Command} command */
    showBlocked: (blocked, command) => showBlocked(pad, told, blocked, command),
  };
}

/** The command in discrete steps. @param {Command} command @returns {Command} */
export const rounded = ({ forward, left }) => ({ forward: Math.round(forward * 50) / 50, left: Math.round(left * 50) / 50 });

/** In the order of `View.blocked`. @type {Way[]} */
const WAYS = ["forward", "left", "right", "backward"];

/**
 * Shows allowed and commanded directions, and why others are blocked.
 * @param {HTMLElement} pad @param {Element} told @param {import("./types").PageView["blocked"]} blocked @param {Command} command
 */
function showBlocked(pad, told, blocked, { forward, left }) {
  const asked = { forward: forward > 0, backward: forward < 0, left: left > 0, right: left < 0 };
  /** @param {Way} way */
  const why = (way) => blocked?.[WAYS.indexOf(way)];
  for (const way of WAYS) {
    const mark = pad.querySelector(`[data-way=${way}]`);
    if (mark) setAttribute(mark, "class", why(way) ? "way shut" : asked[way] ? "way used" : "way");
  }
  const shut = WAYS.filter(why);
  // The reasons of the commanded directions first; without a command, all of them.
  const first = shut.filter((way) => asked[way]);
  const named = first.length > 0 ? first : shut;
  const open = WAYS.filter((way) => !why(way));
  if (shut.length === 0) setText(told, "");
  else if (open.length === 1) setText(told, capital(`${reasons(shut.map(why))}: only ${open[0] === "backward" ? "back" : open[0]} is allowed`));
  else setText(told, capital(`${named.join(" and ")} blocked: ${reasons(named.map(why))}`));
}

/** Their common text, short enough to read while driving. @param {(string | null | undefined)[]} all */
function reasons(all) {
  const each = new Set(all);
  const heads = new Set([...each].map((one) => one?.replace(/ (in front|on the (left|right))$/, "")));
  return [...(each.size > 1 ? heads : each)].join("; ");
}

/** @param {string} text */
const capital = (text) => `${text.charAt(0).toUpperCase()}${text.slice(1)}`;

/** All together, no more than full. @param {...Command} commands @returns {Command} */
function limited(...commands) {
  const limit = (/** @type {number} */ value) => Math.max(-1, Math.min(1, value));
  return { forward: limit(commands.reduce((sum, c) => sum + c.forward, 0)), left: limit(commands.reduce((sum, c) => sum + c.left, 0)) };
}

/** The command of the first gamepad; `undefined` without one. @returns {Command | undefined} */
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
