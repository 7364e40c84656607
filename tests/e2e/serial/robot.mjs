// A robot on a pseudo terminal: the emulator as a program of its own, and what it heard.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { ROOT } from "../browser.mjs";

/** Bytes of data behind each opcode; those behind 140, 148 and 149 say themselves how many they are. */
const DATA = { 129: 1, 136: 0, 137: 4, 138: 1, 139: 3, 141: 1, 142: 1, 144: 3, 145: 4, 146: 4, 150: 1, 162: 2, 163: 4, 164: 4, 165: 1, 167: 15, 168: 3 };

/** Seconds since 1970, as in the emulator's log. */
export const now = () => (performance.timeOrigin + performance.now()) / 1000;

let program;
/** The native program, built if it isn't. */
function robovac() {
  if (!program) {
    execFileSync("cargo", ["build", "--locked", "--quiet", "--bin", "robovac"], { cwd: ROOT, stdio: ["ignore", "ignore", "inherit"] });
    program = path.join(process.env.CARGO_TARGET_DIR ?? path.join(ROOT, "target"), "debug/robovac");
  }
  return program;
}

let robots = 0;

export class Robot {
  /** Where its terminal is while it is plugged in. */
  pty = path.join(os.tmpdir(), `robovac-e2e-${process.pid}-${robots++}`);
  #log = `${this.pty}.log`;
  #options;
  #child;

  /** Starts one for the test `t`. Options are those of `robovac virtual-roomba`. */
  static async start(t, ...options) {
    const robot = new Robot();
    robot.#options = options;
    t.after(async () => {
      await robot.unplug();
      fs.rmSync(robot.#log, { force: true });
    });
    await robot.plug();
    return robot;
  }

  async plug() {
    const stand_in = process.env.LINK_STAND_IN?.split(" ") ?? [robovac(), "virtual-roomba"];
    const [command, ...first] = stand_in;
    this.#child = spawn(command, [...first, "--pty", this.pty, "--log", this.#log, ...this.#options], { stdio: ["ignore", "pipe", "inherit"] });
    await new Promise((resolve, reject) => {
      this.#child.stdout.on("data", (text) => /^ready/m.test(text) && resolve());
      this.#child.once("exit", (code) => reject(new Error(`the emulator ended with ${code}`)));
    });
  }

  /** Pulls the cable out. What was in its buffers is lost. */
  async unplug() {
    if (this.#child?.exitCode === null && this.#child.signalCode === null) {
      const ended = new Promise((resolve) => this.#child.once("exit", resolve));
      this.#child.kill("SIGKILL");
      await ended;
    }
    fs.rmSync(this.pty, { force: true });
  }

  /** What it has heard so far, a command after the other: `{ time, opcode, data }`. */
  heard() {
    const bytes = [];
    for (const line of fs.existsSync(this.#log) ? fs.readFileSync(this.#log, "utf8").split("\n") : []) {
      const [time, hex] = line.split(" ");
      for (const byte of Buffer.from(hex ?? "", "hex")) bytes.push({ time: Number(time), byte });
    }
    const commands = [];
    for (let at = 0; at < bytes.length; ) {
      const { time, byte: opcode } = bytes[at];
      const announced = opcode === 140 ? 2 + 2 * (bytes[at + 2]?.byte ?? 0) : opcode === 148 || opcode === 149 ? 1 + (bytes[at + 1]?.byte ?? 0) : 0;
      const length = announced || (DATA[opcode] ?? 0);
      commands.push({ time, opcode, data: bytes.slice(at + 1, at + 1 + length).map(({ byte }) => byte) });
      at += 1 + length;
    }
    return commands;
  }

  forget() {
    fs.truncateSync(this.#log);
  }
}

/** Whether a command turns wheels or brushes. */
export function moves({ opcode, data }) {
  if ([137, 145, 146].includes(opcode)) return data.slice(0, opcode === 137 ? 2 : 4).some((byte) => byte !== 0);
  return [138, 144].includes(opcode) && data.some((byte) => byte !== 0);
}

/** Whether a command stops the wheels. */
export const stops = ({ opcode, data }) => [137, 145, 146].includes(opcode) && data.length === 4 && !moves({ opcode, data });

/** The first stop after which nothing moves any more, and that nothing does. */
export function lastStop(commands) {
  const last = commands.findLastIndex(moves);
  const stop = commands.find((command, index) => index > last && stops(command));
  assert.ok(stop, `no stop came after the last command to move: ${JSON.stringify(commands.slice(-5))}`);
  return stop;
}
