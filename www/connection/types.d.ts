// Messages between the page, its worker and lines to robots. What comes from Rust is in ../types.d.ts.
import type { ConnectionView as View, Request, SessionSnapshot, Traffic, TransportView, VirtualView } from "../types";
export * from "../types";

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

/** What `onview` gets. */
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

/** What can be connected to from this browser. */
export type Support = {
  serial: boolean;
  socket: boolean;
  /** Why serial ports can't be used, a sentence; "" if they can. */
  why: string;
  /** What works instead; "" if nothing is missing. */
  instead: string;
};

/** The playground's room and settings, and what is to drive, as `SessionMirror.follow` takes them. */
export type Followed = { snapshot: SessionSnapshot; algorithm?: string };

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
  | { type: "follow"; id: number } & Followed
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
