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
  odometry: "arc",
  distance_m: 0,
  wheels: [0, 0],
  statistics: { baud: 0, frames: 0, bad_checksums: 0, false_headers: 0, implausible: 0, late: 0, texts: 0, noise: 0, bytes: [0, 0], rate_hz: 0, age_ms: 0, latency_ms: null, longest_gap_ms: 0, slot: [0, 0] },
  sleeps_in_s: null,
  awake_s: null,
  drop: null,
  calibration: { what: "", step: "none", text: "", asks: "", suggestion: 0, swapped: false, distance_factor: 1, base_factor: 1 },
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

/** Whether it is a recording that is shown: that has no line. @param {ConnectionView} view */
export const isReplay = ({ transport }) => transport.kind === "" && transport.state === "open";

/** Whether the robot drives at this page's word, or is about to. @param {ConnectionView} view */
export const isMoving = ({ ride, wheels, calibration }) => goesOn(ride) || wheels.some((speed) => speed !== 0) || calibration.step === "moving";

/** Value of a packet from 7 to 58 as it is on the line. @param {number[]} packets @param {number} id */
export const packet = (packets, id) => packets[id - 7] ?? 0;

/** The same, with a sign. @param {number[]} packets @param {number} id */
export const signed = (packets, id) => {
  const value = packet(packets, id);
  return value > 0x7fff ? value - 0x10000 : value;
};

/** Counts of the wheels, both together, that are no trembling. */
const MOVED_COUNTS = 4;
/** For how long wheels count as turning after they did, and how long it takes to come to rest after a stop, ms. */
const [STILL_MS, REST_MS] = [600, 1200];

/**
 * Tells whether the robot moves without this page: by its own program, by bytes that were sent, or pushed by somebody. To be
 * asked with every view.
 */
export function watchWheels() {
  /** @type {[number, number] | undefined} */
  let counts;
  let movedAt = -Infinity;
  let drivenAt = -Infinity;
  return (/** @type {ConnectionView} */ view) => {
    const now = performance.now();
    const { packets, phase } = view;
    if (phase !== "connected" || packets.length === 0) {
      counts = undefined;
      movedAt = -Infinity;
      return false;
    }
    const latest = /** @type {[number, number]} */ ([packet(packets, 43), packet(packets, 44)]);
    // Counters run over at 65536.
    const turned = counts ? [0, 1].reduce((sum, wheel) => sum + Math.abs((((latest[wheel] ?? 0) - (counts?.[wheel] ?? 0)) << 16) >> 16), 0) : 0;
    if (turned >= MOVED_COUNTS) movedAt = now;
    if (!counts || turned >= MOVED_COUNTS) counts = latest;
    if (isMoving(view)) drivenAt = now;
    return now - movedAt < STILL_MS && now - drivenAt > REST_MS;
  };
}

/** Who is there while nothing can be done with it. @param {ConnectionView["diagnosis"]} diagnosis @returns {[what: string, more: string]} */
export function waitedFor({ finding }) {
  if (finding === "no_stream") return ["A robot answers", "but doesn't stream its sensors"];
  if (finding === "stream" || finding === "robot" || finding === "text") return ["Robot detected", "but it doesn't answer yet"];
  if (finding === "charging") return ["Robot is charging", "but it doesn't answer yet"];
  if (finding === "booting") return ["Robot is starting", "it should answer soon"];
  if (finding === "bootloader") return ["Robot is in its bootloader", "it doesn't answer there"];
  if (finding === "garbage") return ["Unreadable data", "maybe another speed"];
  return ["No answer", "still trying"];
}

/**
 * What it is doing, in a few words, and a few more.
 * @param {ConnectionView} view @param {boolean} movesAlone As `watchWheels` says. @returns {[what: string, more: string]}
 */
export function doing(view, movesAlone) {
  const { phase, ride, mode, transport, calibration, drop } = view;
  if (isReplay(view)) return ["Recording", `nothing can be driven${ride && goesOn(ride) ? `. Then: ${ride.manual ? "driven by hand" : ride.title}` : ""}`];
  if (!isOpen(view)) return ["No robot", "connect one, or try the virtual one"];
  if (phase === "diagnosing" || phase === "closed") return ["Looking for a robot", transport.name];
  if (phase === "waiting") return waitedFor(view.diagnosis);
  if (phase === "lost" || transport.state === "lost") return ["Connection lost", transport.text];
  if (calibration.step === "moving") return ["Calibrating", calibration.text];
  const turns = view.wheels.some((speed) => speed !== 0);
  // Control by hand goes on for a while after one has let go; who stands still isn't driven.
  if (ride && goesOn(ride) && (turns || !ride.manual)) return [ride.manual ? "You drive" : ride.title, ride.manual ? "" : ride.activity];
  if (turns) return ["Driven by your bytes", "Stop ends it"];
  if (movesAlone) return ["Moves by itself", "Stop ends it"];
  if (calibration.step === "asking") return ["Calibrating", "waiting for your answer: Tools, Calibrate"];
  // Why control was lost is said above the map already.
  if (drop) return [ride && !ride.manual ? `${ride.title}: ended` : "Not in control", "take control again to drive"];
  if (ride && !ride.manual && (ride.ended || ride.done)) {
    // Nor what a notice says.
    return [`${ride.title}: ${ride.ended ? "ended" : "done"}`, view.notice?.text.startsWith(ride.ended) ? "" : ride.ended];
  }
  if (mode === "Passive") return ["Watching", "take control to drive"];
  return ["Ready", `${mode}: drive, or start an algorithm`];
}
