// Shapes that cross from page to worker and back, and from Rust: src/app/link/request.rs, src/app/link/view.rs and
// src/web/virtual_robot.rs have the same fields.

/** What a user asks of a robot; `src/app/link/request.rs` says what each one does. */
export type Request =
  | { do: "connect" | "disconnect" | "disarm" | "stop" | "identify" }
  | { do: "arm"; full: boolean }
  /** -1 to 1 each; holds for 200 ms. */
  | { do: "drive"; forward: number; left: number }
  | { do: "press"; button: "clean" | "spot" | "dock" | "power" }
  /** 256 bytes at most. */
  | { do: "raw"; bytes: number[] }
  /** Notes of MIDI number and 1/64 s. */
  | { do: "song"; number: number; notes: [note: number, duration: number][] }
  | { do: "leds"; lamps: number; colour: number; intensity: number }
  | { do: "digits"; text: string }
  | { do: "schedule_leds"; weekdays: number; lamps: number }
  | { do: "motors"; bits: number }
  | { do: "calibrate"; what: CalibrationKind }
  | { do: "answer"; value: number }
  | { do: "skip" }
  | { do: "odometry"; model: string }
  | { do: "use_calibration"; swapped: boolean; distance_factor: number; base_factor: number };

export type CalibrationKind = "nudge" | "spin" | "metre" | "square";

/** Snapshot of a connection, 20 a second. */
export type ConnectionState = {
  phase: "closed" | "diagnosing" | "waiting" | "connected" | "lost";
  diagnosis: {
    step: "" | "listening" | "asking" | "waking" | "slow" | "create1" | "waiting" | "done";
    finding: "" | "nothing" | "silence" | "stream" | "charging" | "booting" | "bootloader" | "garbage" | "text" | "no_stream" | "robot";
    text: string;
    remedy: string;
    log: string[];
    is_shown: boolean;
    picture: string;
    caption: Caption;
  };
  mode: "" | "Off" | "Passive" | "Safe" | "Full";
  mode_offset: boolean;
  ride: RideView | null;
  readings: RoombaView | null;
  /** x, y in m, heading in rad. */
  pose: [x: number, y: number, heading: number];
  /** Id of the odometry model that this is by. */
  odometry: string;
  distance_m: number;
  /** Left and right, m/s. */
  wheels: [left: number, right: number];
  is_moving: boolean;
  moves_alone: boolean;
  doing: Caption;
  transport: TransportView;
  line: Caption;
  is_open: boolean;
  is_recording: boolean;
  statistics: Statistics;
  sleeps_in_s: number | null;
  awake_s: number | null;
  clock: string;
  drop: { from: string; text: string; remedy: string; can_rearm: boolean } | null;
  calibration: CalibrationView;
  firmware: string | null;
  notice: { number: number; kind: "notice" | "error"; text: string } | null;
  can: Record<"connect" | "disconnect" | "arm" | "disarm" | "drive" | "steer" | "ride" | "press", boolean>;
};

export type Caption = { title: string; note: string };

/** What a Roomba reports over its Open Interface; see `robovac_link::dashboard`. */
export type RoombaView = {
  sensors: import("../types").SensorsView;
  wall_signal: number;
  voltage_v: number;
  charge_mah: number;
  capacity_mah: number;
  temperature_c: number;
  charging: string;
  motors_ma: number[];
  requested_mm_s: number[];
  buttons: string[];
  song: number;
  song_plays: boolean;
};

export type RideView = {
  title: string;
  activity: string;
  time_s: number;
  manual: boolean;
  blocked: [forward: string | null, left: string | null, right: string | null, backward: string | null];
  corner: number | null;
  /** A ride that has come to its end is shown until the next one; `ended` says why, if it was ended. */
  done: boolean;
  ended: string;
};

export type Statistics = {
  baud: number;
  frames: number;
  bad_checksums: number;
  false_headers: number;
  implausible: number;
  /** Believed a frame late, as something in them jumped. */
  late: number;
  texts: number;
  noise: number;
  /** Received and sent. */
  bytes: [received: number, sent: number];
  rate_hz: number;
  age_ms: number;
  latency_ms: number | null;
  longest_gap_ms: number;
  slot: [used: number, room: number];
};

export type CalibrationView = {
  what: CalibrationKind | "";
  step: "none" | "moving" | "asking" | "done" | "failed";
  text: string;
  asks: "" | "yes" | "deg" | "m";
  suggestion: number;
  swapped: boolean;
  distance_factor: number;
  base_factor: number;
};

/** Something that went over the line. */
export type Traffic = {
  time_s: number;
  kind: "sent" | "frame" | "refused" | "text" | "bytes" | "line";
  hex: string;
  text: string;
  times: number;
};

/** What is seen and heard of the virtual robot. Sets of bits are as on the line. */
export type VirtualView = {
  /** Where it really is: x, y in m, heading in rad. */
  pose: [x: number, y: number, heading: number];
  mode: string;
  awake: boolean;
  lifted: boolean;
  fallen: boolean;
  lamps: number;
  /** Colour, 0 green to 255 red, and brightness. */
  clean_light: [colour: number, intensity: number];
  digits: string;
  weekdays: number;
  schedule: number;
  motors: number;
  /** Tunes that began to sound since the view before. */
  tunes: [note: number, duration: number][][];
};

export type Personality = { id: string; title: string; summary: string };

/** What a hand does to the virtual robot. */
export type Touch =
  | { do: "lift" }
  /** x, y in m, heading in rad. */
  | { do: "put_down"; x: number; y: number; heading: number }
  /** Bits as in packet 18: 1 clean, 2 spot, 4 dock, ... */
  | { do: "press"; buttons: number }
  | { do: "plug"; plugged: boolean };

/** What to connect to. */
export type Target =
  | { kind: "virtual"; personality: string }
  /** Without a port, the user is asked for one; that takes a click. */
  | { kind: "serial"; port?: SerialPort }
  | { kind: "socket"; url: string };

/** The line below the robot's bytes. */
export type TransportView = {
  kind: "" | "virtual" | "serial" | "socket";
  /**
   * `lost`: it went away and is waited for, `text` says what for. A line that came back is `open` again; the robot behind it
   * is found out about anew and gets no command to move before the user takes control again.
   */
  state: "closed" | "opening" | "open" | "lost";
  /** Of the adapter, bridge or personality. */
  name: string;
  /** A sentence on the state; "" if there is nothing to tell. */
  text: string;
  baud: number;
  /** Whether the baud rate can be changed from here. */
  can_baud: boolean;
  /** The BRC wire at the adapter's RTS: pulled low, let go, or no such thing (as far as the adapter knows). */
  brc: "low" | "high" | "none";
  /** What the adapter reported and recovered from. */
  errors: { break: number; framing: number; parity: number; overrun: number };
  /** How often it has come back by itself. */
  returns: number;
};

/** What `onview` gets. */
export type ConnectionView = ConnectionState & { virtual: VirtualView | null };

/**
 * What went wrong, for users: `what` is a sentence, `remedy` one on what to do or "".
 *
 * - `unsupported`, `insecure`, `policy`: can't work here, see `support()`;
 * - `denied`: the browser or the user doesn't allow it; `busy`: another tab or program has it; `absent`: it isn't there;
 * - `mixed`: a page over https can't reach a bridge at ws://; `unreachable`: the bridge doesn't answer;
 * - `failed`: it couldn't be opened for another reason;
 * - `refused`: a request isn't possible now;
 * - `broken`: an error of the program; the robot was told to stop, and the connection is closed. It can be opened anew.
 *
 * A chooser that the user dismisses is none of these: `open` just says `false`.
 */
export type Failure = {
  what: string;
  remedy: string;
  kind: "unsupported" | "insecure" | "policy" | "denied" | "busy" | "absent" | "mixed" | "unreachable" | "failed" | "refused" | "broken";
};

/** What can be connected to from this browser. */
export type Support = {
  serial: boolean;
  socket: boolean;
  /** Why serial ports can't be used, a sentence; "" if they can. */
  why: string;
  /** What works instead; "" if nothing is missing. */
  instead: string;
};

/** The playground's room and settings, as `SessionMirror.follow` takes them. */
export type Followed = { link: string; version: number; scenario: string };

/** A granted port as the worker finds it again: the granted ones' ids in their order, and which of them it is. */
export type PortAddress = { ids: string[]; index: number };

export type WorkerTarget =
  | { kind: "virtual"; personality: string }
  | { kind: "serial"; address: PortAddress }
  | { kind: "socket"; url: string };

/** What the page tells the worker. Where there is an `id`, it is answered. */
export type ToConnection =
  | { type: "init"; module: WebAssembly.Module }
  /** `at` is the page's time, s. */
  | { type: "beat"; at: number }
  | { type: "leave"; why: string }
  | { type: "follow"; id: number; followed: Followed }
  | { type: "open"; id: number; target: WorkerTarget }
  | { type: "close"; id: number }
  | { type: "request"; id: number; request: Request }
  | { type: "ride"; id: number; corners: Float64Array }
  | { type: "virtual"; touch: Touch }
  | { type: "recording"; id: number };

/** What the worker tells the page. */
export type FromConnection =
  | { type: "view"; view: ConnectionView }
  | { type: "traffic"; traffic: Traffic[] }
  | { type: "trace"; trace: Float64Array }
  | { type: "failed"; failure: Failure }
  /** `value` of a recording is its text, of anything else whether it was done. */
  | { type: "answer"; id: number; value: boolean | string };

/** How a transport talks to the worker. Bytes arrive in any portions. */
export type TransportEvents = {
  onbytes(bytes: Uint8Array): void;
  /** It came back by itself. */
  onopened(): void;
  /** It went away; `forGood` if it isn't waited for. */
  onlost(why: string, forGood: boolean): void;
};

/** A line to a robot. */
export interface Transport {
  readonly view: TransportView;
  /** Opens it at 115200 baud; throws a `Failure`. */
  open(): Promise<void>;
  /** Sends bytes at once; never throws. */
  write(bytes: Uint8Array): void;
  /** Goes on at another baud rate; bytes that were written before are sent at the old one. */
  setBaud(baud: number): Promise<void>;
  /** Pulls the BRC wire low, or lets it go. */
  setBrc(isLow: boolean): Promise<void>;
  /** Sends what was written, and lets go of everything; takes a second at most. */
  close(): Promise<void>;
}
