// Messages between the page, its worker and lines to robots. What comes from Rust is in ../types.d.ts.
import type { ConnectionView as View, Request, SessionSnapshot, Traffic, TransportErrors, TransportView, VirtualView } from "../types";
import type { UsbDevice } from "./usb/types";
export * from "../types";

/** An action of a person on the virtual robot. */
export type Touch =
  | { do: "lift" }
  /** x, y in m, heading in rad. */
  | { do: "put_down"; x: number; y: number; heading: number }
  /** The same at its start, where its estimate begins anew. */
  | { do: "put_at_start"; x: number; y: number; heading: number }
  /** Bits as in packet 18: 1 clean, 2 spot, 4 dock, ... */
  | { do: "press"; buttons: number }
  | { do: "plug"; plugged: boolean };

/** A connection to open. */
export type Target =
  | { kind: "virtual"; personality: string }
  /** Without a port, the user chooses one, which requires a click. */
  | { kind: "serial"; port?: SerialPort }
  | { kind: "usb"; port?: UsbDevice }
  | { kind: "socket"; url: string };

/** The argument of `onview`. */
export type ConnectionView = View & { virtual: VirtualView | null };

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

/** Connections that this browser supports. */
export type Support = {
  /** Serial ports of the system, by Web Serial. */
  serial: boolean;
  /** Adapters that the page drives itself, by WebUSB. Only where Web Serial is missing or, on Android, lacks most adapters. */
  usb: boolean;
  socket: boolean;
  /** Why no adapter can be used, a sentence; "" if one can. */
  why: string;
  /** Alternatives; "" if nothing is missing. */
  instead: string;
};

/** The playground's room and settings, and the algorithm to drive, as arguments of `SessionMirror.follow`. */
export type Followed = { snapshot: SessionSnapshot; algorithm?: string };

/** A granted port as the worker finds it again: the granted ones' ids in their order, and which of them it is. */
export type PortAddress = { ids: string[]; index: number };

export type WorkerTarget =
  | { kind: "virtual"; personality: string }
  | { kind: "serial" | "usb"; address: PortAddress }
  | { kind: "socket"; url: string };

/** A line that the line's worker holds. */
export type LineTarget = Exclude<WorkerTarget, { kind: "virtual" }>;

/** Messages from the driver to the worker that holds the line. Those with an `id` are answered by `done`. */
export type ToLine =
  | { type: "open"; id: number; target: LineTarget }
  /** `isActing`: whether the robot may be moving because of it. */
  | { type: "write"; bytes: Uint8Array; isActing: boolean }
  | { type: "beat"; isActing: boolean }
  | { type: "take" }
  | { type: "stop" }
  /** It has read that the page stopped the robot: what it writes from now on was decided after that. */
  | { type: "left" }
  | { type: "baud"; id: number; baud: number }
  | { type: "brc"; id: number; isLow: boolean }
  | { type: "close"; id: number };

/** Messages from there to the driver; `view` is the present state of the line. */
export type FromLine =
  | { type: "beat"; view?: TransportView }
  | { type: "bytes"; bytes: Uint8Array }
  | { type: "opened"; view?: TransportView }
  | { type: "halted"; why: string; view?: TransportView }
  | { type: "lost"; why: string; forGood: boolean; view?: TransportView }
  | { type: "done"; id: number; view?: TransportView; failure?: Failure };

/** Messages from the page to the worker. Those with an `id` are answered. */
export type ToConnection =
  | { type: "init"; module: WebAssembly.Module; holder: MessagePort }
  /** `at` is the page's time, s. */
  | { type: "beat"; at: number }
  | { type: "leave"; why: string }
  | { type: "follow"; id: number } & Followed
  | { type: "open"; id: number; target: WorkerTarget }
  | { type: "close"; id: number }
  | { type: "request"; id: number; request: Request }
  | { type: "ride"; id: number; corners: Float64Array; knots: Float64Array; cleans: boolean }
  | { type: "virtual"; touch: Touch }
  | { type: "recording"; id: number }
  /** Facts about the robot for the user's program, as JSON. */
  | { type: "facts"; id: number }
  /** What the user's program answers to readings: speeds of both wheels, mm/s; NaN if it is done. */
  | { type: "answer"; left: number; right: number };

/** Messages from the workers to the page. */
export type FromConnection =
  /** From the driver: the worker that holds the line no longer answers and has to be ended. */
  | { type: "line-gone" }
  /** From the worker that holds the line: the driver no longer answers; or an error of the program. */
  | { type: "driver-gone" }
  | { type: "line-broke"; why: string }
  | { type: "view"; view: ConnectionView }
  | { type: "traffic"; traffic: Traffic[] }
  | { type: "trace"; trace: Float64Array }
  /** For the user's program, which drives: to be answered. */
  | { type: "readings"; readings: Float64Array }
  | { type: "failed"; failure: Failure }
  /** `value` of a recording is its text, of anything else whether it was done. */
  | { type: "answer"; id: number; value: boolean | string };

/** How a transport talks to the worker. Bytes arrive in any portions. */
export type TransportEvents = {
  onbytes(bytes: Uint8Array): void;
  /** It came back by itself. */
  onopened(): void;
  /** Someone on the way stopped the robot. */
  onhalted?(why: string): void;
  /** It went away; `forGood` if it isn't waited for. */
  onlost(why: string, forGood: boolean): void;
};

/** Errors of a line that an adapter reports and recovers from. */
export type LineError = keyof TransportErrors;
export type PortEvents = { onbytes(bytes: Uint8Array): void; onerror(error: LineError): void; onlost(why: string): void };

/** A port that can be opened once. */
export interface OpenablePort {
  /** Whether the adapter has control lines, once it is open; BRC can be wired to one. */
  readonly hasSignals: boolean;
  /** Opens it with BRC let go; throws a `Failure`. */
  open(baud: number): Promise<void>;
  /** Pulls BRC low, or lets it go; says whether the adapter can. */
  setBrc(isLow: boolean): Promise<boolean>;
  write(bytes: Uint8Array): void;
  /** Sends what was written and closes; takes a second at most. */
  close(): Promise<void>;
}

/** A browser's way to ports. */
export type PortAccess<P> = {
  /** As `navigator` has it. */
  kind: "serial" | "usb";
  /** Where "connect" is fired. */
  source(): EventTarget;
  /** The granted ports. */
  list(): Promise<P[]>;
  /** Has the user choose one; only in a page. */
  ask(): Promise<P>;
  /** USB ids of a port's adapter. */
  id(port: P): string;
  open(port: P, events: PortEvents): OpenablePort;
};

/** A line to a robot. */
export interface Transport {
  readonly view: TransportView;
  /** Opens it at 115200 baud; throws a `Failure`. */
  open(): Promise<void>;
  /** Sends bytes at once; never throws. `isActing`: whether the robot may move because of them. */
  write(bytes: Uint8Array, isActing?: boolean): void;
  /** Changes the baud rate; bytes written before are sent at the old one. */
  setBaud(baud: number): Promise<void>;
  /** Pulls the BRC wire low, or lets it go. */
  setBrc(isLow: boolean): Promise<void>;
  /** Where several clients share a robot: takes the turn to drive it, and stops it whoever drives. */
  take?(): void;
  stop?(): void;
  /** After a stop that the page sent past the driver: the driver knows of it. */
  left?(): void;
  /** Sends pending bytes, and releases everything; takes a second at most. */
  close(): Promise<void>;
}
