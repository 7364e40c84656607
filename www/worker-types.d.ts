// Messages between the page and its workers. What comes from Rust is in types.d.ts.
import type { BenchResult, SessionSnapshot } from "./types";

/** A planning request, the result of `take_plan_request` and the argument of `plan`. */
export type PlanRequest = { id: number; planner: string; bytes: Uint8Array; place?: import("./types").SessionSnapshot };

/** A run to be written as a bag: of Explore, or of the Map tab with its link and stored state. */
export type BagRequest = { snapshot: SessionSnapshot } & ({ corners: Float64Array; knots: Float64Array; inputs: Float64Array; end_s: number; log?: Uint8Array | undefined } | { link: string; stored: string; log?: Uint8Array | undefined });

/** A path from a worker, x, y, x, y, ...: the cells of a walk, or the corners of a path in metres. */
export type WirePath = Uint32Array | Float64Array;

/** A trajectory with rounded corners, if there is one. */
export type Knots = Float64Array | undefined;

/** Pictures of a film, the argument of `plan_filmed`. */
export type FilmPictures = unknown[] | undefined;

/** Messages to and from the planning worker. */
export type ToWorker =
  | { type: "init"; module: WebAssembly.Module }
  | { type: "plan"; request: PlanRequest }
  | { type: "prove"; request: PlanRequest; cells: WirePath; proof: Proof | undefined; frames: unknown[] }
  | { type: "trial"; request: { id: number } }
  | { type: "runs"; request: { id: number } }
  | { type: "fit"; request: { id: number; snapshot: import("./types").SessionSnapshot; percent: number } }
  | { type: "trade-off"; request: { id: number; snapshot: SessionSnapshot; corners: Float64Array; shares: Float64Array } }
  | { type: "bag"; request: { id: number } & BagRequest }
  | { type: "read"; request: { id: number; files: { name: string; bytes: Uint8Array }[] } }
  | { type: "flat"; request: { id: number; flat: string } };
/** Cost of a plan, and its lower bound. */
export type Proof = Float64Array;
export type FromWorker =
  | { type: "progress"; id: number; done: number; cells: WirePath; proof: Proof | undefined; frames: unknown[] }
  /** The planner's own proof; the proof in the weights of comparisons comes later. */
  | { type: "finished"; id: number; cells: WirePath; seconds: number; trace: Uint8Array; proof: Proof | undefined; knots: Knots; film: FilmPictures }
  /** What was rounded of a plan that was kept, and its film. */
  | { type: "smoothed"; id: number; knots: Knots }
  | { type: "filmed"; id: number; film: FilmPictures }
  /** `least`: length and time of any path that sweeps as much. */
  | { type: "proven"; id: number; proof: Proof | undefined; least: Float64Array | undefined }
  | { type: "failed"; id: number; message: string };

export type FromTrial =
  | { type: "progress"; id: number; done: number; cells: WirePath }
  | { type: "tried"; id: number; cells: WirePath; numbers: unknown; knots: Knots }
  | { type: "failed"; id: number; message: string };

/** Outcomes of runs, the argument of `MonteCarlo.batch_finished`. */
export type FromRuns = { type: "ran"; id: number; outcomes: Float64Array } | { type: "failed"; id: number; message: string };

/** `map`: as `read_map` has read it, or `flat` made it. */
export type FromReader = { type: "read"; id: number; map: Uint8Array } | { type: "failed"; id: number; message: string };

/** Planning cells for a coverage, as `fit_cells` answers. */
export type FromFit = { type: "fitted"; id: number; cells: Float64Array } | { type: "failed"; id: number; message: string };
/** `point`: asked, coverage, seconds, metres. */
export type FromTradeOff = { type: "point"; id: number; point: Float64Array } | { type: "traded"; id: number } | { type: "failed"; id: number; message: string };
export type FromBag = { type: "bagged"; id: number; bytes: Uint8Array } | { type: "failed"; id: number; message: string };

/** Messages of the benchmark's worker. */
export type FromBench =
  | { type: "result"; result: BenchResult }
  | { type: "finished"; results: BenchResult[] }
  | { type: "failed"; message: string };
