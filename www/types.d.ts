// Shapes of the plain objects that cross the boundary to Rust (src/web/playground.rs writes and reads them).

export type ParamSpec = {
  id: string;
  label: string;
  help: string;
  kind: "number" | "choice" | "flag";
  min?: number;
  max?: number;
  step?: number;
  unit?: string;
  options?: [value: string, label: string][];
  default: string | number | boolean;
};

/** A planner or a behaviour. What only the other kind claims is false. */
export type AlgorithmEntry = {
  id: string;
  title: string;
  summary: string;
  source: string;
  link: string;
  kind: "planner" | "behaviour";
  complete: boolean;
  deterministic: boolean;
  /** Plans a million cells in about a second. */
  fast: boolean;
  /** Improves a complete plan, and may be stopped with it. */
  anytime: boolean;
  /** Comes to an end by itself. */
  ends: boolean;
  /** Cleans, rather than going somewhere. */
  cleans: boolean;
  /** Is driven by a person. */
  manual: boolean;
  idea: string;
  complexity: string;
  use_when: string;
  shines: { room: string; why: string };
  fails: { room: string; why: string };
  params: ParamSpec[];
};

export type PlannerEntry = AlgorithmEntry;

/** A robot; its drawing is in units of the radius of the smallest circle around it, x ahead, y to the left, angles in rad. */
export type RobotEntry = {
  id: string;
  title: string;
  summary: string;
  default_cell_m: number;
  tool_width_m: number;
  radius_m: number;
  /** Corners; none of a round one. */
  body: [x: number, y: number][];
  wheel_base: number;
  wheel_radius: number;
  /** Half the angle that the bumper spans; 0 for none. */
  bumper: number;
  /** Left, front left, front right, right; a single front one is listed twice. */
  cliffs: ([x: number, y: number] | null)[];
  /** Directions of the light bumper's beams; none without one. */
  light: number[];
  infrared: boolean;
  wheel_drops: boolean;
  /** Whether it can read its battery. */
  gauge: boolean;
  /** Whether it moves sideways. */
  lateral: boolean;
  /** First direction, step, range (m) and place (m) of its laser scanner; empty without one. */
  laser: number[];
};

export type Catalogue = {
  rooms: { id: string; title: string; note: string }[];
  planners: PlannerEntry[];
  behaviours: AlgorithmEntry[];
  robots: RobotEntry[];
  /** Kinds of sensors whose noise can be chosen. */
  sensors: string[];
  cell_sizes_m: number[];
  /** Times real time; 0 stands for as fast as it goes. */
  speeds: number[];
};

/** What a robot's sensors report; see `robovac_link::dashboard`. */
export type SensorsView = {
  bumper: [left: boolean, right: boolean];
  wheel_drops: [left: boolean, right: boolean];
  is_lifted: boolean;
  cliffs: boolean[];
  cliff_signals: number[];
  wall: boolean;
  virtual_wall: boolean;
  is_moving: boolean;
  overloads: string[];
  light: boolean[];
  light_signals: number[];
  infrared: { lit: string[]; text: string }[];
  battery: { share: number; current_ma: number; on_dock: boolean; is_known: boolean; is_low: boolean };
  counts: [left: number, right: number, lateral: number];
  dirt: number;
};

export type PlanNumbers = {
  /** 0 to 1 */
  progress: number;
  running: boolean;
  reachable_cells: number;
  visited_cells: number;
  steps: number;
  turns: number;
  direction_changes: number;
  initial_turns: number;
  revisits: number;
  revisited_cells: number;
  length_m: number;
  turning_deg: number;
  duration_s: number;
  energy_wh: number;
  coverage: number;
  overlap: number;
  overlap_m2: number;
  /** `null` for a plan that was made in advance. */
  planning_s: number | null;
  /** By how much it costs more than any plan must in what its planner keeps low, as a share of that; 0 if it is proven to be the best, `null` for planners that prove nothing. */
  gap: number | null;
  /** The same in steps + 2 x quarter turns, as plans are compared; `null` as long as nothing is proven, or if it misses cells. */
  above_bound: number | null;
  /** Steps that a quarter turn counts as in `gap`, and whether that is the time that the robot takes. */
  turn_weight: number | null;
  times_turns: boolean;
  /** Share of the search after which it was kept; `null` if the planner ended by itself. */
  kept_at: number | null;
};

export type State = "planning" | "ready" | "playing" | "paused" | "finished" | "seeking" | "failed";
export type Action = "play" | "pause" | "step" | "reset" | "cancel" | "keep" | "seek" | "undo" | "redo" | "edit" | "lift";
export type Tool = "view" | "wall" | "erase" | "start" | "place";

export type View = {
  state: State;
  can: Record<Action, boolean>;
  message: string;
  message_kind: "" | "error" | "notice";
  room: {
    id: string;
    title: string;
    note: string;
    width_m: number;
    height_m: number;
    resolution_m: number;
    cells: number;
    reachable_m2: number;
    /** Free floor that the robot can't reach. */
    left_out_m2: number;
  };
  robot: string;
  algorithm: string;
  kind: "planner" | "behaviour";
  /** What the robot is doing; "" if there is nothing to tell. */
  activity: string;
  /** Changes whenever `diary()` does. */
  diary: number;
  is_lifted: boolean;
  /** Why the robot doesn't obey a person in each direction; `null` unless a person drives. */
  blocked: [forward: string | null, left: string | null, right: string | null, backward: string | null] | null;
  /** Share of the dirt that is left; `null` where there was none. */
  dirt_left: number | null;
  /** Whether it is held here, to be put down somewhere. */
  is_carried: boolean;
  /** Whether it is held in the upper half of the canvas. */
  is_held_high: boolean;
  /** What stands, lies and moves in the room, by name. */
  objects: string[];
  /** Index of the selected one; -1 for none. */
  selected: number;
  /** What the tool "place" places. */
  placing: string;
  params: Record<string, string | number | boolean>;
  cell_size_m: number;
  seed: number;
  slip: string;
  /** By the catalogue's sensors. */
  noise: string[];
  quantised: boolean;
  shows: { coverage: boolean; dirt: boolean; sensors: boolean; estimate: boolean };
  odometry: string;
  speed: number;
  tool: Tool;
  time_s: number;
  /** The furthest time that has been simulated. */
  run_end_s: number;
  /** 0 to 1 */
  coverage: number;
  distance_m: number;
  turning_deg: number;
  bumps: number;
  overlap: number;
  /** Achieved, times real time. */
  speed_factor: number;
  plan: PlanNumbers | null;
  /** The planner's decision at this moment in words; "" if it isn't to be shown. */
  search: {
    offered: boolean;
    on: boolean;
    text: string;
    /** Why it can't be shown in this room. */
    refusal: string;
    /** The film, if there is one to be seen: the picture's number, from 0, and how many there are. */
    film: { at: number; pictures: number; runs: boolean } | null;
  };
  pose_error_m: number;
};

export type PlanRequest = {
  id: number;
  planner: string;
  params: Record<string, string | number | boolean>;
  seed: number;
  width: number;
  height: number;
  free: Uint8Array;
  start: [number, number];
  heading: string;
  step_s: number;
  turn_s: number;
};

/** What the planning worker is told, and what it answers. Cells are x, y, x, y, ... */
export type ToWorker =
  | { type: "init"; module: WebAssembly.Module }
  | { type: "plan"; request: PlanRequest }
  | { type: "prove"; request: PlanRequest; cells: Uint32Array }
  | { type: "trial"; request: { id: number } }
  | { type: "runs"; request: { id: number } }
  | { type: "read"; request: { id: number; files: { name: string; bytes: Uint8Array }[] } };
/** What a plan costs, and what any must cost. */
export type Proof = Float64Array;
export type FromWorker =
  | { type: "progress"; id: number; done: number; cells: Uint32Array; proof: Proof | undefined; film: unknown[] | undefined }
  /** What the planner proves itself; how good the plan is as plans are compared is told later. */
  | { type: "finished"; id: number; cells: Uint32Array; seconds: number; trace: unknown; proof: Proof | undefined }
  | { type: "proven"; id: number; proof: Proof | undefined }
  | { type: "failed"; id: number; message: string };

export type FromTrial =
  | { type: "progress"; id: number; done: number; cells: Uint32Array }
  | { type: "tried"; id: number; cells: Uint32Array; numbers: unknown }
  | { type: "failed"; id: number; message: string };

/** Outcomes of runs, as `MonteCarlo.batch_finished` takes them. */
export type FromRuns = { type: "ran"; id: number; outcomes: Float64Array } | { type: "failed"; id: number; message: string };

/** A map as `read_map` has read it (src/web/map.rs). */
export type ReadMap = { name: string; width: number; cells: Uint8Array };

export type FromReader = { type: "read"; id: number; map: ReadMap } | { type: "failed"; id: number; message: string };

/** Snapshot of the comparison (src/web/comparison_view.rs). Entrants are in the order of the catalogue's planners. */
export type CompareView = {
  /** Changes whenever the table does. */
  version: number;
  set: string;
  sets: [id: string, title: string][];
  seeds: number;
  rooms: string[];
  done: number;
  total: number;
  cancelled: boolean;
  entrants: {
    id: string;
    chosen: boolean;
    params: Record<string, string | number | boolean>;
    state: "out" | "trying" | "done" | "failed";
    /** 0 to 1 */
    progress: number;
    message: string;
  }[];
  race: RaceView | null;
};

export type RaceView = {
  state: State;
  time_s: number;
  end_s: number;
  planned_s: number;
  speed: number;
  lanes: { entrant: number; coverage: number; time_s: number; distance_m: number; turning_deg: number; finished: boolean; place: number }[];
};

export type CompareTable = {
  metrics: { id: string; label: string; unit: string; definition: string; better: "lower" | "higher"; decimals: number }[];
  /** Of a single room. */
  bounds: { steps: number; turns: number; cost: number } | null;
  rows: {
    entrant: number;
    trials: number;
    missing: number;
    failure: string;
    values: ({ median: number; min: number; max: number } | null)[];
    best: boolean[];
  }[];
};

/** What there is to run many times (src/web/montecarlo.rs). */
export type RunsOffer = {
  entrants: { id: string; title: string; summary: string; kind: "planner" | "behaviour"; explores: boolean; number: number; params: ParamSpec[] }[];
  seeds: number[];
  minutes: number[];
};

/** Snapshot of many runs. Entrants are in the order of the offer. */
export type RunsView = {
  /** Changes whenever choices or results do. */
  version: number;
  running: boolean;
  done: number;
  total: number;
  seeds: number;
  minutes: number;
  entrants: { chosen: boolean; params: Record<string, string | number | boolean>; runs: number; failure: string }[];
};

/** Where and how all runs are made. */
export type RunsPlace = { room: string; robot: string; slip: string; noise: string; quantised: boolean };

export type Band = { low: number; median: number; high: number };

/** Many runs of one algorithm (src/app/montecarlo/summary.rs). */
export type RunsSummary = {
  runs: number;
  /** 0 to 1 */
  coverage: Band;
  /** When shares of the floor had been swept, or of the boundary met; `null` where too few runs got there in time. */
  time_to: { percent: number; reached: number; low_s: number | null; median_s: number | null; high_s: number | null }[];
  distance_m: Band;
  bumps: Band;
  falls: number;
  /** 0 to 1; `null` where there was no dirt. */
  dirt_left: Band | null;
};

/** One case of the benchmark (src/app/bench). */
export type BenchResult = {
  name: string;
  /** Median time of one run. */
  ms: number;
  /** For what stands for a time of the robot's: that time per time taken. */
  times_real_time: number | null;
  /** All memory that the module has had by then, 10^6 bytes; where it can tell. */
  memory_mb: number | null;
};

/** What the benchmark's worker says. */
export type FromBench =
  | { type: "result"; result: BenchResult }
  | { type: "finished"; results: BenchResult[] }
  | { type: "failed"; message: string };
