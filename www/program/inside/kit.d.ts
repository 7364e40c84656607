/** What a program is run with. */
export interface Kit {
  load: typeof import("../../../programs/javascript/runtime.js").load;
  parser: typeof import("@lezer/javascript").parser;
  micropython: { wasm: WebAssembly.Module; files: Record<string, string> } | undefined;
  /** Lets the next text be evaluated. */
  allowText: () => void;
  memory: WebAssembly.Memory;
  ProgramRunner: typeof import("../../../program.js").ProgramRunner;
  rooms: import("./rooms.js").Rooms;
  clock: () => number;
}
