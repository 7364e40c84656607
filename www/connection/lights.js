// @ts-check
// Lamps, the Clean light, digits, brushes and vacuum; and the robot's own buttons.
import { byId, make, setAttribute, setEnabled } from "../dom.js";
import { ask } from "./dialogs.js";
import { face } from "./hand.js";

/** Bits of opcode 139. @type {[bit: number, name: string][]} */
const LAMPS = [[1, "Dirt"], [2, "Spot"], [4, "Dock"], [8, "Check robot"]];
/** Bits of opcode 138. @type {[bit: number, name: string, tip: string][]} */
const MOTORS = [[1, "Side brush", "Sweeps dirt from the edge."], [2, "Vacuum", "Loud."], [4, "Main brush", "Keep fingers and hair away."], [8, "Side brush clockwise", "Counter-clockwise otherwise."], [16, "Main brush outward", "Throws dirt out instead of picking it up."]];
/** @type {[button: "clean" | "spot" | "dock" | "power", name: string, what: string][]} */
const BUTTONS = [
  ["clean", "Clean", "The robot starts its own cleaning program, and this page loses control. Stop takes it back."],
  ["spot", "Spot", "The robot cleans a spot of about one metre, and this page loses control. Stop takes it back."],
  ["dock", "Dock", "The robot drives to its home base, and this page loses control. Stop takes it back."],
  ["power", "Power", "It goes to sleep. Only its Clean button, or a cable with a wake-up wire, wakes it."],
];

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: import("./types").ConnectionView) => void} */
export function startLights(it) {
  const { svg, show } = face();
  const state = { lamps: 0, clean_light: /** @type {[number, number]} */ ([0, 128]), digits: "" };
  const light = () => {
    show(state);
    void it.request({ do: "leds", lamps: state.lamps, colour: state.clean_light[0], intensity: state.clean_light[1] });
  };
  /** @param {string} name @param {string} tip @param {() => void} act */
  const toggle = (name, tip, act) => {
    const node = make("button", { type: "button", className: "toggle", "aria-pressed": "false", ...(tip ? { "data-tip": tip } : {}) }, name);
    node.addEventListener("click", () => {
      if (node.getAttribute("aria-disabled") === "true") return;
      setAttribute(node, "aria-pressed", String(node.getAttribute("aria-pressed") !== "true"));
      act();
    });
    return node;
  };
  const lamps = LAMPS.map(([bit, name]) => toggle(name, "", () => {
    state.lamps ^= bit;
    light();
  }));
  const range = (/** @type {string} */ label, /** @type {0 | 1} */ which) => {
    const node = make("input", { type: "range", min: "0", max: "255", value: String(state.clean_light[which]) });
    node.addEventListener("change", () => {
      state.clean_light[which] = Number(node.value);
      light();
    });
    return make("label", { className: "field" }, make("span", { className: "label" }, label), node);
  };
  const digits = make("input", { type: "text", maxLength: 4, size: 4, placeholder: "HOLA", autocomplete: "off", spellcheck: false });
  const form = make("form", { className: "field" }, make("label", { className: "field" }, make("span", { className: "label" }, "Digits"), digits), make("button", { type: "submit" }, "Show"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    state.digits = digits.value.replace(/[^ -~]/g, "?");
    show(state);
    void it.request({ do: "digits", text: state.digits });
  });
  let bits = 0;
  const motors = MOTORS.map(([bit, name, tip]) => toggle(name, tip, () => {
    bits ^= bit;
    void it.request({ do: "motors", bits });
  }));
  const buttons = BUTTONS.map(([id, name, what]) => {
    const node = make("button", { type: "button" }, name);
    node.addEventListener("click", async () => {
      if (it.view.can.press && (await ask({ title: `Press ${name}?`, points: [what], yes: `Press ${name}`, isWarning: true }))) await it.request({ do: "press", button: id });
    });
    return node;
  });
  const group = (/** @type {string} */ title, /** @type {Node[]} */ ...nodes) => make("fieldset", { className: "connection-set" }, make("legend", {}, title), ...nodes);
  byId("connection-lights").append(
    make("div", { className: "connection-sets" },
      group("Lights", make("div", { className: "connection-lamps" }, svg, make("div", { className: "connection-hand" }, ...lamps), range("Clean light: green to red", 0), range("Brightness", 1)), form),
      group("Brushes and vacuum", make("div", { className: "connection-hand" }, ...motors)),
      group("Robot buttons", make("p", { className: "note" }, "They return control to the robot's own program."), make("div", { className: "connection-hand" }, ...buttons)),
    ),
  );
  show(state);

  return ({ can, mode }) => {
    for (const node of [...lamps, ...motors, ...form.querySelectorAll("button")]) setEnabled(node, can.drive);
    for (const node of buttons) setEnabled(node, can.press);
    // Passive switches motors off, and the robot has its lights for itself.
    if (mode === "Passive" && bits !== 0) {
      bits = 0;
      for (const node of motors) setAttribute(node, "aria-pressed", "false");
    }
  };
}
