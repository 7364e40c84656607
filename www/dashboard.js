// @ts-check
// The robot's sensor readings, only of sensors that the robot has.
import { byId, changed, make, setAttribute, setText } from "./dom.js";
import { count } from "./format.js";
import { cliffSensors, portrait } from "./portrait.js";
import { scanPlot } from "./scan.js";
import { atMostEvery } from "./shared/frame-pacer.js";

/**
 * @typedef {import("./types").SensorsView} Reading
 * @typedef {import("./types").RobotEntry} Robot
 * @typedef {{ node: HTMLElement, show: (of: Reading) => void }} Part
 */

/** Milliseconds between looks at the sensors: faster numbers can't be read. */
const PAUSE = 60;
/** Largest value of the dirt sensor. */
const MOST_DIRT = 255;

/** @param {import("./main.js").App} app @returns {(view: import("./types").PageView) => void} */
export function startDashboard(app) {
  const board = byId("dashboard");
  /** @type {((of: Reading) => void)[]} */
  let parts = [];
  /** @type {((scan: Float32Array) => void) | undefined} */
  let showScan;
  const isDue = atMostEvery(PAUSE);

  /** @param {Robot} robot */
  const build = (robot) => {
    const { svg, show } = portrait(robot);
    const rows = instruments(robot);
    const laser = robot.laser.length > 0 ? scanPlot(robot) : undefined;
    board.replaceChildren(svg, ...(laser ? [laser.node] : []), ...rows.map(({ node }) => node));
    parts = [show, ...rows.map((row) => row.show)];
    showScan = laser?.show;
  };

  return (view) => {
    setText(byId("activity"), doing(view));
    if (!isDue(() => board.checkVisibility({ visibilityProperty: true }))) return;
    if (changed(board, "robot", `${view.robot} ${view.own_robot}`)) build(app.playground.robot());
    const reading = app.playground.readings();
    if (!reading) return;
    for (const show of parts) show(reading);
    showScan?.(app.playground.scan());
  };
}

/** The parts of the dashboard beside the robot's portrait. @param {Robot} robot @returns {Part[]} */
export function instruments(robot) {
  return [flags(robot), ...(robot.cliffs.some(Boolean) ? [cliffs(robot)] : []), ...(robot.gauge ? [battery()] : []), ...(robot.infrared ? [infrared()] : []), wheels(robot), dirt()];
}

/** @param {import("./types").PageView} view */
function doing({ activity, is_lifted, state, kind }) {
  if (is_lifted) return "In your hand";
  const text = activity || (kind === "planner" ? "following its plan" : "");
  return state === "finished" ? "Done" : text.charAt(0).toUpperCase() + text.slice(1);
}

/** A value with its definition. @param {string} name @param {string} tip @param {...Node} values */
export const row = (name, tip, ...values) => make("div", { className: "reading", "data-tip": tip }, make("button", { type: "button", className: "term" }, name), ...values);

/** Yes or no, lit if yes. @param {Robot} robot @returns {Part} */
function flags(robot) {
  /** @type {[name: string, tip: string, is: (of: Reading) => boolean][]} */
  const all = [];
  if (robot.light.length > 0) all.push(["Wall", "The wall sensor on the right detects something close.", (of) => of.wall]);
  if (robot.infrared) all.push(["Virtual wall", "The beam of a virtual wall is detected.", (of) => of.virtual_wall]);
  if (robot.wheel_drops) all.push(["Wheel drop", "A wheel has dropped: the robot was lifted, or stands over an edge.", (of) => of.wheel_drops.includes(true)]);
  all.push(["Moving", "The castor turns: the robot is actually moving (stasis sensor).", (of) => of.is_moving]);
  const lamps = all.map(([name, tip, is]) => ({ is, lamp: make("li", { "data-tip": tip }, make("button", { type: "button", className: "term" }, name)), state: make("span", { className: "hidden-text" }) }));
  for (const { lamp, state } of lamps) lamp.append(state);
  const motors = make("li", { className: "overload", hidden: true, "data-tip": "A motor draws too much current: it is probably blocked." });
  return {
    node: make("ul", { className: "lamps" }, ...lamps.map(({ lamp }) => lamp), motors),
    show: (of) => {
      for (const { is, lamp, state } of lamps) {
        setAttribute(lamp, "class", is(of) ? (lamp.textContent?.startsWith("Moving") ? "good" : "on") : "");
        setText(state, is(of) ? ": yes" : ": no");
      }
      const over = of.overloads.join(", ");
      if (changed(motors, "over", over)) {
        motors.hidden = over === "";
        motors.textContent = `Overload: ${over}`;
      }
    },
  };
}

/** A bar whose length is a share. */
function bar() {
  const level = make("i");
  const node = make("span", { className: "gauge", "aria-hidden": "true" }, level);
  return { node, set: (/** @type {number} */ share) => changed(level, "share", share) && level.style.setProperty("--share", String(share)) };
}

/** @param {Robot} robot @returns {Part} */
function cliffs(robot) {
  const text = make("span", { className: "value" });
  const sensors = cliffSensors(robot);
  return {
    node: row("Cliff signals", "Light that the floor reflects to the cliff sensors, left to right, 0 to 4095. Over an edge there is none.", text),
    show: (of) => setText(text, sensors.map((index) => of.cliff_signals[index]).join(" · ")),
  };
}

/** @returns {Part} */
function battery() {
  const { node, set } = bar();
  const text = make("span", { className: "value" });
  const shown = row("Battery", "Charge and current as the battery gauge reports them; a negative current discharges.", node, text);
  return {
    node: shown,
    show: ({ battery: { share, current_ma: current, on_dock, is_known, is_low } }) => {
      set(Math.round(share * 200) / 200);
      setText(text, is_known ? `${Math.round(100 * share)} %, ${on_dock ? "on the dock, " : ""}${current < 0 ? "−" : ""}${count(Math.abs(current))} mA` : "not read yet");
      setAttribute(shown, "class", on_dock ? "reading charging" : is_low ? "reading low" : "reading");
    },
  };
}

/** @returns {Part} */
function infrared() {
  const receivers = ["Left", "Top", "Right"].map((title) => {
    const text = make("b", {}, "–");
    const beams = ["green", "field", "red"].map((name) => make("i", { className: name }));
    const cell = make("span", { className: "receiver" }, make("small", {}, title), make("span", { className: "beams", "aria-hidden": "true" }, ...beams), text);
    return { text, cell };
  });
  return {
    node: row("Infrared", "Beams that the receivers detect: the dock's green and red buoys and its force field, or a virtual wall.", make("span", { className: "receivers" }, ...receivers.map(({ cell }) => cell))),
    show: (of) => {
      of.infrared.forEach((beams, index) => {
        const { text, cell } = /** @type {typeof receivers[0]} */ (receivers[index]);
        setText(text, beams.text);
        setAttribute(cell, "class", ["receiver", ...beams.lit].join(" "));
      });
    },
  };
}

/** @param {Robot} robot @returns {Part} */
function wheels(robot) {
  const text = make("span", { className: "value" });
  return {
    node: row("Wheel counts", "Encoders of the left and right wheel. They wrap at 65,536.", text),
    show: ({ counts }) => setText(text, counts.slice(0, robot.lateral ? 3 : 2).map(count).join(" · ")),
  };
}

/** @returns {Part} */
function dirt() {
  const { node, set } = bar();
  const text = make("span", { className: "value" });
  return {
    node: row("Dirt", "Dirt being picked up, 0 to 255.", node, text),
    show: (of) => {
      set(of.dirt / MOST_DIRT);
      setText(text, String(of.dirt));
    },
  };
}
