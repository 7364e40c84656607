// What crosses between the page and the workers of its sandbox (www/program/inside/). The page trusts none of it.

export interface Output {
  kind: "print" | "mark" | "line" | "text" | "clear" | "lights" | "note" | "break";
  /** Steps before it. */
  step?: number;
  text?: string;
  x?: number;
  y?: number;
  x1?: number;
  y1?: number;
  x2?: number;
  y2?: number;
  colour?: string | number[] | null;
  line?: number;
}

/** A program and the run that it is for. */
export interface Load {
  type: "load";
  id: number;
  language: "python" | "javascript";
  source: string;
  /** Room, robot, conditions, seed and a person's inputs: the playground's `program_job`. */
  job: Uint8Array;
  /** Lines are followed: slower. */
  traced: boolean;
  breakpoints: { line: number; condition?: string }[];
  /** What is before that step is known: it is run again, and not reported. */
  from: number;
  /** In place of the job's. */
  seed?: number;
  /** Of a robot that isn't simulated, as JSON. */
  facts?: string;
  /** Only the whole log is of interest. */
  isQuiet?: boolean;
}

export type ToWorker =
  | Load
  /** Run until that step; with `inspect`, run or go back to it, then say line and variables. */
  | { type: "go"; id: number; until: number; inspect?: boolean }
  /** Let a planner plan. */
  | { type: "plan"; id: number }
  /** Answer to a robot's readings; `before` has those that it is to take first, without an answer. */
  | { type: "sense"; id: number; readings: Float64Array; before?: Float64Array[] };

export type FromWorker = (
  | { type: "ready" }
  /** All is there for the program, and its first line runs next. */
  | { type: "begins"; id: number }
  | { type: "loaded"; id: number; kind: "step" | "run" | "plan" }
  | { type: "busy"; id: number }
  | { type: "ran"; id: number; log: Uint8Array; digest: string; steps: number; output: Output[]; isOver: boolean }
  | { type: "drive"; id: number; left: number; right: number; isDone: boolean }
  | { type: "planned"; id: number; cells: Uint32Array; output: Output[] }
  | { type: "state"; id: number; step: number; line: number; variables: [name: string, text: string, type: string][] }
  | { type: "failed"; id: number; step: number; message: string; line: number; column: number }
) & {
  /** How many of the page's messages were heard. */
  heard?: number;
  /** Another message follows without being asked for. */
  more?: boolean;
};
