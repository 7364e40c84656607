// A robot on a pseudo terminal: the emulator as a program of its own, and what it heard.
import assert from "node:assert/strict";
import { execFileSync, spawn, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { ROOT } from "../browser.mjs";

/** Seconds since 1970, as in the emulator's log. */
export const now = () => (performance.timeOrigin + performance.now()) / 1000;

let program;
/** The native program: $ROBOVAC, or built if it isn't. */
export function robovac() {
  program ??= process.env.ROBOVAC;
  if (!program) {
    execFileSync("cargo", ["build", "--locked", "--quiet", "--bin", "robovac"], { cwd: ROOT, stdio: ["ignore", "ignore", "inherit"] });
    program = path.join(process.env.CARGO_TARGET_DIR ?? path.join(ROOT, "target"), "debug/robovac");
  }
  return program;
}

/**
 * What starts the emulator: before all other programs, where that is permitted, as a robot has a processor of its own. On a busy
 * machine it would be late itself, and with it every time in its log.
 */
let first;
const ownProcessor = () => (first ??= spawnSync("chrt", ["--fifo", "1", "true"]).status === 0 ? ["chrt", "--fifo", "1"] : []);

let robots = 0;

export class Robot {
  /** Where its terminal is while it is plugged in. */
  pty = path.join(os.tmpdir(), `robovac-e2e-${process.pid}-${robots++}`);
  #log = `${this.pty}.log`;
  #child;
  #forgotten = 0;

  /** Starts one for the test `t`. Options are those of `robovac virtual-roomba`. */
  static async start(t, ...options) {
    const robot = new Robot();
    const [command, ...before] = [...ownProcessor(), robovac()];
    robot.#child = spawn(command, [...before, "virtual-roomba", "--control", "--pty", robot.pty, "--log", robot.#log, ...options], { stdio: ["pipe", "pipe", "inherit"] });
    const ended = new Promise((resolve) => robot.#child.once("exit", resolve));
    t.after(async () => {
      robot.#child.kill();
      await ended;
      fs.rmSync(robot.#log, { force: true });
    });
    await new Promise((resolve, reject) => {
      robot.#child.stdout.on("data", (text) => /^ready/m.test(text) && resolve());
      ended.then((code) => reject(new Error(`the emulator ended with ${code}`)));
    });
    return robot;
  }

  /** Gives it an order; see `robovac virtual-roomba --help`. */
  order(text) {
    this.#child.stdin.write(`${text}\n`);
  }

  /** Pulls the cable out of the computer. The robot goes on with what it does. */
  unplug() {
    this.order("unplug-line");
    return this.#until(() => !fs.existsSync(this.pty));
  }

  plug() {
    this.order("replug-line");
    return this.#until(() => fs.existsSync(this.pty));
  }

  async #until(holds) {
    const patience = performance.now() + 15_000;
    while (!holds()) {
      assert.ok(performance.now() < patience, `waited in vain for ${holds}: ${JSON.stringify(this.heard().slice(-5))}`);
      await new Promise((later) => setTimeout(later, 5));
    }
  }

  /** Waits until this is what it has heard last; its log is a little behind. */
  hears(opcode) {
    return this.#until(() => this.heard().at(-1)?.opcode === opcode);
  }

  /** Waits until a command has moved it. */
  drives() {
    return this.#until(() => this.heard().some(moves));
  }

  /** Waits until it has heard this since a command moved it last. @param {number} opcode */
  hearsAfterMoving(opcode) {
    return this.#until(() => {
      const heard = this.heard();
      return heard.slice(heard.findLastIndex(moves) + 1).some((command) => command.opcode === opcode);
    });
  }

  /** Waits until it stands still. */
  rests() {
    return this.#until(() => this.isAtRest());
  }

  /** A line of the log after the other: time in s, kind, and the rest as words. */
  #lines() {
    return fs
      .readFileSync(this.#log, "utf8")
      .split("\n")
      .slice(0, -1)
      .map((line) => line.split(" "))
      .map(([, clock_ms, kind, ...words]) => ({ time: Number(clock_ms) / 1000, kind, words }));
  }

  /** The received commands in order: `{ time, opcode, data }`. */
  heard() {
    const commands = this.#lines().filter(({ kind }) => kind === "command" || kind === "ignored");
    return commands.slice(this.#forgotten).map(({ time, words }) => {
      const [opcode, ...data] = words.map(Number);
      return { time, opcode, data };
    });
  }

  /** Discards the commands received so far. */
  forget() {
    this.#forgotten += this.heard().length;
  }

  /** Whether it is commanded to stand still, and does. */
  isAtRest() {
    const { words } = this.#lines().findLast(({ kind }) => kind === "wheels") ?? { words: [] };
    return /^asked left -?0 right -?0 mm\/s, at rest$/.test(words.join(" "));
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
