// @ts-check
// The dialog in which one builds a robot: shape, tool, speeds and sensors, on the figures of a model.
import init, { own_robot_corners, own_robot_form, own_robot_text } from "../../workshop.js";
import { fill, make, setHidden, setText } from "../dom.js";
import { draw } from "../portrait.js";
import { style } from "../parts.js";
import { workshop } from "../workers.js";
import { SHAPES } from "./own-robot-shapes.js";

/** @typedef {import("../main.js").App} App @typedef {import("../types").OwnRobotForm} Form */

const SVG_SIZE = 64;
/** Where the last own robot is kept, for when another one was chosen in between. */
const KEY = "own-robot";

/** @type {((app: App) => void) | undefined} */
let made;

/** Opens the dialog with the present robot in it. @param {App} app */
export async function openOwnRobot(app) {
  const [module] = await Promise.all([workshop(), style(new URL("./own-robot.css", import.meta.url).href)]);
  await init({ module_or_path: module });
  (made ??= build(app))(app);
}

/** @param {App} app */
function build(app) {
  const models = app.catalogue.robots.filter(({ id }) => id !== "cell");
  /** @param {Record<string, unknown>} [properties] */
  const number = (properties) => make("input", { type: "number", step: "any", ...properties });
  /** @param {string} label @param {Node} control @param {string} [unit] */
  const field = (label, control, unit) => make("label", { className: "field inline" }, make("span", { className: "label" }, label), unit ? make("span", { className: "with-unit" }, control, unit) : control);

  const model = make("select", { id: "own-model" });
  fill(model, models.map(({ id, title }) => [id, title]));
  const shape = make("select", { id: "own-shape" });
  fill(shape, Object.entries(SHAPES).map(([id, { title }]) => [id, title]));
  const [first, second] = [number({ id: "own-first", min: "0" }), number({ id: "own-second", min: "0" })];
  const corners = make("input", { type: "text", id: "own-corners", autocomplete: "off", spellcheck: false });
  const cleans = make("select", { id: "own-cleans" });
  fill(cleans, [["strip", "With a tool"], ["body", "All under its body"]]);
  const [tool, ahead, aside] = [number({ id: "own-tool" }), number({ id: "own-ahead" }), number({ id: "own-aside" })];
  const wheels = make("select", { id: "own-wheels" });
  fill(wheels, [["differential", "Two wheels"], ["omnidirectional", "Any direction"]]);
  const [speed, turn] = [number({ id: "own-speed" }), number({ id: "own-turn" })];
  const sensors = make("div", { className: "own-sensors", role: "group", "aria-label": "Sensors" });

  const svg = draw("svg", { viewBox: `-${SVG_SIZE / 2} -${SVG_SIZE / 2} ${SVG_SIZE} ${SVG_SIZE}`, role: "img", "aria-label": "The robot from above, driving up" });
  const outline = draw("path", { class: "own-body" }, svg);
  const strip = draw("rect", { class: "own-tool", rx: "1.5", height: "5" }, svg);
  draw("path", { class: "own-ahead", d: "M0,-9L4,-2L-4,-2Z" }, svg);
  const fault = make("p", { className: "fault", role: "alert", hidden: true });
  const [fields1, fields2, fieldCorners] = [field("Width", first, "m"), field("Length", second, "m"), field("Corners: x y; x y; …", corners)];
  fieldCorners.dataset.tip = "x ahead and y to the left of the middle between the wheels, in metres; corners separated by semicolons.";
  const [fieldTool, fieldAhead, fieldAside] = [field("Tool width", tool, "m"), field("Tool ahead", ahead, "m"), field("Tool to the left", aside, "m")];
  const form = make(
    "form",
    { method: "dialog", noValidate: true },
    make("header", {}, make("h2", { id: "own-title" }, "Own robot")),
    make("div", { className: "own-look" }, svg, make("div", {}, field("Based on", model), field("Shape", shape), fields1, fields2, fieldCorners)),
    make("div", { className: "own-fields" }, field("Cleans", cleans), fieldTool, fieldAhead, fieldAside, field("Moves", wheels), field("Speed", speed, "m/s"), field("Turns at", turn, "°/s")),
    make("p", { className: "note" }, "Empty fields keep the model's values, as do battery, power and noise. Sensors sit at the edge of your shape. Only floor where the body has room to turn counts as reachable."),
    sensors,
    make("div", { className: "own-foot" }, fault, make("div", { className: "row" }, make("button", { type: "button", id: "own-cancel", onclick: () => dialog.close() }, "Cancel"), make("button", { type: "submit", className: "primary", id: "own-use" }, "Use this robot"))),
  );
  const dialog = make("dialog", { id: "own-robot", "aria-labelledby": "own-title" }, form);
  document.body.append(dialog);

  const chosen = () => models.find(({ id }) => id === model.value);
  const layout = () => (chosen()?.lateral ? "omnidirectional" : "differential");
  const values = () => /** @type {Form} */ ({
    shape: shape.value,
    first: first.value,
    second: second.value,
    corners: corners.value,
    cleans_all: cleans.value === "body",
    tool: tool.value,
    at: [ahead.value, aside.value],
    speed: speed.value,
    turn: turn.value,
    wheels: wheels.value === layout() ? null : wheels.value,
    without: [...sensors.querySelectorAll("input")].filter(({ checked }) => !checked).map(({ value }) => value),
  });
  /** @param {string} text */
  const complain = (text) => {
    setHidden(fault, text === "");
    // Rust's errors begin small, to stand behind others.
    setText(fault, text && `${text.charAt(0).toUpperCase()}${text.slice(1)}${/[.!?]$/.test(text) ? "" : "."}`);
  };

  const refresh = () => {
    const { figures } = SHAPES[values().shape];
    [fields1, fields2].forEach((node, index) => {
      setHidden(node, !figures[index]);
      setText(/** @type {Element} */ (node.firstElementChild), figures[index] ?? "");
    });
    setHidden(fieldCorners, shape.value !== "polygon");
    for (const node of [fieldTool, fieldAhead, fieldAside]) setHidden(node, cleans.value === "body");
    const base = chosen();
    if (base) {
      tool.placeholder = String(+base.tool_width_m.toFixed(3));
      [ahead.placeholder, aside.placeholder] = ["0", "0"];
      speed.placeholder = String(+base.speed_m_s.toFixed(3));
      turn.placeholder = String(Math.round(base.turn_deg_s));
    }
    paint();
  };
  // A new shape begins as large as the model.
  shape.addEventListener("input", () => {
    const unit = +(chosen()?.radius_m ?? 0.17).toFixed(3);
    for (const side of [first, second]) side.value ||= String(+(2 * unit).toFixed(3));
    corners.value ||= `${unit} -${unit}; ${unit} ${unit}; -${unit} ${unit}; -${unit} -${unit}`;
  });
  const paint = () => {
    const base = chosen();
    if (!base) return;
    const own = values();
    const unit = base.radius_m;
    // What isn't a number is told when the robot is to be used.
    const size = (/** @type {string} */ text) => (Number.isFinite(Number(text)) ? Number(text) : 0);
    const middle = own.at.map(size);
    const half = own.cleans_all ? 0 : (size(own.tool) || base.tool_width_m) / 2;
    /** @type {number[][] | undefined} */
    let points;
    try {
      points = own_robot_corners(own) ?? base.body.map(([x, y]) => [x * unit, y * unit]);
    } catch {
      // It is told when the robot is to be used.
    }
    const radius = own.shape === "circle" ? Math.max(0, size(own.first) / 2) : own.shape === "model" && base.body.length === 0 ? unit : 0;
    const reach = Math.max(0.1 * unit, radius, Math.hypot(...middle) + half, ...(points ?? []).map(([x = 0, y = 0]) => Math.hypot(x, y)));
    const scale = (0.45 * SVG_SIZE) / reach;
    const at = (/** @type {number[]} */ [x = 0, y = 0]) => `${(-y * scale).toFixed(2)},${(-x * scale).toFixed(2)}`;
    const r = (radius * scale).toFixed(2);
    outline.setAttribute("d", radius ? `M${r},0A${r},${r} 0 1 1 -${r},0A${r},${r} 0 1 1 ${r},0Z` : points?.length ? `M${points.map(at).join("L")}Z` : "");
    const [cx = "0", cy = "0"] = at(middle).split(",");
    // As a brush is: wide, and short along the way.
    const side = Math.max(0, half * scale);
    for (const [name, value] of Object.entries({ x: Number(cx) - side, y: Number(cy) - 2.5, width: 2 * side })) strip.setAttribute(name, String(value));
    outline.classList.toggle("cleans", own.cleans_all);
  };
  const listSensors = (/** @type {string[]} */ without) => {
    const base = chosen();
    /** @type {[string, string, boolean | undefined][]} */
    const kinds = [
      ["bumper", "Bumper", base && base.bumper > 0],
      ["cliffs", "Cliff sensors", base?.cliffs.some(Boolean)],
      ["light", "Light bumper", base && base.light.length > 0],
      ["infrared", "Infrared", base?.infrared],
      ["wheel_drops", "Wheel drops", base?.wheel_drops],
      ["laser", "Laser scanner", base && base.laser.length > 0],
    ];
    const boxes = kinds.filter(([, , has]) => has).map(([id, title]) => make("label", { className: "field check" }, make("input", { type: "checkbox", value: id, checked: !without.includes(id) }), make("span", { className: "label" }, title)));
    sensors.replaceChildren(...boxes);
  };

  model.addEventListener("change", () => {
    listSensors(values().without);
    wheels.value = layout();
  });
  form.addEventListener("input", () => {
    complain("");
    refresh();
  });
  form.addEventListener("submit", (event) => {
    try {
      const text = own_robot_text(values());
      app.playground.restore(`robot=${model.value}&own=${text}`);
      localStorage.setItem(KEY, `${model.value} ${text}`);
    } catch (error) {
      // The dialog stays as it is, so that nothing is lost; a private window just doesn't keep the robot.
      if (error instanceof DOMException) return;
      event.preventDefault();
      complain(String(error));
    }
  });

  return (/** @type {App} */ { view }) => {
    const [id = "", text = ""] = view.own_robot ? [view.robot, view.own_robot === "model" ? "" : view.own_robot] : kept(view.robot);
    model.value = models.some((one) => one.id === id) ? id : (models[0]?.id ?? "");
    const own = own_robot_form(text);
    [shape.value, first.value, second.value, corners.value] = [own.shape, own.first, own.second, own.corners];
    [cleans.value, tool.value, speed.value, turn.value] = [own.cleans_all ? "body" : "strip", own.tool, own.speed, own.turn];
    [ahead.value, aside.value] = own.at;
    wheels.value = own.wheels ?? layout();
    listSensors(own.without);
    complain("");
    refresh();
    dialog.showModal();
  };
}

/** The own robot that was used last, else the present model. @param {string} present @returns {string[]} */
function kept(present) {
  try {
    return localStorage.getItem(KEY)?.split(" ") ?? [present];
  } catch {
    return [present];
  }
}
