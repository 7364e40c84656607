// @ts-check
// The forms: what cleans which room, made from the catalogue.
import { button, byId, changed, fill, input, make, select, setHidden, setText, typed } from "./dom.js";
import { explainer } from "./explainer.js";
import { paramField } from "./params.js";

/**
 * @typedef {import("./types").View} View
 * @typedef {import("./types").PlannerEntry} PlannerEntry
 * @typedef {import("./main.js").App} App
 * @typedef {(control: HTMLElement, value: string) => void} Show
 */

/** Parameters beyond these fold away. */
const FEW = 2;

/** @param {App} app @returns {(view: View) => void} */
export function startPanel(app) {
  const { catalogue, act } = app;
  const { rooms, planners, robots, cell_sizes_m } = catalogue;
  fill(select("room"), rooms.map(({ id, title }) => [id, title]));
  fill(select("planner"), planners.map(({ id, title }) => [id, title]));
  fill(select("robot"), robots.map(({ id, title }) => [id, title]));
  fill(select("cell-size"), cell_sizes_m.map((size) => [String(size), `${+(size * 100).toFixed(2)} cm`]));

  /** @param {(p: App["playground"]) => void} what */
  const change = (what) => {
    // A refused value goes back to what holds.
    if (!act(what)) shown.clear();
  };
  /** @type {Map<HTMLElement, string>} */
  const shown = new Map();

  /** @param {string} id @param {(p: App["playground"], value: string) => void} set */
  const bind = (id, set) => {
    const control = byId(id);
    control.addEventListener("change", () => change((p) => set(p, Reflect.get(control, "value"))));
  };
  bind("room", (p, id) => p.select_room(id));
  bind("planner", (p, id) => p.select_algorithm(id));
  bind("robot", (p, id) => p.select_robot(id));
  bind("cell-size", (p, metres) => p.set_cell_size(Number(metres)));
  bind("slip", (p, id) => p.set_slip(id));
  bind("odometry", (p, id) => p.set_odometry(id));
  bind("seed", (p, text) => p.set_seed(seed(text)));
  input("show-search").addEventListener("change", () => act((p) => p.show_search(input("show-search").checked)));
  button("reseed").addEventListener("click", () => change((p) => p.set_seed(Math.floor(Math.random() * 1e6))));
  typed("setup-fields", HTMLFieldSetElement).disabled = false;

  /** Shows a value where it differs from what was last shown: not while it is being edited. @type {Show} */
  const show = (control, value) => {
    if (shown.get(control) === value) return;
    shown.set(control, value);
    if (control instanceof HTMLInputElement && control.type === "checkbox") control.checked = value === "true";
    else Reflect.set(control, "value", value);
  };

  /** @type {Map<string, HTMLElement[]>} */
  let paramControls = new Map();

  /** @param {PlannerEntry} planner */
  const buildParams = (planner) => {
    paramControls = new Map();
    const fields = planner.params.map((spec) => {
      const { field, controls } = paramField(spec, (text) => change((p) => p.set_param(spec.id, text)));
      paramControls.set(spec.id, controls);
      return field;
    });
    byId("params").replaceChildren(...fields.slice(0, FEW));
    byId("params-more").replaceChildren(...fields.slice(FEW));
  };

  return (view) => {
    const { room } = view;
    showRoom(room, rooms);
    show(select("room"), room.id);
    show(select("planner"), view.algorithm);
    show(select("robot"), view.robot);
    show(select("cell-size"), String(view.cell_size_m));
    show(select("slip"), view.slip);
    show(select("odometry"), view.odometry);
    show(input("seed"), String(view.seed));
    show(input("show-search"), String(view.search.on));
    setHidden(byId("search-field"), !view.search.offered);
    setText(byId("robot-note"), robots.find(({ id }) => id === view.robot)?.summary ?? "");
    const planner = planners.find(({ id }) => id === view.algorithm);
    if (planner && changed(byId("params"), "planner", planner.id)) {
      buildParams(planner);
      setText(byId("planner-note"), planner.summary);
      setText(byId("explainer-title"), planner.title);
      byId("explainer-text").replaceChildren(...explainer(planner, rooms, (room) => change((p) => p.select_room(room))));
    }
    for (const [id, controls] of paramControls) {
      const value = view.params[id];
      if (value !== undefined) for (const control of controls) show(control, String(value));
    }
  };
}

/** @param {string} text */
function seed(text) {
  const value = Number(text);
  if (text.trim() === "" || !Number.isInteger(value) || value < 0 || value > 0xffffffff) {
    throw `The seed can't be "${text}"; it is a whole number from 0 to 4294967295.`;
  }
  return value;
}

/** @param {View["room"]} room @param {{ id: string }[]} shipped */
function showRoom(room, shipped) {
  const menu = select("room");
  const own = menu.querySelector("option[data-own]");
  const isOwn = !shipped.some(({ id }) => id === room.id);
  if (isOwn && own?.textContent !== room.title) {
    own?.remove();
    menu.prepend(make("option", { value: room.id, "data-own": "" }, room.title || "Own room"));
    menu.value = room.id;
  } else if (!isOwn) own?.remove();
  const size = `${room.width_m.toFixed(1)} × ${room.height_m.toFixed(1)} m, ${room.reachable_m2.toFixed(1)} m² within reach${room.left_out_m2 >= 0.05 ? `, ${room.left_out_m2.toFixed(1)} m² not (hatched)` : ""}.`;
  setText(byId("room-note"), room.note ? `${room.note.replace(/\.?$/, ".")} ${size}` : size);
}
