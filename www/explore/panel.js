// @ts-check
// The forms: what cleans which room, made from the catalogue.
import { button, byId, fill, input, make, select, setHidden, setText, typed } from "../dom.js";
import { metres } from "../format.js";
import { ODOMETRIES, ODOMETRY_TIP } from "../odometry.js";
import { complain, textOf } from "../messages.js";
import { startAlgorithm } from "./algorithm.js";
import { startForm } from "./form.js";
import { startRealism } from "./realism.js";
import { dismissSheet } from "../sheets.js";

/**
 * @typedef {import("../types").PageView} View
 * @typedef {import("../main.js").App} App
 */

/** Entries of the menu of cells, percent: cells are chosen for so much coverage. */
const COVERAGES = [95, 98, 99];
/** Menu entries that aren't in the catalogue: a twin, an own robot, a generated flat. */
const [TWIN, OWN, FLAT] = ["twin", "own", "new-flat"];

/** @param {number} metres */
export const inCentimetres = (metres) => `${+(metres * 100).toFixed(2)} cm`;

/** What a choice of cells depends on: the note beside them holds as long as this stays. @param {import("../main.js").App["playground"]} p @param {View} view */
export const cellsOf = (p, { algorithm, params, robot, own_robot, twin, cell_size_m, cell_offset_m, seed, smooth }) => JSON.stringify([p.room_version(), algorithm, params, robot, own_robot, twin, cell_size_m, cell_offset_m, seed, smooth]);

/** @param {App} app @returns {(view: View) => void} */
export function startPanel(app) {
  const { rooms, robots, cell_sizes_m } = app.catalogue;
  const form = startForm(app);
  const { bind, bindBox, change, show } = form;
  fill(select("room"), [...rooms.map(({ id, title }) => /** @type {[string, string]} */ ([id, title])), [FLAT, "A new flat"]]);
  fill(select("odometry"), ODOMETRIES);
  byId("odometry-field").setAttribute("data-tip", ODOMETRY_TIP);
  fill(select("robot"), [...robots.map(({ id, title }) => /** @type {[string, string]} */ ([id, title])), [OWN, "Own robot"]]);
  const cells = select("cell-size");
  fill(cells, [...cell_sizes_m, ...COVERAGES].map((size) => [String(size), size < 2 ? inCentimetres(size) : `for ${size} %`]));
  /** Own robots, links and choices for a coverage bring other sizes. @param {number} size @param {boolean} isMoved */
  const showCells = (size, isMoved) => {
    const plain = String(size);
    // Cells that don't begin in the corner have an entry beside the one that puts them back.
    const value = isMoved ? `${plain} moved` : plain;
    for (const option of cells.querySelectorAll("option")) if (option.value.endsWith(" moved") && option.value !== value) option.remove();
    const has = (/** @type {string} */ wanted) => [...cells.options].some((option) => option.value === wanted);
    if (!has(plain)) cells.append(new Option(inCentimetres(size), plain));
    if (!has(value)) cells.append(new Option(`${inCentimetres(size)}, moved`, value));
    show(cells, value);
  };

  // Own rooms stand in the menu by their ids, behind a colon.
  bind("room", (p, id) => (id === FLAT ? newFlat() : id.startsWith(":") ? void openOwnRoom(app, id.slice(1)) : p.select_room(id)));
  const newFlat = () =>
    void import("./flat.js")
      .then(({ anotherFlat }) => anotherFlat(app))
      .catch((error) => complain(textOf(error)))
      .finally(() => form.refresh(select("room")));
  const openOwn = () => {
    // The menu shows what holds until the robot is used.
    form.refresh();
    import("./own-robot.js").then(({ openOwnRobot }) => openOwnRobot(app)).catch(() => complain("The form could not be loaded. Check the connection, then try again."));
  };
  bind("robot", (p, id) => (id === OWN ? openOwn() : id === TWIN ? p.restore(`twin=${twin}`) : p.select_robot(id)));
  button("robot-edit").addEventListener("click", openOwn);
  bind("cell-size", (p, text) => {
    const size = Number(text);
    if (size < 2) return p.set_cell_size(size);
    void import("./fit-cells.js").then(({ fitCells }) => fitCells(app, size)).finally(() => form.refresh(cells));
  });
  bind("odometry", (p, id) => p.set_odometry(id));
  bindBox("smooth", (p, on) => p.set_smooth(on));
  bind("seed", (p, text) => p.set_seed(seed(text)));
  bindBox("show-search", (p, on) => {
    p.show_search(on);
    if (on) dismissSheet("setup");
  });
  button("reseed").addEventListener("click", () => change((p) => p.set_seed(Math.floor(Math.random() * 1e6))));
  const showAlgorithm = startAlgorithm(app, form);
  const showRealism = startRealism(app, form);
  typed("setup-fields", HTMLFieldSetElement).disabled = false;

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

  return (view) => {
    showRoom(view.room, rooms);
    show(select("room"), view.room.id);
    showRobot(view);
    const title = showAlgorithm(view);
    setText(byId("now"), `${title}, ${select("robot").selectedOptions[0]?.textContent ?? ""}`);
    showCells(view.cell_size_m, view.cell_offset_m.some((metres) => metres !== 0));
    warnOfCells(view, robots);
    const fit = byId("cell-fit");
    if (!fit.hidden) setHidden(fit, fit.dataset.of !== cellsOf(app.playground, view));
    showRealism(view);
    show(select("odometry"), view.odometry);
    show(input("smooth"), String(view.smooth && view.can_smooth));
    input("smooth").disabled = !view.can_smooth;
    setHidden(byId("smooth-refusal"), view.can_smooth);
    show(input("seed"), String(view.seed));
    const { offered, on, refusal, fits_small } = view.search;
    show(input("show-search"), String(on));
    setHidden(byId("search-field"), !offered);
    setHidden(byId("search-refusal"), !refusal);
    setText(byId("search-refusal"), refusal);
    setHidden(byId("search-small"), !fits_small);
    input("show-search").disabled = refusal !== "";
  };
}

/** @param {App} app @param {string} id */
async function openOwnRoom(app, id) {
  const { openRoom } = await import("./own-rooms.js");
  await openRoom(app, id, true);
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
  const [reached, not] = [room.reachable_m2, room.left_out_m2].map((area) => `${metres(area)}\u00a0m²`);
  const size = `${room.width_m.toFixed(1)} × ${room.height_m.toFixed(1)}\u00a0m, ${reached} reachable${room.left_out_m2 >= 0.05 ? `, ${not} not (hatched)` : ""}.`;
  setText(byId("room-note"), room.note ? `${room.note.replace(/\.?$/, ".")} ${size}` : size);
}
