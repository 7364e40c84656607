// @ts-check
// The forms: what cleans which room, made from the catalogue.
import { button, byId, changed, fill, input, make, select, setHidden, setText, typed } from "../dom.js";
import { explain } from "../explainer.js";
import { ODOMETRIES, ODOMETRY_TIP } from "../odometry.js";
import { complain } from "../messages.js";
import { paramField } from "../params.js";

/**
 * @typedef {import("../types").PageView} View
 * @typedef {import("../types").CatalogueEntry} AlgorithmEntry
 * @typedef {import("../main.js").App} App
 * @typedef {(control: HTMLElement, value: string) => void} Show
 */

/** Parameters beyond these fold away. */
const FEW = 2;
/** Entries of the menu of cells, percent: cells are chosen for so much coverage. */
const COVERAGES = [95, 98, 99];
/** Menu entries that aren't in the catalogue: a twin, an own robot, a path from the tab Floor plan. */
const [TWIN, OWN, PATH] = ["twin", "own", "path"];

/** @param {App} app @returns {(view: View) => void} */
export function startPanel(app) {
  const { catalogue, act } = app;
  const { rooms, planners, behaviours, robots, sensors, cell_sizes_m } = catalogue;
  const algorithms = [...planners, ...behaviours];
  fill(select("room"), rooms.map(({ id, title }) => [id, title]));
  select("algorithm").replaceChildren(group("Path planners", planners), group("Reactive behaviours", behaviours));
  fill(select("odometry"), ODOMETRIES);
  byId("odometry-field").setAttribute("data-tip", ODOMETRY_TIP);
  fill(select("robot"), [...robots.map(({ id, title }) => /** @type {[string, string]} */ ([id, title])), [OWN, "Own robot…"]]);
  const cells = select("cell-size");
  fill(cells, [...cell_sizes_m, ...COVERAGES].map((size) => [String(size), size < 2 ? `${+(size * 100).toFixed(2)} cm` : `for ${size} %`]));

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
  // Own rooms stand in the menu by their ids, behind a colon.
  bind("room", (p, id) => (id.startsWith(":") ? void openOwnRoom(app, id.slice(1)) : p.select_room(id)));
  bind("algorithm", (p, id) => p.select_algorithm(id));
  // From then on the keys drive, and don't go on in the menu.
  select("algorithm").addEventListener("change", ({ currentTarget }) => {
    if (behaviours.some(({ id, manual }) => manual && id === Reflect.get(currentTarget ?? {}, "value"))) byId("floor").focus();
  });
  const openOwn = () => {
    // The menu shows what holds until the robot is used.
    shown.clear();
    import("./own-robot.js").then(({ openOwnRobot }) => openOwnRobot(app)).catch(() => complain("The form could not be loaded. Check the connection, then try again."));
  };
  bind("robot", (p, id) => (id === OWN ? openOwn() : id === TWIN ? p.restore(`twin=${twin}`) : p.select_robot(id)));
  button("robot-edit").addEventListener("click", openOwn);
  bind("cell-size", (p, text) => {
    const size = Number(text);
    if (size < 2) return p.set_cell_size(size);
    void import("./fit-cells.js").then(({ fitCells }) => fitCells(app, size)).finally(() => shown.delete(cells));
  });
  bind("slip", (p, id) => p.set_slip(id));
  bind("noise", (p, level) => p.set_noise("all", level));
  input("quantised").addEventListener("change", () => change((p) => p.set_quantised(input("quantised").checked)));
  bind("start-charge", (p, percent) => p.set_start_charge(percent));
  const noises = sensors.map(([sensor, title]) => noiseMenu(title, (level) => change((p) => p.set_noise(sensor, level))));
  byId("noises").replaceChildren(...noises.map(({ field }) => field));
  bind("odometry", (p, id) => p.set_odometry(id));
  input("smooth").addEventListener("change", () => change((p) => p.set_smooth(input("smooth").checked)));
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

  /** Figures of the twin that was the robot last; "" if none was. */
  let twin = "";
  /** @param {View} view */
  const showRobot = (view) => {
    if (view.twin && !twin) select("robot").append(new Option("Twin of your Roomba", TWIN));
    twin = view.twin || twin;
    show(select("robot"), view.own_robot ? OWN : view.twin ? TWIN : view.robot);
    setHidden(button("robot-edit"), !view.own_robot);
    const model = robots.find(({ id }) => id === view.robot);
    const note = view.own_robot ? `Your shape, tool, speeds and sensors; the rest as ${model?.title}` : view.twin ? "Your robot, as fitted to a recording in the tab Robot" : model?.summary;
    setText(byId("robot-note"), note ?? "");
  };

  /** @param {View} view */
  const showAlgorithm = ({ algorithm, path_corners, program }) => {
    const menu = select("algorithm");
    if (program && changed(menu, "program", `${algorithm} ${program.name}`)) {
      menu.querySelector("option[value^=program]")?.remove();
      menu.prepend(new Option(`Your program: ${program.name}`, algorithm));
      shown.delete(menu);
    }
    if (changed(menu, "path", path_corners > 0)) {
      menu.querySelector(`option[value=${PATH}]`)?.remove();
      if (path_corners) menu.prepend(new Option("Path from Floor plan", PATH));
      shown.delete(menu);
    }
    show(menu, path_corners ? PATH : algorithm);
  };

  /** @type {Map<string, HTMLElement[]>} */
  let paramControls = new Map();

  /** @param {AlgorithmEntry} algorithm */
  const buildParams = (algorithm) => {
    paramControls = new Map();
    const fields = algorithm.params.map((spec) => {
      const { field, controls } = paramField(spec, (text) => change((p) => p.set_param(spec.id, text)));
      paramControls.set(spec.id, controls);
      return field;
    });
    byId("params").replaceChildren(...fields.slice(0, FEW));
    byId("params-more").replaceChildren(...fields.slice(FEW));
  };

  /** @param {string} name */
  const tellProgram = (name) => {
    paramControls = new Map();
    for (const id of ["params", "params-more"]) byId(id).replaceChildren();
    setText(byId("algorithm-kind"), "your program");
    setText(byId("algorithm-note"), "");
    setText(byId("explainer-title"), name);
    byId("explainer-text").dataset.about = "program";
    byId("explainer-text").replaceChildren(make("p", {}, "A program of your own. Read and change it in the tab Program."));
  };

  /** Of the algorithm. */
  let title = "";
  return (view) => {
    const { room } = view;
    showRoom(room, rooms);
    show(select("room"), room.id);
    showAlgorithm(view);
    showRobot(view);
    setText(byId("now"), `${title}, ${select("robot").selectedOptions[0]?.textContent ?? ""}`);
    show(cells, String(view.cell_size_m));
    showRealism(view, show);
    noises.forEach(({ menu }, index) => show(menu, view.noise[index] ?? "off"));
    show(select("odometry"), view.odometry);
    show(input("smooth"), String(view.smooth && view.can_smooth));
    input("smooth").disabled = !view.can_smooth;
    setHidden(byId("smooth-refusal"), view.can_smooth);
    show(input("seed"), String(view.seed));
    const { offered, on, refusal } = view.search;
    show(input("show-search"), String(on));
    setHidden(byId("search-field"), !offered);
    setHidden(byId("search-refusal"), !refusal);
    setText(byId("search-refusal"), refusal);
    input("show-search").disabled = refusal !== "";
    warnOfCells(view, robots);
    const algorithm = algorithms.find(({ id }) => id === view.algorithm);
    if (algorithm && changed(byId("params"), "algorithm", `${algorithm.id} ${view.path_corners}`)) {
      buildParams(view.path_corners ? { ...algorithm, params: [] } : algorithm);
      title = view.path_corners ? "Planned path" : algorithm.title;
      setText(byId("algorithm-kind"), view.path_corners ? "planned path" : algorithm.manual ? "you drive" : algorithm.kind === "planner" ? "path planner" : "reactive behaviour");
      setText(byId("algorithm-note"), view.path_corners ? `Planned in the tab Floor plan: ${view.path_corners.toLocaleString("en")} corners, driven as they are` : algorithm.summary);
      setText(byId("explainer-title"), algorithm.title);
      void explain(byId("explainer-text"), algorithm, rooms, (room) => change((p) => p.select_room(room)));
    }
    if (view.program && changed(byId("params"), "algorithm", `${view.algorithm} ${view.program.name}`)) tellProgram((title = view.program.name));
    for (const [id, controls] of paramControls) {
      const value = view.params[id];
      if (value !== undefined) for (const control of controls) show(control, String(value));
    }
  };
}

/** @param {App} app @param {string} id */
async function openOwnRoom(app, id) {
  const { openRoom } = await import("./own-rooms.js");
  await openRoom(app, id);
}

/** @param {string} label @param {AlgorithmEntry[]} entries */
function group(label, entries) {
  return make("optgroup", { label }, ...entries.map(({ id, title }) => make("option", { value: id }, title)));
}

/** The field for the noise of one kind of sensor. @param {string} title @param {(level: string) => void} tell */
function noiseMenu(title, tell) {
  const menu = make("select", { onchange: () => tell(menu.value) });
  fill(menu, ["off", "typical", "harsh"].map((level) => [level, level]));
  return { menu, field: make("label", { className: "field inline" }, make("span", { className: "label" }, title), menu) };
}

/** @param {View} view @param {Show} show */
function showRealism({ slip, noise, quantised, start_charge_percent: charge }, show) {
  const level = noise.every((one) => one === noise[0]) ? (noise[0] ?? "off") : "mixed";
  show(select("slip"), slip);
  show(select("noise"), level);
  show(input("quantised"), String(quantised));
  show(input("start-charge"), String(charge));
  const on = [slip !== "none" && "slip", level !== "off" && "noise", quantised && "rounded speeds", charge < 100 && `${charge} % charge`].filter(Boolean);
  setText(byId("realism-note"), on.join(", ") || "ideal");
}

/** Cells wider than the tool leave strips between lanes unswept. @param {View} view @param {import("../types").RobotEntry[]} robots */
function warnOfCells(view, robots) {
  // The textbook's robot is as wide as its cell.
  const tool = view.robot === "cell" || view.own_robot || view.path_corners ? Infinity : (robots.find(({ id }) => id === view.robot)?.tool_width_m ?? Infinity);
  const wide = view.cell_size_m > tool + 1e-9;
  setHidden(byId("cell-note"), !wide);
  if (wide) setText(byId("cell-note"), `Wider than the tool (${+(tool * 100).toFixed(1)} cm): strips between the lanes stay dirty.`);
}

/** @param {string} text */
function seed(text) {
  const value = Number(text);
  if (text.trim() === "" || !Number.isInteger(value) || value < 0 || value > 0xffffffff) {
    throw `The seed can't be "${text}"; use a whole number from 0 to 4294967295.`;
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
    menu.prepend(make("option", { value: room.id, "data-own": "" }, room.title || "Your room"));
    menu.value = room.id;
  } else if (!isOwn) own?.remove();
  const size = `${room.width_m.toFixed(1)} × ${room.height_m.toFixed(1)} m, ${room.reachable_m2.toFixed(1)} m² reachable${room.left_out_m2 >= 0.05 ? `, ${room.left_out_m2.toFixed(1)} m² not (hatched)` : ""}.`;
  setText(byId("room-note"), room.note ? `${room.note.replace(/\.?$/, ".")} ${size}` : size);
}
