// A screen that nobody sees, for browsers with windows.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { findProgram } from "./engine.mjs";

/** Starts one; its number, as programs want it, and what ends it. Needs Debian's xvfb. */
export async function startScreen() {
  const child = spawn(findProgram("Xvfb"), ["-displayfd", "3", "-screen", "0", "1440x900x24", "-nolisten", "tcp"], { stdio: ["ignore", "ignore", "ignore", "pipe"] });
  process.once("exit", () => child.kill());
  const [number] = await Promise.race([
    once(child.stdio[3], "data"),
    once(child, "exit").then(([code]) => Promise.reject(new Error(`Xvfb ended with ${code}`))),
  ]);
  return { display: `:${String(number).trim()}`, end: () => child.kill() };
}
