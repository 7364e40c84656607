// Busy processes beside a test, to see whether it holds on a busy machine.
import { spawn } from "node:child_process";
import os from "node:os";
import { ends } from "../ends.mjs";

/** Starts this many busy processes per core, until the tests are over. */
export function underLoad(perCore) {
  const busy = Array.from({ length: perCore * os.availableParallelism() }, () => spawn(process.execPath, ["-e", "for (;;);"], { stdio: "ignore" }));
  if (busy.length > 0) ends.push(() => busy.forEach((one) => one.kill("SIGKILL")));
}
