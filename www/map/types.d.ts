// Shapes of the plain objects that cross the boundary to Rust (src/app/survey/view.rs writes them).

export type Phase = "failed" | "ready" | "playing" | "paused" | "held" | "seeking" | "resuming" | "finished";

/** How far a mapper is from the truth; shares from 0 to 1. Errors are `null` while the robot has no idea where it is. */
export type Figures = {
  position_m: number | null;
  heading_deg: number | null;
  /** Known cells that are right within one cell. */
  right: number;
  /** Floor that the body can cover and that is known to be free. */
  known: number;
  /** Boundary that is on the map. */
  boundary: number;
};

export type MapView = {
  phase: Phase;
  can: Record<"play" | "pause" | "step" | "seek" | "lift" | "put_down" | "forget" | "use_map" | "clean" | "open", boolean>;
  /** Why the robot can't be put into the room; "" if it can. */
  complaint: string;
  title: string;
  behaviour: string;
  activity: string;
  params: Record<string, string | number | boolean>;
  tracking: string;
  counts: string;
  wheels: string;
  /** A level, or one for each kind of sensor. */
  senses: string;
  layers: string[];
  speed: number;
  speed_factor: number;
  time_s: number;
  end_s: number;
  /** How far the way back to a mapping run that was left is done; `null` if there is none. */
  returned: number | null;
  figures: Figures | null;
  odometry: Figures | null;
  /** How far off dead reckoning would be, by counts along arcs and in straight pieces, then by packets: m and degrees. */
  drifts: [position: number, heading: number][];
  /** Standard deviations that the robot estimates: position (m) and heading (degrees). */
  spread: [position: number, heading: number] | null;
  /** Name of the map that the robot was given; `null` if it makes its own. */
  known: string | null;
  /** Whether it is sure of its place on that; `null` if it was never lost. */
  is_sure: boolean | null;
  planner: string;
  /** Pieces of unknown floor that it could go for. */
  frontiers: number;
  /** Whether it is driving along a line to somewhere. */
  has_route: boolean;
  is_cleaning: boolean;
  /** Floor that it can get to by its map: estimated swept, and all; `null` unless it cleans by that. */
  by_map: [swept: number, all: number] | null;
  cleaned_m2: number;
  coverage: number;
  dirt_m2: number;
  samples: number;
  version: number;
  /** Whether a hand holds the robot. */
  is_carried: boolean;
};
