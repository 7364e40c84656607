// @ts-check
// Guided calibration: the robot's motion, the measurement, the result; stored for each robot in this browser.
import { byId, changed, make, setAttribute, setEnabled, setHidden, setText } from "../dom.js";
import { draw } from "../portrait.js";
import { keep, kept } from "./dialogs.js";

/** @typedef {import("./types").Calibration} Kind */

/** @type {{ what: Kind, title: string, text: string, room: string, path: string }[]} */
const STEPS = [
  { what: "nudge", title: "1. Nudge", text: "Turns slightly left, to find which wheel counter is which: some robots have them swapped.", room: "Turns on the spot.", path: "M80 20a38 38 0 0 0 -26 10" },
  { what: "spin", title: "2. Spin", text: "Turns once. You enter the true angle; it gives the distance between the wheels.", room: "Turns on the spot. Mark its front with tape first.", path: "M80 20a38 38 0 1 0 1 0" },
  { what: "metre", title: "3. Metre", text: "Drives one metre. You enter the true distance; it gives the size of the wheels.", room: "Needs 1.5 m of free floor ahead. Mark a wheel's position with tape first.", path: "M30 58h96" },
  { what: "square", title: "4. Square", text: "Drives a square of one metre. It should end where it began: a check of the calibration.", room: "Needs 1.5 m ahead and to the left.", path: "M40 96h76v-76h-76z" },
  { what: "square_right", title: "5. Square to the right", text: "The same the other way round. Only both squares together distinguish a wrong wheel base from wheels of unequal size.", room: "Needs 1.5 m ahead and to the right.", path: "M40 20h76v76h-76z" },
];

/** The values of a robot that wasn't calibrated. */
const NOTHING = { swapped: false, distance_factor: 1, base_factor: 1 };

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: import("./types").ConnectionView) => void} */
export function startCalibrate(it) {
  /** Storage key of a robot: the name of its line; virtual robots by personality. @param {import("./types").ConnectionView} view */
  const keyOf = ({ transport }) => `connection-calibration ${transport.kind} ${it.personality || transport.name}`;
  const starts = STEPS.map(({ what, title, text, room, path }) => {
    const svg = draw("svg", { viewBox: "0 0 160 116", class: "connection-picture", "aria-hidden": "true" });
    draw("circle", { cx: what === "metre" ? 30 : what.startsWith("square") ? 40 : 80, cy: what === "square" ? 96 : what === "square_right" ? 20 : 58, r: 16, class: "p-shell" }, svg);
    draw("path", { d: path, class: "p-wire" }, svg);
    const start = make("button", { type: "button" }, "Start");
    start.addEventListener("click", () => it.view.can.drive && void it.request({ do: "calibrate", what }));
    const item = make("li", { "data-what": what }, svg, make("b", {}, title), start, make("p", { className: "note" }, `${text} ${room}`));
    return { item, start };
  });
  const told = make("p", { id: "calibrate-told", role: "status" });
  const measured = make("p", { id: "calibrate-measured", hidden: true });
  const answer = make("input", { type: "number", step: "any", "aria-label": "Measured value" });
  const unit = make("span", {});
  const send = make("button", { type: "submit", className: "primary" }, "Confirm");
  const skip = () => {
    const node = make("button", { type: "button" }, "Skip");
    node.addEventListener("click", () => void it.request({ do: "skip" }));
    return node;
  };
  const number = make("form", { className: "connection-tools", hidden: true }, answer, unit, send, skip());
  const yes = make("button", { type: "button", className: "primary" }, "Yes");
  const no = make("button", { type: "button" }, "No");
  const choice = make("div", { className: "connection-tools", hidden: true }, yes, no, skip());
  const inUse = make("p", { className: "note", id: "calibrate-use" });
  const forget = make("button", { type: "button", hidden: true, "data-tip": "Forgets the calibration of this robot." }, "Model's values");
  forget.addEventListener("click", async () => {
    if (await it.request({ do: "use_calibration", ...NOTHING })) keep(keyOf(it.view), JSON.stringify(NOTHING));
  });
  byId("connection-calibrate").append(told, measured, number, choice, make("ol", { className: "connection-steps" }, ...starts.map(({ item }) => item)), inUse, forget);
  number.addEventListener("submit", (event) => {
    event.preventDefault();
    const value = answer.valueAsNumber;
    if (Number.isFinite(value)) void it.request({ do: "answer", value });
    else answer.focus();
  });
  yes.addEventListener("click", () => void it.request({ do: "answer", value: 1 }));
  no.addEventListener("click", () => void it.request({ do: "answer", value: 0 }));
  /** The robot whose stored values have been sent. */
  let restored = "";

  return (view) => {
    const { calibration, can, phase } = view;
    if (phase === "connected" && !view.is_recording && restored !== keyOf(view)) {
      restored = keyOf(view);
      void it.request({ do: "use_calibration", ...(remembered(restored) ?? NOTHING) });
    }
    if (phase === "closed") restored = "";
    const goes = calibration.step === "moving" || calibration.step === "asking";
    for (const { item, start } of starts) {
      setEnabled(start, can.drive && !goes);
      setAttribute(item, "class", calibration.what === item.getAttribute("data-what") ? `now ${calibration.step}` : "");
    }
    setText(told, calibration.text || (view.is_recording ? "This is a recording: you can't calibrate." : can.drive ? "Short drives make odometry more accurate. Each can be skipped." : "Take control first: the robot has to move for this."));
    setText(measured, calibration.measured);
    setHidden(measured, !calibration.measured);
    setHidden(number, calibration.step !== "asking" || (calibration.asks !== "deg" && calibration.asks !== "m"));
    setHidden(choice, calibration.step !== "asking" || calibration.asks !== "yes");
    const { what, step, asks, suggestion, swapped, distance_factor, base_factor } = calibration;
    if (changed(number, "asked", `${what} ${step}`) && step === "asking") {
      answer.value = String(suggestion);
      setText(unit, asks === "deg" ? "degrees" : "metres");
      if (asks !== "yes") answer.select();
      told.scrollIntoView({ block: "nearest" });
    }
    if (step === "done" && !view.is_recording && changed(told, "kept", `${swapped} ${distance_factor} ${base_factor}`)) keep(keyOf(view), JSON.stringify({ swapped, distance_factor, base_factor }));
    setHidden(forget, view.is_recording || phase !== "connected" || (!swapped && distance_factor === 1 && base_factor === 1));
    setText(inUse, `In use: wheel counters ${swapped ? "swapped" : "as specified"}, ${distance_factor.toFixed(4)} m driven per metre counted, wheels ${(235 * base_factor).toFixed(1)} mm apart.`);
  };
}

/** @param {string} key @returns {{ swapped: boolean, distance_factor: number, base_factor: number } | undefined} */
function remembered(key) {
  try {
    const { swapped, distance_factor, base_factor } = JSON.parse(kept(key) ?? "");
    if (typeof swapped === "boolean" && Number.isFinite(distance_factor) && Number.isFinite(base_factor)) return { swapped, distance_factor, base_factor };
  } catch {
    // Nothing is kept, or nothing that can be used.
  }
  return undefined;
}
