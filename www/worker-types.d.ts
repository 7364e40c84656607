// Messages between the page and its workers. What comes from Rust is in types.d.ts.
import type { BenchResult } from "./types";

/** What has to be planned, as `take_plan_request` gives it and `plan` takes it. */
export type PlanRequest = { id: number };

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

/** A map as `read_map` has read it. */
export type ReadMap = { name: string; width: number; cells: Uint8Array };

export type FromReader = { type: "read"; id: number; map: ReadMap } | { type: "failed"; id: number; message: string };

/** What the benchmark's worker says. */
export type FromBench =
  | { type: "result"; result: BenchResult }
  | { type: "finished"; results: BenchResult[] }
  | { type: "failed"; message: string };
