// Messages between the page and the worker of the tab Floor plan. What comes from Rust is in ../types.d.ts.
import type { DrawingTool, FloorPlanSettings, FloorPlanView } from "../types";
export * from "../types";

/** Requests of the page that are answered. */
export type Request =
  | { type: "open"; files: File[] }
  /** The floor plan can have been stored by another version, with other settings. */
  | { type: "restore"; files: File[]; settings: Partial<FloorPlanSettings> }
  | { type: "set"; settings: Partial<FloorPlanSettings> }
  | { type: "scale"; metres: number }
  | { type: "turn"; degrees: number }
  | { type: "sweep" }
  | { type: "slice"; heading: number }
  | { type: "export"; format: string }
  | { type: "room"; sweeps: boolean };

/** Messages of the page without an answer. */
export type Said =
  | { type: "tool"; tool: DrawingTool }
  | { type: "stages"; stages: number[]; moves: boolean }
  | { type: "pointer"; kind: string; x: number; y: number }
  | { type: "key"; action: string; fine: boolean }
  | { type: "pan"; dx: number; dy: number }
  | { type: "zoom"; x: number; y: number; factor: number }
  | { type: "fit" }
  | { type: "clear"; height: number }
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
