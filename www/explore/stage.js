// @ts-check
// The floor: pointers, wheel, pinch, keys and size of the canvas.
import { button, byId, typed } from "../dom.js";
import { pickUp, startCarry } from "./carry.js";
import { zoomCentre } from "../keys.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {{ x: number, y: number }} Spot
 */

/** How far an arrow key moves the view, CSS pixels. */
const KEY_PAN = 60;
/** Pixels that a line of a mouse wheel stands for. */
const WHEEL_LINE = 16;

/** @param {App} app @returns {() => void} what to call before each frame */
export function startStage(app) {
  const canvas = typed("floor", HTMLCanvasElement);
  startPointers(app, canvas);
  startToolbar(app);
  startCarry(app, canvas);

  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : WHEEL_LINE);
      // A pinch on a touchpad comes as a wheel with control and small steps.
      const factor = Math.exp(-Math.max(-120, Math.min(120, pixels)) * (event.ctrlKey ? 0.01 : 0.0016));
      app.act((p) => p.zoom(event.offsetX, event.offsetY, factor));
    },
    { passive: false },
  );
  canvas.addEventListener("dblclick", () => app.view.tool === "view" && app.act((p) => p.fit()));

  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (app.view.is_carried) return;
    const action = KEYS[event.key];
    if (!action) return;
    event.preventDefault();
    if (app.view.tool !== "view") app.act((p) => p.key_edit(action));
    else if (action !== "apply") app.act((p) => p.pan(...PANS[action]));
  });

  let size = "";
  return () => {
    const { clientWidth: width, clientHeight: height } = canvas;
    const now = `${width} ${height} ${devicePixelRatio}`;
    if (now === size || width === 0 || height === 0) return;
    size = now;
    app.playground.resize(width, height, devicePixelRatio);
  };
}

/** How far a mouse moves, px, until it leads a robot that is in the hand. */
const LED = 8;

/** @type {Record<string, "left" | "right" | "up" | "down" | "apply">} */
const KEYS = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Enter: "apply" };
/** @type {Record<"left" | "right" | "up" | "down", [number, number]>} */
const PANS = { left: [KEY_PAN, 0], right: [-KEY_PAN, 0], up: [0, KEY_PAN], down: [0, -KEY_PAN] };

/** @param {App} app @param {HTMLCanvasElement} canvas */
function startPointers(app, canvas) {
  /** Pointers that are down. @type {Map<number, Spot>} */
  const down = new Map();
  /** What the first pointer does; what a tool does with it is decided in Rust. @type {"none" | "tool" | "pan" | "pinch"} */
  let gesture = "none";

  /** @param {PointerEvent} event @returns {Spot} */
  const spot = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  /** Where the pointer lay when a key was pressed: a robot moved by keys isn't taken from there by a trembling mouse. @type {Spot | undefined} */
  let lay;
  let hover = { x: 0, y: 0 };
  addEventListener("keydown", () => (lay = hover));
  const isLed = (/** @type {Spot} */ at) => {
    hover = at;
    if (lay && Math.hypot(at.x - lay.x, at.y - lay.y) < LED) return false;
    lay = undefined;
    return true;
  };

  canvas.addEventListener("pointerdown", (event) => {
    if (down.size >= 2) return;
    canvas.setPointerCapture(event.pointerId);
    const at = spot(event);
    down.set(event.pointerId, at);
    if (down.size === 2) {
      // The second finger turns what the first one began into a pinch.
      if (gesture === "tool") app.act((p) => p.pointer("cancel", at.x, at.y));
      gesture = "pinch";
    } else if (event.button !== 0) {
      gesture = "pan";
    } else {
      gesture = "tool";
      app.act((p) => p.pointer("down", at.x, at.y));
    }
    canvas.classList.toggle("grabbed", gesture === "pan" || app.view.tool === "view");
  });

  canvas.addEventListener("pointermove", (event) => {
    const at = spot(event);
    const before = down.get(event.pointerId);
    if (!before) {
      // Hovering shows where a tool would act, and carries a robot that is held.
      if (event.pointerType === "mouse" && (app.view.tool !== "view" || (app.view.is_carried && isLed(at)))) app.act((p) => p.pointer("move", at.x, at.y));
      return;
    }
    if (gesture === "tool") {
      for (const point of event.getCoalescedEvents?.() ?? [event]) {
        const { x, y } = spot(point);
        app.act((p) => p.pointer("move", x, y));
      }
    } else if (gesture === "pan") {
      app.act((p) => p.pan(at.x - before.x, at.y - before.y));
    } else if (gesture === "pinch") {
      const [other] = [...down].filter(([id]) => id !== event.pointerId).map(([, s]) => s);
      if (other) pinch(app, other, before, at);
    }
    down.set(event.pointerId, at);
  });

  /** @param {PointerEvent} event */
  const release = (event) => {
    if (!down.delete(event.pointerId)) return;
    const at = spot(event);
    if (gesture === "tool") app.act((p) => p.pointer(event.type === "pointerup" ? "up" : "cancel", at.x, at.y));
    // The finger that is left over after a pinch goes on moving the view.
    gesture = gesture === "pinch" && down.size === 1 ? "pan" : "none";
    canvas.classList.toggle("grabbed", gesture === "pan");
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
}

/** One of two fingers moves. @param {App} app @param {Spot} still @param {Spot} before @param {Spot} after */
function pinch(app, still, before, after) {
  const distance = (/** @type {Spot} */ s) => Math.max(Math.hypot(s.x - still.x, s.y - still.y), 1);
  const factor = distance(after) / distance(before);
  app.act((p) => {
    p.pan((after.x - before.x) / 2, (after.y - before.y) / 2);
    p.zoom((after.x + still.x) / 2, (after.y + still.y) / 2, factor);
  });
}

/** @param {App} app */
function startToolbar(app) {
  for (const node of byId("tools").querySelectorAll("button[data-tool]")) {
    const tool = /** @type {import("../types").FloorTool} */ (node.getAttribute("data-tool"));
    node.addEventListener("click", () => {
      if (tool === "view" || app.view.can.edit) app.act((p) => p.set_tool(tool));
    });
  }
  button("lift").addEventListener("click", () => pickUp(app));
  button("undo").addEventListener("click", () => app.view.can.undo && app.act((p) => p.undo()));
  button("redo").addEventListener("click", () => app.view.can.redo && app.act((p) => p.redo()));
  button("zoom-in").addEventListener("click", () => app.act((p) => zoomCentre(p, 1.4)));
  button("zoom-out").addEventListener("click", () => app.act((p) => zoomCentre(p, 1 / 1.4)));
  button("zoom-fit").addEventListener("click", () => app.act((p) => p.fit()));
  for (const id of ["zoom-in", "zoom-out", "zoom-fit"]) button(id).disabled = false;
  button("planning-cancel").addEventListener("click", () => app.cancelPlanning());
  button("planning-keep").addEventListener("click", () => app.view.can.keep && app.keepPlan());
}
