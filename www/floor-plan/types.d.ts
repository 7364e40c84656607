// Shapes of what crosses between the page, the worker of the tab Floor plan and Rust (src/app/draft writes and reads them).

export type Role = "wall" | "obstacle" | "ignored";
export type Tool = "view" | "scale" | "rectangle" | "polygon" | "room";

export type Body =
  | { kind: "model"; id: string }
  | { kind: "circle"; radius: number }
  | { kind: "rectangle"; length: number; width: number }
  | { kind: "octagon"; width: number }
  | { kind: "polygon"; corners: string };

/** The part of a drawing that is meant, in its unit. */
export type Part =
  | { kind: "whole" }
  | { kind: "rectangle"; corners: [[number, number], [number, number]] }
  | { kind: "polygon"; corners: [number, number][] }
  | { kind: "room"; at: [number, number] };

export type Settings = {
  /** Metres per unit of the drawing, or per cell of a map. */
  metre: number | null;
  roles: Role[];
  gap: number;
  resolution: number;
  part: Part;
  shade: number;
  negate: boolean;
  body: Body;
  scan_width: number | null;
  cell: number;
  headings: number;
};

/** Lengths in m, areas in m². */
export type FloorPlanView = {
  name: string;
  kind: "drawing" | "image" | "map";
  says_unit: boolean;
  is_scalable: boolean;
  size: string | null;
  units: { name: string; metre: number; size: string }[];
  layers: { name: string; colour: string; strokes: number; role: Role }[];
  strokes: number;
  left_out: string[];
  settings: Settings;
  room: { width_m: number; height_m: number; cells: [number, number]; floor_m2: number; resolution: number; objects: number; gaps: number } | null;
  /** Open doors through which a room that was marked reaches on; what closing gaps up to `gap` would leave. */
  doors: { count: number; gap: number; floor_m2: number } | null;
  fault: string;
  tool: Tool;
  points: number;
  is_measured: boolean;
  measured_m: number | null;
  body_width: number | null;
  body: [number, number][];
  body_fault: string;
  sweep: SweepView | null;
  /** How long the sweep took to be planned. */
  seconds: number;
  /** Stage of the sweep that is shown, 0 for none. */
  stage: number;
  /** Heading of the slice that is shown, -1 for none. */
  slice: number;
  words: string;
};

export type SweepView = {
  /** All of them; left and right wall; left and right obstacle. */
  subgoals: [number, number, number, number, number];
  links: number;
  collisions: number;
  resolved: number;
  length: number;
  coverage: number;
  scan_width: number;
};

/** What the page wants to be answered. */
export type Request =
  | { type: "open"; files: File[] }
  /** The floor plan may have been kept by another version, with other settings. */
  | { type: "restore"; files: File[]; settings: Partial<Settings> }
  | { type: "set"; settings: Partial<Settings> }
  | { type: "scale"; metres: number }
  | { type: "sweep" }
  | { type: "slice"; heading: number }
  | { type: "export"; format: string }
  | { type: "room"; sweeps: boolean };

/** What the page just says. */
export type Said =
  | { type: "tool"; tool: Tool }
  | { type: "stages"; stages: number[]; moves: boolean }
  | { type: "pointer"; kind: string; x: number; y: number }
  | { type: "key"; action: string; fine: boolean }
  | { type: "pan"; dx: number; dy: number }
  | { type: "zoom"; x: number; y: number; factor: number }
  | { type: "middle"; factor: number }
  | { type: "fit" }
  | { type: "resize"; width: number; height: number; ratio: number }
  | { type: "dark"; dark: boolean };

export type ToFloorPlan = { type: "init"; module: WebAssembly.Module; canvas: OffscreenCanvas } | Said | (Request & { id: number });

export type Exported = { name: string; media: string; bytes: Uint8Array };
export type FromFloorPlan =
  | { type: "view"; view: FloorPlanView | undefined }
  | { type: "progress"; done: number }
  | { type: "answer"; id: number; result: unknown; view: FloorPlanView | undefined }
  /** `view` is the floor plan as it still is. */
  | { type: "refusal"; id: number; message: string; view: FloorPlanView | undefined }
  /** It can't go on. */
  | { type: "broken"; message: string };
