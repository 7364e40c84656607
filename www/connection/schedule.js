// @ts-check
// The robot's clock, and the weekly schedule by which it cleans.
import { byId, make, setEnabled, setText } from "../dom.js";
import { ask, keep, kept } from "./dialogs.js";
import { group } from "./switches.js";

const DAYS = ["Sunday", "Monday", "Tuesday", "Wednesday", "Thursday", "Friday", "Saturday"];
const KEY = "connection-schedule";
/** @typedef {[hour: number, minute: number]} Time */
/** @typedef {{ on: boolean, time: string }} Day */

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: import("./types").ConnectionView) => void} */
export function startSchedule(it) {
  const known = remembered();
  const told = make("p", { className: "note", id: "schedule-told", role: "status" }, "Robots don't report their schedule. This is what was set here last.");
  const rows = DAYS.map((name, day) => {
    const on = make("input", { type: "checkbox", checked: known[day]?.on ?? false });
    const time = make("input", { type: "time", required: true, value: known[day]?.time ?? "10:00", "aria-label": `Time on ${name}` });
    return { on, time, name, node: make("div", { className: "schedule-day" }, make("label", { className: "check" }, on, make("span", { className: "label" }, name)), time) };
  });
  const clock = make("button", { type: "button", id: "schedule-clock", "data-tip": "Sets the robot's clock to the time of this computer. A schedule needs it." }, "Set clock to now");
  const set = make("button", { type: "submit", className: "primary", id: "schedule-set" }, "Set schedule");
  const clear = make("button", { type: "button", id: "schedule-clear" }, "Clear schedule");
  const form = make("form", { className: "schedule" }, ...rows.map(({ node }) => node), make("div", { className: "connection-hand" }, set, clear));
  byId("connection-schedule").append(
    make("div", { className: "connection-sets" },
      group("Schedule", form),
      group("Clock", make("p", { className: "note" }, "The robot forgets clock and schedule when it loses power."), clock, told),
    ),
  );

  clock.addEventListener("click", async () => {
    const now = new Date();
    const [day, hour, minute] = [now.getDay(), now.getHours(), now.getMinutes()];
    if (await it.request({ do: "clock", day, hour, minute })) setText(told, `The clock was set to ${DAYS[day]}, ${written([hour, minute])}.`);
  });
  /** @param {number} days */
  const send = async (days) => {
    const times = /** @type {[Time, Time, Time, Time, Time, Time, Time]} */ (rows.map(({ time }) => read(time.value)));
    if (!(await it.request({ do: "schedule", days, times }))) return;
    keep(KEY, JSON.stringify(rows.map(({ on, time }) => ({ on: on.checked, time: time.value }))));
    const chosen = rows.filter(({ on }) => on.checked).map(({ name, time }) => `${name} ${time.value}`);
    setText(told, days === 0 ? "The robot has no schedule now." : `The robot cleans by itself: ${chosen.join(", ")}.`);
  };
  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    const days = rows.reduce((bits, { on }, day) => bits | (Number(on.checked) << day), 0);
    const agreed = days === 0 || (await ask({
      title: "Let it clean by itself?",
      points: ["At the chosen times the robot starts to clean by itself, even when this page is closed.", "It doesn't start while this page is in control."],
      yes: "Set schedule",
      isWarning: true,
    }));
    if (agreed) await send(days);
  });
  clear.addEventListener("click", () => {
    for (const { on } of rows) on.checked = false;
    void send(0);
  });

  return ({ can }) => {
    for (const node of [clock, set, clear]) setEnabled(node, can.press);
  };
}

/** @param {string} text @returns {Time} */
const read = (text) => /** @type {Time} */ (text.split(":").map(Number));
/** @param {Time} time */
const written = (time) => time.map((part) => String(part).padStart(2, "0")).join(":");

/** @returns {Day[]} */
function remembered() {
  try {
    const days = JSON.parse(kept(KEY) ?? "[]");
    if (Array.isArray(days) && days.every(({ on, time }) => typeof on === "boolean" && /^\d\d:\d\d$/.test(time))) return days;
  } catch {
    // Then the usual ones.
  }
  return [];
}
