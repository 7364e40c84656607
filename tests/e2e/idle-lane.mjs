// A lane that has only what other processes leave of the processor, with all browsers that it starts.
import { spawnSync } from "node:child_process";

// Where that can't be, run.mjs has nothing besides.
spawnSync("chrt", ["--all-tasks", "--idle", "--pid", "0", String(process.pid)]);
await import("./lane.mjs");
