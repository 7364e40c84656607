// @ts-check
// The virtual robot: its face with lights and digits, what a hand does to it, and its tunes.
import { byId, make, setAttribute, setHidden, setText } from "../dom.js";
import { draw } from "../portrait.js";
import { hush, isMuted, sound } from "./sound.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */

/** Buttons of packet 18: bit, name, place on the face. @type {[bit: number, name: string, x: number, y: number][]} */
const BUTTONS = [[1, "Clean", 80, 52], [2, "Spot", 45, 62], [4, "Dock", 115, 62]];
/** Lamps: bit, name, colour, place. @type {[bit: number, name: string, colour: string, x: number, y: number][]} */
const LAMPS = [[1, "Dirt", "#5aa2ff", 62, 15], [2, "Spot", "#4fd675", 45, 44], [4, "Dock", "#4fd675", 115, 44], [8, "Check", "#ff9a3c", 98, 15]];

/** Lights of the schedule, which are seen only while lit: bit, name, text, place. Weekdays are above the digits. @type {[bit: number, name: string, text: string, x: number, y: number][]} */
const WEEKDAYS = ["Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"].map((name, day) => [1 << day, name, name.charAt(0), 59 + 7 * day, 79]);
/** @type {typeof WEEKDAYS} */
const SCHEDULE = [[1, "colon", ":", 80, 95], [2, "PM", "PM", 113, 99], [4, "AM", "AM", 113, 90], [8, "clock", "CLK", 45, 99], [16, "schedule", "SCH", 45, 90]];

/** Colour of the Clean light. @param {number} colour 0 green to 255 red @param {number} intensity */
export const cleanColour = (colour, intensity) => `rgb(${Math.round(90 + 0.65 * colour)} ${Math.round(220 - 0.62 * colour)} 60 / ${intensity / 255})`;

/** The face of the robot. */
export function face() {
  const svg = draw("svg", { viewBox: "0 0 160 116", class: "connection-face", role: "img" });
  draw("circle", { cx: 80, cy: 58, r: 56, class: "shell" }, svg);
  const light = draw("circle", { cx: 80, cy: 52, r: 19, class: "light" }, svg);
  for (const [, name, x, y] of BUTTONS) {
    draw("circle", { cx: x, cy: y, r: name === "Clean" ? 15 : 9, class: "key" }, svg);
    draw("text", { x, y: y + (name === "Clean" ? 3 : 17), class: "word" }, svg).textContent = name.toUpperCase();
  }
  const lamps = LAMPS.map(([bit, name, colour, x, y]) => {
    const lamp = draw("circle", { cx: x, cy: y, r: 3.5, class: "lamp" }, svg);
    // Those of buttons have their names there.
    if (y < 20) draw("text", { x, y: y + 11, class: "word" }, svg).textContent = name;
    return { bit, name, colour, lamp };
  });
  draw("rect", { x: 55, y: 81, width: 50, height: 20, rx: 3, class: "glass" }, svg);
  const digits = draw("text", { x: 80, y: 96, class: "digits" }, svg);
  const small = (/** @type {typeof WEEKDAYS} */ list) => list.map(([bit, name, text, x, y]) => {
    const node = draw("text", { x, y, class: "small", visibility: "hidden" }, svg);
    node.textContent = text;
    return { bit, name, node };
  });
  const [days, marks] = [small(WEEKDAYS), small(SCHEDULE)];
  return {
    svg,
    /** @param {{ lamps: number, clean_light: [number, number], digits: string, weekdays: number, schedule: number }} display */
    show({ lamps: lit, clean_light: [colour, intensity], digits: text, weekdays, schedule }) {
      setAttribute(light, "fill", cleanColour(colour, intensity));
      for (const { bit, colour: shine, lamp } of lamps) setAttribute(lamp, "fill", lit & bit ? shine : "#0000");
      setText(digits, text.replace(/[^ -~]/g, " "));
      for (const { bit, node } of days) setAttribute(node, "visibility", weekdays & bit ? "visible" : "hidden");
      for (const { bit, node } of marks) setAttribute(node, "visibility", schedule & bit ? "visible" : "hidden");
      const on = [
        ...lamps.filter(({ bit }) => lit & bit),
        ...days.filter(({ bit }) => weekdays & bit),
        ...marks.filter(({ bit }) => schedule & bit),
      ].map(({ name }) => name);
      setAttribute(svg, "aria-label", `Display: ${text.trim() || "dark"}. Lamps: ${on.join(", ") || "none"}. Clean light: ${intensity === 0 ? "off" : colour < 85 ? "green" : colour < 170 ? "orange" : "red"}.`);
    },
  };
}

/** @param {ConnectionTab} it */
export function startVirtual(it) {
  const { svg, show } = face();
  const touch = (/** @type {import("./types").Touch} */ what) => it.connection.virtual(what);
  const key = (/** @type {string} */ id, /** @type {string} */ text, /** @type {string} */ tip) => make("button", { type: "button", id, "data-tip": tip }, text);
  const presses = BUTTONS.map(([bit, name]) => {
    const node = key(`hand-${name.toLowerCase()}`, name, `Presses the robot's ${name} button.`);
    node.addEventListener("click", () => touch({ do: "press", buttons: bit }));
    return node;
  });
  const lift = key("hand-lift", "Lift", "");
  const plug = key("hand-plug", "Plug in", "");
  const mute = key("hand-mute", "Mute", "Sounds of the virtual robot on this page.");
  byId("connection-face").replaceChildren(svg, make("div", { className: "connection-hand" }, ...presses, lift, plug, mute), make("p", { className: "note", id: "hand-note" }));
  let isPlugged = false;
  plug.addEventListener("click", () => {
    isPlugged = !isPlugged;
    touch({ do: "plug", plugged: isPlugged });
  });
  lift.addEventListener("click", () => {
    const { virtual } = it.view;
    if (!virtual) return;
    if (!virtual.lifted) touch({ do: "lift" });
    else touch({ do: "put_down", x: virtual.pose[0], y: virtual.pose[1], heading: virtual.pose[2] });
  });
  mute.addEventListener("click", () => {
    hush(!isMuted());
    setText(mute, isMuted() ? "Unmute" : "Mute");
  });

  return {
    /** Whether a pointer on the robot (`isOn`) picks it up. @param {boolean} isOn */
    takes(isOn) {
      if (!isOn || !it.view.virtual) return false;
      touch({ do: "lift" });
      return true;
    },
    /** @param {number} x @param {number} y */
    putDown(x, y) {
      const heading = it.view.virtual?.pose[2] ?? 0;
      touch({ do: "put_down", x, y, heading });
    },
    /** @param {import("./types").ConnectionView} view */
    update({ virtual }) {
      setHidden(byId("connection-virtual-panel"), virtual === null);
      setHidden(byId("connection-hand-tab"), virtual === null);
      if (!virtual) {
        isPlugged = false;
        return;
      }
      show(virtual);
      for (const tune of virtual.tunes) sound(tune);
      setText(lift, virtual.lifted ? "Put down" : "Lift");
      setText(plug, isPlugged ? "Unplug" : "Plug in");
      setAttribute(lift, "data-tip", virtual.lifted ? "Puts it down where it was." : "Lifts it: its wheels drop, and Safe mode ends. Or drag it on the map.");
      setAttribute(plug, "data-tip", isPlugged ? "Unplugs its charger." : "Plugs its charger in: Safe mode ends.");
      const what = virtual.fallen ? "It has fallen down the stairs: lift it and put it down." : virtual.lifted ? "In your hand." : virtual.awake ? `Awake, ${virtual.mode}.` : "Asleep: press Clean to wake it.";
      const dirt = virtual.dirt_left === null ? "" : ` Dirt left: ${Math.round(100 * virtual.dirt_left)} %.`;
      setText(byId("hand-note"), what + dirt);
    },
  };
}
