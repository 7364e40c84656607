// @ts-check
// What is shown while nothing is connected, and short words on what is.

/** @typedef {import("./types").ConnectionView} ConnectionView */

/** @type {ConnectionView} */
export const CLOSED = {
  phase: "closed",
  diagnosis: { step: "", finding: "", text: "", remedy: "", log: [] },
  mode: "",
  mode_offset: false,
  ride: null,
  packets: [],
  pose: [0, 0, 0],
  distance_m: 0,
  wheels: [0, 0],
  statistics: { baud: 0, frames: 0, bad_checksums: 0, false_headers: 0, implausible: 0, late: 0, texts: 0, noise: 0, bytes: [0, 0], rate_hz: 0, age_ms: 0, latency_ms: null, longest_gap_ms: 0, slot: [0, 0] },
  sleeps_in_s: null,
  awake_s: null,
  drop: null,
  calibration: null,
  firmware: null,
  notice: null,
  can: { connect: false, disconnect: false, arm: false, disarm: false, drive: false, press: false },
  transport: { kind: "", state: "closed", name: "", text: "", baud: 0, can_baud: false, brc: "none", errors: { break: 0, framing: 0, parity: 0, overrun: 0 }, returns: 0 },
  virtual: null,
};

/** Whether a line is open, or waited for. @param {ConnectionView} view */
export const isOpen = ({ phase, transport }) => phase !== "closed" || transport.state === "opening" || transport.state === "open" || transport.state === "lost";

/** Whether a ride isn't over. @param {ConnectionView["ride"]} ride */
export const goesOn = (ride) => ride !== null && !ride.done && !ride.ended;

/** Whether the robot drives, or is about to. @param {ConnectionView} view */
export const isMoving = ({ ride, wheels, calibration }) => goesOn(ride) || wheels.some((speed) => speed !== 0) || calibration?.step === "moving";

/** Value of a packet from 7 to 58 as it is on the line. @param {number[]} packets @param {number} id */
export const packet = (packets, id) => packets[id - 7] ?? 0;

/** The same, with a sign. @param {number[]} packets @param {number} id */
export const signed = (packets, id) => {
  const value = packet(packets, id);
  return value > 0x7fff ? value - 0x10000 : value;
};

/** What it is doing, in a few words, and a few more. @param {ConnectionView} view @returns {[what: string, more: string]} */
export function doing(view) {
  const { phase, ride, mode, transport, calibration } = view;
  if (!isOpen(view)) return ["No robot", "connect one, or try the virtual one"];
  if (phase === "diagnosing" || phase === "closed") return ["Finding out who is there", transport.name];
  if (phase === "waiting") return ["Nobody answers", "it goes on trying"];
  if (phase === "lost" || transport.state === "lost") return ["Connection lost", transport.text];
  if (calibration?.step === "moving") return ["Calibrating", calibration.text];
  if (ride && goesOn(ride)) return [ride.manual ? "You drive" : ride.title, ride.manual ? "" : ride.activity];
  if (ride && !ride.manual && (ride.ended || ride.done)) return [`${ride.title}: ${ride.ended ? "ended" : "done"}`, ride.ended];
  if (mode === "Passive") return ["Watching", "take control to drive"];
  return ["Ready", `${mode}: drive, or let an algorithm`];
}
