// @ts-check
// The map's canvas: hands, keys and layers. What the pointer does is decided in Rust.
import { button, byId, changed, setAttribute, setEnabled, setText } from "../dom.js";
import { fitSize, startHands, startZoom } from "../shared/pan-zoom.js";

/** @type {Record<string, string>} */
const MOVES = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Enter: "apply", Escape: "back" };
/** With the shift key. @type {Record<string, string>} */
const TURNS = { ArrowLeft: "turn_left", ArrowRight: "turn_right" };

/** @param {import("./tab.js").MapTab} it @param {HTMLCanvasElement} canvas */
export function startCanvas(it, canvas) {
  const { session, act } = it;
  startHands(canvas, session, { pointer: (kind, x, y) => void act((s) => s.pointer(kind, x, y)), key: () => it.view.is_carried });
  // Before all others: while carrying the robot, arrow keys move it.
  document.addEventListener("keydown", (event) => {
    if (!it.view.is_carried || byId("panel-map").hidden || event.ctrlKey || event.metaKey || event.altKey) return;
    const isHere = event.target === canvas || event.key === "Escape";
    const action = isHere && (event.shiftKey ? TURNS : MOVES)[event.key];
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    act((s) => s.carry(action));
  }, { capture: true });

  const zoom = startZoom(byId("map-stage"), session);
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
    p: lift,
    l: layers.open,
    t: () => it.toggle("truth"),
    d: () => it.toggle("difference"),
    o: () => it.toggle("odometry"),
  };
  return {
    resized: () => fitSize(canvas, session),
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
      return Boolean(what) || zoom(key);
    },
  };
}

/** The layers: the buttons over the map, and the whole list. @param {import("./tab.js").MapTab} it */
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
