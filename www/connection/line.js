// @ts-check
// State of the line: rate, errors, latency, slot; and its recording.
import { button, byId, make, setHidden, setText } from "../dom.js";
import { row } from "../dashboard.js";
import { count } from "../format.js";
import { ask } from "./dialogs.js";
import { download } from "../files.js";

/** @typedef {import("./types").ConnectionView} ConnectionView */

/** @type {[name: string, tip: string, text: (view: ConnectionView) => string][]} */
const ROWS = [
  ["Speed", "Baud rate. Usually 115,200; a robot that lost its settings may use 19,200.", ({ statistics: s }) => `${count(s.baud)} baud`],
  ["Readings", "Complete readings per second, and age of the last one. A robot sends 64 per second.", ({ statistics: s }) => `${s.rate_hz.toFixed(0)} /s, ${s.age_ms.toFixed(0)} ms old`],
  ["Latency", "Time from a command until the robot reports it: median of recent commands.", ({ statistics: s }) => (s.latency_ms === null ? "not measured yet" : `${s.latency_ms.toFixed(0)} ms`)],
  ["Longest gap", "The longest time without a reading.", ({ statistics: s }) => `${s.longest_gap_ms.toFixed(0)} ms`],
  ["Bad readings", "Rejected readings: damaged in transit + physically impossible. They have no effect on what the robot does.", ({ statistics: s }) => `${count(s.bad_checksums)} + ${count(s.implausible)} of ${count(s.frames)}`],
  ["Noise", "Bytes outside any reading, as from a bad cable, and false starts of readings.", ({ statistics: s }) => `${count(s.noise)} B, false starts: ${count(s.false_headers)}`],
  ["Slot", "Load of the connection: bytes of a reading, and how many fit between two readings (15 ms) at this speed. More would be cut off.", ({ statistics: s }) => `${s.slot[0]} of ${s.slot[1]} B`],
  ["Bytes", "Received and sent.", ({ statistics: s }) => `${count(s.bytes[0])} · ${count(s.bytes[1])}`],
  ["Wake-up wire", "The cable's BRC wire, which wakes a sleeping robot. Many cables lack it.", ({ transport: t }) => ({ low: "pulled low", high: "released", none: "none" })[t.brc]],
  ["Adapter errors", "Breaks, framing, parity and overrun errors that the adapter reported.", ({ transport: { errors: e } }) => `${e.break} · ${e.framing} · ${e.parity} · ${e.overrun}`],
];

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: ConnectionView) => void} */
export function startLine(it) {
  const rows = ROWS.map(([name, tip, text]) => {
    const value = make("span", { className: "value" }, "–");
    return { node: row(name, tip, value), value, text };
  });
  byId("connection-line").replaceChildren(...rows.map(({ node }) => node));
  button("connection-save").addEventListener("click", async () => download("robot-recording.txt", await it.connection.recording(), "text/plain"));
  button("connection-identify").addEventListener("click", async () => {
    const agreed = await ask({
      title: "Restart the robot?",
      points: ["A robot reports its firmware only when it restarts. This takes five seconds, and you have to take control again.", "One robot was reported to stay in its bootloader after this; its battery had to be taken out."],
      yes: "Restart it",
      isWarning: true,
    });
    if (agreed) await it.request({ do: "identify" });
  });

  return (view) => {
    for (const { value, text } of rows) setText(value, view.is_open ? text(view) : "–");
    setHidden(byId("connection-record"), view.is_recording || (!view.is_open && view.statistics.bytes[0] === 0));
    // What stays of a robot that isn't connected any more says so.
    setText(byId("connection-save-label"), view.is_open ? "Save recording" : "Save last recording");
    setHidden(button("connection-identify"), !view.is_open || view.is_recording);
    setText(byId("connection-firmware"), view.firmware ? `Firmware: ${view.firmware}` : "");
  };
}
