// @ts-check
// Lamps, the Clean light, digits and the lights of the schedule; and the robot's own buttons.
import { byId, make, setEnabled } from "../dom.js";
import { ask } from "./dialogs.js";
import { face } from "./hand.js";
import { group, slider, toggles, wishes } from "./switches.js";

/** Bits of opcode 139. @type {[bit: number, name: string][]} */
const LAMPS = [[1, "Dirt"], [2, "Spot"], [4, "Dock"], [8, "Check robot"]];
/** Bits of opcode 162. @type {[bit: number, name: string][]} */
const WEEKDAYS = [[1, "Sun"], [2, "Mon"], [4, "Tue"], [8, "Wed"], [16, "Thu"], [32, "Fri"], [64, "Sat"]];
/** @type {[bit: number, name: string][]} */
const SCHEDULE = [[16, "Schedule"], [8, "Clock"], [4, "AM"], [2, "PM"], [1, "Colon"]];
/** @type {[button: "clean" | "spot" | "dock" | "max" | "power", name: string, what: string][]} */
const BUTTONS = [
  ["clean", "Clean", "The robot starts its own cleaning program, and this page loses control. Stop takes it back."],
  ["spot", "Spot", "The robot cleans a spot of about one metre, and this page loses control. Stop takes it back."],
  ["max", "Max", "The robot cleans until its battery is empty, and this page loses control. Stop takes it back."],
  ["dock", "Dock", "The robot drives to its home base, and this page loses control. Stop takes it back."],
  ["power", "Power", "It goes to sleep. Only its Clean button, or a cable with a wake-up wire, wakes it."],
];

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: import("./types").ConnectionView) => void} */
export function startLights(it) {
  const { svg, show } = face();
  const lights = wishes(it, { lamps: 0, clean_light: /** @type {[number, number]} */ ([0, 0]), digits: "    ", weekdays: 0, schedule: 0 });
  const light = (/** @type {Partial<typeof lights.now>} */ wish) => {
    const { lamps, clean_light: [colour, intensity] } = lights.wish(wish);
    void lights.ask({ do: "leds", lamps, colour, intensity });
  };
  const mark = (/** @type {Partial<typeof lights.now>} */ wish) => {
    const { weekdays, schedule } = lights.wish(wish);
    void lights.ask({ do: "schedule_leds", weekdays, lamps: schedule });
  };
  const lamps = toggles(LAMPS, (bit) => light({ lamps: lights.now.lamps ^ bit }));
  const weekdays = toggles(WEEKDAYS, (bit) => mark({ weekdays: lights.now.weekdays ^ bit }));
  const schedule = toggles(SCHEDULE, (bit) => mark({ schedule: lights.now.schedule ^ bit }));
  const colour = slider("Clean light: green to red", 0, 255, (value) => light({ clean_light: [value, lights.now.clean_light[1]] }));
  const brightness = slider("Brightness", 0, 255, (value) => light({ clean_light: [lights.now.clean_light[0], value] }));
  const digits = make("input", { type: "text", maxLength: 4, size: 4, placeholder: "HOLA", autocomplete: "off", spellcheck: false });
  const form = make("form", { className: "field" }, make("label", { className: "field" }, make("span", { className: "label" }, "Digits"), digits), make("button", { type: "submit" }, "Show"));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    void lights.ask({ do: "digits", text: digits.value.replace(/[^ -~]/g, "?") });
  });
  const buttons = BUTTONS.map(([id, name, what]) => {
    const node = make("button", { type: "button" }, name);
    node.addEventListener("click", async () => {
      if (it.view.can.press && (await ask({ title: `Press ${name}?`, points: [what], yes: `Press ${name}`, isWarning: true }))) await it.request({ do: "press", button: id });
    });
    return node;
  });
  byId("connection-lights").append(
    make("div", { className: "connection-sets" },
      group("Lights", make("div", { className: "connection-lamps" }, svg, lamps.node, colour.field, brightness.field), form),
      group("Schedule lights", make("p", { className: "note" }, "Models without a schedule may lack these."), weekdays.node, schedule.node),
      group("Robot buttons", make("p", { className: "note" }, "They return control to the robot's own program."), make("div", { className: "connection-hand" }, ...buttons)),
    ),
  );

  return ({ can, lights: lit }) => {
    const now = lights.take(lit);
    show(now);
    lamps.show(now.lamps, can.drive);
    weekdays.show(now.weekdays, can.drive);
    schedule.show(now.schedule, can.drive);
    colour.show(now.clean_light[0], can.drive);
    brightness.show(now.clean_light[1], can.drive);
    for (const node of form.querySelectorAll("button")) setEnabled(node, can.drive);
    for (const node of buttons) setEnabled(node, can.press);
  };
}
