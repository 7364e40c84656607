// @ts-check
// The map's canvas: pointers, wheel, pinch and keys. What the pointer does is decided in Rust.
import { button, byId, changed, setAttribute, setEnabled, setText } from "../dom.js";

/** How far an arrow key moves the view, CSS pixels. */
const KEY_PAN = 60;
/** Pixels that a line of a mouse wheel stands for. */
const WHEEL_LINE = 16;
/** @type {Record<string, string>} */
const MOVES = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Enter: "apply", Escape: "back" };
/** With the shift key. @type {Record<string, string>} */
const TURNS = { ArrowLeft: "turn_left", ArrowRight: "turn_right" };

/** @param {import("./tab.js").MapTab} it @param {HTMLCanvasElement} canvas */
export function startCanvas(it, canvas) {
  const { session, act } = it;
  startPointers(it, canvas);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : WHEEL_LINE);
    session.zoom(event.offsetX, event.offsetY, Math.exp(-Math.max(-120, Math.min(120, pixels)) * (event.ctrlKey ? 0.01 : 0.0016)));
  }, { passive: false });
  canvas.addEventListener("dblclick", () => session.fit());
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || it.view.is_carried) return;
    const pan = { ArrowLeft: [KEY_PAN, 0], ArrowRight: [-KEY_PAN, 0], ArrowUp: [0, KEY_PAN], ArrowDown: [0, -KEY_PAN] }[event.key];
    if (!pan) return;
    event.preventDefault();
    session.pan(pan[0] ?? 0, pan[1] ?? 0);
  });
  // Before all others: who carries the robot has the arrow keys for that.
  document.addEventListener("keydown", (event) => {
    if (!it.view.is_carried || byId("panel-map").hidden || event.ctrlKey || event.metaKey || event.altKey) return;
    const isHere = event.target === canvas || event.key === "Escape";
    const action = isHere && (event.shiftKey ? TURNS : MOVES)[event.key];
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    act((s) => s.carry(action));
  }, { capture: true });

  const middle = (/** @type {number} */ factor) => session.zoom(canvas.clientWidth / 2, canvas.clientHeight / 2, factor);
  for (const node of byId("map-stage").querySelectorAll("[data-zoom]")) {
    const how = node.getAttribute("data-zoom");
    node.addEventListener("click", () => (how === "fit" ? session.fit() : middle(how === "in" ? 1.4 : 1 / 1.4)));
  }
  const lift = () => {
    if (!it.view.can.lift && !it.view.can.put_down) return false;
    const isHeld = it.view.is_carried;
    const worked = act((s) => s.pick_up());
    if (!isHeld) canvas.focus();
    return worked;
  };
  button("map-lift").addEventListener("click", lift);
  const layers = startLayers(it);

  /** @type {Record<string, () => unknown>} */
  const keys = {
    "+": () => middle(1.25),
    "=": () => middle(1.25),
    "-": () => middle(0.8),
    0: () => session.fit(),
    p: lift,
    l: layers.open,
    t: () => it.toggle("truth"),
    d: () => it.toggle("difference"),
    o: () => it.toggle("odometry"),
    " ": () => button("map-play").click(),
    ".": () => button("map-step").click(),
    r: () => button("map-reset").click(),
  };
  let size = "";
  return {
    resized() {
      const { clientWidth: width, clientHeight: height } = canvas;
      const now = `${width} ${height} ${devicePixelRatio}`;
      if (now === size || width === 0 || height === 0) return;
      size = now;
      session.resize(width, height, devicePixelRatio);
    },
    /** @param {import("../types").MapView} view */
    update(view) {
      setEnabled(button("map-lift"), view.can.lift || view.can.put_down);
      setText(byId("map-lift-name"), view.is_carried ? "Put down" : "Lift robot");
      setAttribute(button("map-lift"), "aria-pressed", String(view.is_carried));
      layers.update(view);
    },
    /** @param {string} key */
    key(key) {
      const what = keys[key];
      what?.();
      return Boolean(what);
    },
  };
}

/** What is drawn: the buttons over the map, and the whole list. @param {import("./tab.js").MapTab} it */
function startLayers(it) {
  const [list, opener] = [byId("map-layers"), button("map-layers-open")];
  const open = () => {
    list.hidden = !list.hidden;
    setAttribute(opener, "aria-expanded", String(!list.hidden));
    if (!list.hidden) list.querySelector("input")?.focus();
  };
  opener.addEventListener("click", open);
  list.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    open();
    opener.focus();
  });
  const boxes = [...list.querySelectorAll("input")];
  for (const box of boxes) box.addEventListener("change", () => it.act((s) => s.show(box.dataset.layer ?? "", box.checked)));
  const quick = [...byId("map-tools").querySelectorAll("button[data-layer]")];
  for (const node of quick) node.addEventListener("click", () => it.toggle(node.getAttribute("data-layer") ?? ""));
  return {
    open,
    /** @param {import("../types").MapView} view */
    update({ layers }) {
      if (!changed(list, "layers", layers.join())) return;
      for (const box of boxes) box.checked = layers.includes(box.dataset.layer ?? "");
      for (const node of quick) node.setAttribute("aria-pressed", String(layers.includes(node.getAttribute("data-layer") ?? "")));
      byId("panel-map").dataset.layers = layers.join(" ");
    },
  };
}

/** Drag and pinch. @param {import("./tab.js").MapTab} it @param {HTMLCanvasElement} canvas */
function startPointers({ act, session }, canvas) {
  /** @type {Map<number, { x: number, y: number }>} */
  const down = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    if (down.size >= 2) return;
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    // The second finger turns what the first one began into a pinch.
    act((s) => s.pointer(down.size === 1 ? "down" : "cancel", event.offsetX, event.offsetY));
    canvas.classList.add("grabbed");
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const at = { x: event.offsetX, y: event.offsetY };
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      const far = (/** @type {{ x: number, y: number }} */ spot) => Math.max(1, Math.hypot(spot.x - other.x, spot.y - other.y));
      session.pan((at.x - before.x) / 2, (at.y - before.y) / 2);
      session.zoom((at.x + other.x) / 2, (at.y + other.y) / 2, far(at) / far(before));
    } else act((s) => s.pointer("move", at.x, at.y));
    down.set(event.pointerId, at);
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) {
    canvas.addEventListener(kind, (event) => {
      if (!down.delete(event.pointerId)) return;
      act((s) => s.pointer(kind === "pointerup" ? "up" : "cancel", event.offsetX, event.offsetY));
      canvas.classList.toggle("grabbed", down.size > 0);
    });
  }
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
}
