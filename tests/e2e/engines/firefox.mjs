// Firefox without windows.
import { spawn } from "node:child_process";
import { once } from "node:events";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { createInterface } from "node:readline";
import { Engine, findProgram } from "./engine.mjs";
import { connect } from "./marionette.mjs";

export const firefoxPath = () => process.env.FIREFOX || findProgram("firefox-esr", "firefox");

/** Starts Firefox, by `executable` if given, with further preferences. */
export async function startFirefox({ executable = firefoxPath(), env = {}, preferences = {} } = {}) {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-firefox-"));
  // At any free port.
  const lines = Object.entries({ "marionette.port": 0, ...preferences }).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});`);
  fs.writeFileSync(path.join(profile, "user.js"), lines.join("\n"));
  const child = spawn(executable, ["--headless", "--no-remote", "--profile", profile, "--marionette", "--remote-allow-system-access"], {
    env: { ...process.env, HOME: profile, MOZ_HEADLESS_WIDTH: "1000", MOZ_HEADLESS_HEIGHT: "740", ...env },
    stdio: ["ignore", "pipe", "ignore"],
  });
  process.once("exit", () => child.kill());
  const port = await new Promise((resolve, reject) => {
    createInterface({ input: child.stdout }).on("line", (line) => {
      const found = /Marionette\s+INFO\s+Listening on port (\d+)/.exec(line);
      if (found) resolve(Number(found[1]));
    });
    child.once("error", reject);
    child.once("exit", (code, signal) => reject(new Error(`${executable} ended before it listened (${code ?? signal})`)));
  });
  const send = await connect(port);
  await send("NewSession");
  return new Engine(send, async () => {
    const ended = once(child, "exit");
    await send("Marionette:Quit", { flags: ["eForceQuit"] });
    await ended;
    fs.rmSync(profile, { recursive: true, force: true });
  });
}
