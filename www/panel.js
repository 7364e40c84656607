// @ts-check
// The forms: what cleans which room, made from the catalogue.
import { button, byId, changed, fill, input, make, select, setHidden, setText, typed } from "./dom.js";

/**
 * @typedef {import("./types").View} View
 * @typedef {import("./types").ParamSpec} ParamSpec
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
  bind("planner", (p, id) => p.select_planner(id));
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
    show(select("planner"), view.planner);
    show(select("robot"), view.robot);
    show(select("cell-size"), String(view.cell_size_m));
    show(select("slip"), view.slip);
    show(select("odometry"), view.odometry);
    show(input("seed"), String(view.seed));
    show(input("show-search"), String(view.search.on));
    setHidden(byId("search-field"), !view.search.offered);
    setText(byId("robot-note"), robots.find(({ id }) => id === view.robot)?.summary ?? "");
    const planner = planners.find(({ id }) => id === view.planner);
    if (planner && changed(byId("params"), "planner", planner.id)) {
      buildParams(planner);
      explain(planner);
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
  const size = `${room.width_m.toFixed(1)} × ${room.height_m.toFixed(1)} m, ${room.reachable_m2.toFixed(1)} m² within reach.`;
  setText(byId("room-note"), room.note ? `${room.note.replace(/\.?$/, ".")} ${size}` : size);
}

/** @param {PlannerEntry} planner */
function explain(planner) {
  setText(byId("planner-note"), planner.summary);
  setText(byId("explainer-title"), planner.title);
  setText(byId("explainer-text"), planner.summary);
  setText(byId("explainer-source"), planner.source);
  const link = typed("explainer-link", HTMLAnchorElement);
  setHidden(link, !planner.link);
  if (planner.link) link.href = planner.link;
  /** @type {[boolean, string, string, string, string][]} */
  const claims = [
    [planner.complete, "visits every cell", "may miss cells", "Visits every cell of the planning grid that can be reached; tests hold it to that in every room. Coverage may still stay a little below 100 %: cells are coarser than the floor, and slivers along walls remain.", "Gives no promise to visit every cell that can be reached."],
    [planner.deterministic, "same plan every time", "uses chance", "Gives the same plan whatever the seed.", "Draws random numbers; another seed gives another plan."],
  ];
  byId("claims").replaceChildren(
    ...claims.map(([holds, yes, no, tipYes, tipNo]) =>
      make("li", { "data-tip": holds ? tipYes : tipNo, className: holds ? "yes" : "no" }, make("button", { type: "button", className: "term" }, holds ? yes : no)),
    ),
  );
}

/**
 * The field of one parameter, which tells its value as text, and the controls that show it.
 * @param {ParamSpec} spec
 * @param {(text: string) => void} tell
 * @returns {{ field: HTMLElement, controls: HTMLElement[] }}
 */
function paramField(spec, tell) {
  const label = make("span", { className: "label" }, spec.label);
  if (spec.kind === "flag") {
    const box = make("input", { type: "checkbox", onchange: () => tell(String(box.checked)) });
    return { field: make("label", { className: "field check", "data-tip": spec.help }, box, label), controls: [box] };
  }
  if (spec.kind === "choice") {
    const menu = make("select", { onchange: () => tell(menu.value) });
    fill(menu, spec.options ?? []);
    return { field: make("label", { className: "field inline", "data-tip": spec.help }, label, menu), controls: [menu] };
  }
  const limits = { min: String(spec.min ?? 0), max: String(spec.max ?? 1), step: String(spec.step ?? "any") };
  const id = `param-${spec.id}`;
  const box = make("input", { type: "number", id, ...limits, onchange: () => tell(box.value) });
  // The box says the same to those who can't see or drag the slider.
  const slider = make("input", {
    type: "range",
    ...limits,
    tabIndex: -1,
    "aria-hidden": "true",
    oninput: () => (box.value = slider.value),
    onchange: () => tell(slider.value),
  });
  const name = make("label", { className: "label", for: id }, spec.label);
  const head = make("span", { className: "param-head" }, name, make("span", { className: "with-unit" }, box, spec.unit ?? ""));
  return { field: make("div", { className: "field number", "data-tip": spec.help }, head, slider), controls: [box, slider] };
}
