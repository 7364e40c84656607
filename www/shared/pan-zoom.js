// @ts-check
// A picture under the hands: wheel, drag, pinch, double click and keys move it. What else a hand means is up to its tab.
import { changed } from "../dom.js";

/**
 * @typedef {{ x: number, y: number }} Spot CSS pixels of the canvas.
 * @typedef {"left" | "right" | "up" | "down" | "apply" | "escape"} Action
 * @typedef {object} Picture
 * @property {(dx: number, dy: number) => void} pan
 * @property {(x: number, y: number, factor: number) => void} zoom
 * @property {() => void} fit
 * @typedef {object} Hands
 * @property {(kind: "down" | "move" | "up" | "cancel", x: number, y: number, button: number) => unknown} [pointer] One pointer; if "down" gives `false`, it moves the view.
 * @property {(at: Spot) => void} [hover] The mouse, with no button down.
 * @property {boolean} [draws] Whether moves between two frames count too.
 * @property {() => boolean} [hasTool] Whether a tool is in the hand, so that a double click is none for the view.
 * @property {(action: Action, event: KeyboardEvent) => boolean} [key] Whether it takes the key, which moves the view otherwise.
 */

/** How far an arrow key moves the view, CSS pixels. */
const KEY_PAN = 60;
/** Pixels that a line of a mouse wheel stands for. */
const WHEEL_LINE = 16;
/** @type {Record<string, Action>} */
const ACTIONS = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Enter: "apply", Escape: "escape" };
/** @type {Record<string, [dx: number, dy: number]>} */
export const PANS = { left: [KEY_PAN, 0], right: [-KEY_PAN, 0], up: [0, KEY_PAN], down: [0, -KEY_PAN] };

/** @param {HTMLCanvasElement} canvas @param {Picture} picture @param {Hands} hands */
export function startHands(canvas, picture, { pointer, hover, draws, hasTool, key }) {
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : WHEEL_LINE);
    // A pinch on a touchpad comes as a wheel with control and small steps.
    picture.zoom(event.offsetX, event.offsetY, Math.exp(-Math.max(-120, Math.min(120, pixels)) * (event.ctrlKey ? 0.01 : 0.0016)));
  }, { passive: false });
  canvas.addEventListener("dblclick", () => hasTool?.() || picture.fit());
  canvas.addEventListener("keydown", (event) => {
    const action = ACTIONS[event.key];
    if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
    const [by, isTaken] = [PANS[action], key?.(action, event)];
    if (isTaken || by) event.preventDefault();
    if (!isTaken && by) picture.pan(...by);
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());

  /** Pointers that are down. @type {Map<number, Spot>} */
  const down = new Map();
  /** Their gesture. @type {"tool" | "pan" | "pinch"} */
  let gesture = "pan";
  /** @param {PointerEvent} event @returns {Spot} */
  const spot = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  canvas.addEventListener("pointerdown", (event) => {
    if (down.size >= 2) return;
    canvas.setPointerCapture(event.pointerId);
    const at = spot(event);
    down.set(event.pointerId, at);
    if (down.size === 2) {
      // The second finger turns what the first one began into a pinch.
      if (gesture === "tool") pointer?.("cancel", at.x, at.y, 0);
      gesture = "pinch";
    } else gesture = pointer && pointer("down", at.x, at.y, event.button) !== false ? "tool" : "pan";
    canvas.classList.toggle("grabbed", gesture === "pan" || !hasTool?.());
    canvas.classList.add("pressed");
  });
  canvas.addEventListener("pointermove", (event) => {
    const [before, at] = [down.get(event.pointerId), spot(event)];
    if (!before) return event.pointerType === "mouse" && hover?.(at);
    down.set(event.pointerId, at);
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (gesture === "tool") {
      for (const point of (draws && event.getCoalescedEvents?.()) || [event]) {
        const { x, y } = spot(point);
        pointer?.("move", x, y, 0);
      }
    } else if (other) {
      const far = (/** @type {Spot} */ { x, y }) => Math.max(1, Math.hypot(x - other.x, y - other.y));
      picture.pan((at.x - before.x) / 2, (at.y - before.y) / 2);
      picture.zoom((at.x + other.x) / 2, (at.y + other.y) / 2, far(at) / far(before));
    } else picture.pan(at.x - before.x, at.y - before.y);
  });
  for (const [type, kind] of /** @type {const} */ ([["pointerup", "up"], ["pointercancel", "cancel"]])) {
    canvas.addEventListener(type, (event) => {
      if (!down.delete(event.pointerId)) return;
      const { x, y } = spot(event);
      if (gesture === "tool") pointer?.(kind, x, y, 0);
      // The finger that remains after a pinch keeps panning.
      gesture = "pan";
      canvas.classList.toggle("grabbed", down.size > 0);
      canvas.classList.toggle("pressed", down.size > 0);
    });
  }
}

/**
 * The buttons that zoom, and the keys that do the same.
 * @param {HTMLElement} stage Holds them, and the canvas. @param {Picture} picture
 * @returns {(key: string) => boolean} Whether a key was used.
 */
export function startZoom(stage, picture) {
  const middle = (/** @type {number} */ factor) => {
    const { clientWidth, clientHeight } = stage.querySelector("canvas") ?? stage;
    picture.zoom(clientWidth / 2, clientHeight / 2, factor);
  };
  for (const node of stage.querySelectorAll("button")) {
    const how = node.dataset.zoom ?? /^zoom-(.*)/.exec(node.id)?.[1];
    if (!how) continue;
    node.disabled = false;
    node.addEventListener("click", () => (how === "fit" ? picture.fit() : middle(how === "in" ? 1.4 : 1 / 1.4)));
  }
  return (key) => {
    if (key === "0") picture.fit();
    else if (/^[+=-]$/.test(key)) middle(key === "-" ? 0.8 : 1.25);
    else return false;
    return true;
  };
}

/** Before each frame: says how large the canvas is, when that is another size. @param {HTMLCanvasElement} canvas @param {{ resize(width: number, height: number, ratio: number): void }} picture */
export function fitSize(canvas, picture) {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (width === 0 || height === 0 || !changed(canvas, "size", `${width} ${height} ${devicePixelRatio}`)) return;
  picture.resize(width, height, devicePixelRatio);
}
