// @ts-check
// The canvas of the drawing board: size, pointers, wheel, pinch, keys. What they mean is decided in the worker.
import { byId, setAttribute, setHidden, setText } from "../dom.js";

/** @typedef {import("./tab.js").FloorPlanTab} FloorPlanTab */
/** @typedef {{ x: number, y: number }} Spot */

/** Pixels that a line of a mouse wheel stands for. */
const WHEEL_LINE = 16;
/** @type {Record<string, string>} */
const KEYS = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Enter: "apply", Escape: "escape" };
/** @type {Record<string, string>} */
const HINTS = {
  scale: "Click two points whose distance you know. Keyboard: arrows move the crosshair, Enter sets a point, Escape ends.",
  rectangle: "Drag over the part to clean, or click two corners. Keyboard: arrows and Enter.",
  polygon: "Click the corners; Enter or a double click closes the polygon, Escape cancels it. Keyboard: arrows and Enter, twice to close.",
  room: "Click into the room to clean. Open doors bound it if gaps of their width are closed. Keyboard: arrows and Enter.",
};

/** @param {FloorPlanTab} it @returns {(canvas: HTMLCanvasElement) => void} what to call for every new canvas */
export function startCanvas(it) {
  const stage = byId("floor-plan-stage");
  const size = () => {
    const { clientWidth: width, clientHeight: height } = stage;
    if (width > 0 && height > 0) it.client.say({ type: "resize", width, height, ratio: devicePixelRatio });
  };
  new ResizeObserver(size).observe(stage);
  for (const node of stage.querySelectorAll("[data-zoom]")) {
    const how = node.getAttribute("data-zoom");
    node.addEventListener("click", () => it.client.say(how === "fit" ? { type: "fit" } : { type: "middle", factor: how === "in" ? 1.4 : 1 / 1.4 }));
  }
  return (canvas) => {
    size();
    startPointers(it, canvas);
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : WHEEL_LINE);
        const factor = Math.exp(-Math.max(-120, Math.min(120, pixels)) * (event.ctrlKey ? 0.01 : 0.0016));
        it.client.say({ type: "zoom", x: event.offsetX, y: event.offsetY, factor });
      },
      { passive: false },
    );
    canvas.addEventListener("dblclick", () => it.view?.tool === "view" && it.client.say({ type: "fit" }));
    canvas.addEventListener("keydown", (event) => {
      const action = KEYS[event.key];
      if (!action || event.ctrlKey || event.metaKey || event.altKey) return;
      // Escape closes other things where no tool is in the hand; whether one is, the worker knows first.
      if (action !== "escape" || it.view?.tool !== "view") {
        event.preventDefault();
        event.stopPropagation();
      }
      it.client.say({ type: "key", action, fine: event.shiftKey });
    });
  };
}

/** What the tool in the hand wants. @param {import("./types").FloorPlanView | undefined} view */
export function hint(view) {
  const text = view && HINTS[view.tool];
  setHidden(byId("floor-plan-hint"), !text || view?.is_measured === true);
  setText(byId("floor-plan-hint"), text ?? "");
  setAttribute(byId("floor-plan-stage"), "data-tool", view?.tool ?? "view");
}

/** @param {FloorPlanTab} it @param {HTMLCanvasElement} canvas */
function startPointers({ client }, canvas) {
  /** @type {Map<number, Spot>} */
  const down = new Map();
  let isPinch = false;
  /** @param {string} kind @param {Spot} at */
  const say = (kind, { x, y }) => client.say({ type: "pointer", kind, x, y });

  canvas.addEventListener("pointerdown", (event) => {
    if (down.size >= 2) return;
    canvas.setPointerCapture(event.pointerId);
    const at = { x: event.offsetX, y: event.offsetY };
    down.set(event.pointerId, at);
    if (down.size === 1) say("down", at);
    else {
      say("cancel", at);
      isPinch = true;
    }
    canvas.classList.toggle("grabbed", true);
  });
  canvas.addEventListener("pointermove", (event) => {
    const at = { x: event.offsetX, y: event.offsetY };
    const from = down.get(event.pointerId);
    if (!from) {
      if (event.pointerType === "mouse") say("move", at);
      return;
    }
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (isPinch && other) {
      const far = (/** @type {Spot} */ spot) => Math.max(1, Math.hypot(spot.x - other.x, spot.y - other.y));
      client.say({ type: "pan", dx: (at.x - from.x) / 2, dy: (at.y - from.y) / 2 });
      client.say({ type: "zoom", x: (at.x + other.x) / 2, y: (at.y + other.y) / 2, factor: far(at) / far(from) });
    } else if (isPinch) client.say({ type: "pan", dx: at.x - from.x, dy: at.y - from.y });
    else say("move", at);
    down.set(event.pointerId, at);
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) {
    canvas.addEventListener(kind, (event) => {
      if (!down.delete(event.pointerId)) return;
      if (!isPinch) say(kind === "pointerup" ? "up" : "cancel", { x: event.offsetX, y: event.offsetY });
      if (down.size === 0) isPinch = false;
      canvas.classList.toggle("grabbed", down.size > 0);
    });
  }
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
}
