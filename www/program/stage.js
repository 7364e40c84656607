// @ts-check
// The playground as a program's run sees it: it takes the program, its log and its plan.
import { Planning } from "../planning.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("../worker-types").PlanRequest} PlanRequest
 */

/** Length of a step, s. */
export const STEP = 0.015;

export class Stage {
  #app;
  /** The playground's version of what the log is for. */
  #version = -1;
  /** Its request for a plan. @type {PlanRequest | undefined} */
  #request;
  #began = 0;
  /** Whether the run was seen to stand since it was paused from here. */
  #isPaused = false;
  /** Rounds corners of plans, and proves how good they are. */
  #judge;

  /** @param {App} app */
  constructor(app) {
    this.#app = app;
    const none = () => {};
    this.#judge = new Planning({
      progress: none,
      finished: none,
      failed: none,
      smoothed: (id, knots) => void app.act((p) => p.plan_smoothed(id, knots)),
      proven: (id, proof, least) => void app.act((p) => p.plan_proven(id, proof, least)),
    });
  }

  /** How far the run is known, steps. */
  get reach() {
    return this.#app.view.program?.reach_steps ?? 0;
  }

  /** What is shown, steps. */
  get shown() {
    return Math.round(this.#app.view.time_s / STEP);
  }

  /** Whether somebody has the run play on since it was paused; once. */
  isResumed() {
    const [wasPaused, isPlaying] = [this.#isPaused, this.#app.view.state === "playing"];
    this.#isPaused = !isPlaying;
    if (isPlaying) this.changes();
    return wasPaused && isPlaying;
  }

  /** For the sandbox. */
  get job() {
    return this.#app.playground.program_job();
  }

  /** The program comes to the start of the room. @param {import("./own-programs.js").Program} program @param {"step" | "run" | "plan"} kind @param {boolean} plays @returns {boolean} Whether it was taken. */
  enter({ name, language, source }, kind, plays) {
    this.#request = undefined;
    if (!this.#app.act((p) => p.set_program(name, language, kind === "plan" ? "planner" : "behaviour", source, true))) return false;
    this.#app.act((p) => p.reset());
    if (plays) this.#app.act((p) => p.play());
    this.#app.view = this.#app.playground.view();
    this.#version = this.#app.view.program?.version ?? -1;
    return true;
  }

  /** Whether there is another room, seed or robot, or somebody's hand; once. */
  changes() {
    const before = this.#version;
    this.#version = this.#app.view.program?.version ?? -1;
    return before !== this.#version;
  }

  /** The next change counts, whatever it is. */
  forget() {
    this.#version = -1;
  }

  /** @param {Uint8Array} log */
  extend(log) {
    if (log.length) this.#app.act((p) => void p.extend_program(this.#version, log));
  }

  pause() {
    this.#isPaused = false;
    this.#app.act((p) => p.pause());
  }

  /** It wants a plan. @param {PlanRequest} request */
  ask(request) {
    this.#request = request;
  }

  get wantsPlan() {
    return this.#request !== undefined;
  }

  /** The planner starts. */
  planning() {
    this.#began = performance.now();
  }

  /** @param {Uint32Array} cells */
  planned(cells) {
    const [request, seconds] = [this.#request, (performance.now() - this.#began) / 1000];
    this.#request = undefined;
    if (!request) return;
    this.#app.act((p) => p.plan_finished(request.id, cells, seconds, undefined, undefined));
    if (this.#app.playground.view().state !== "failed") this.#judge.prove(request, cells);
  }

  /** There will be no plan. Before the program drives, what is on the floor is another's: it pauses. @param {string} why @param {boolean} [isEarly] */
  fail(why, isEarly) {
    if (isEarly) this.pause();
    const request = this.#request;
    this.#request = undefined;
    if (request) this.#app.act((p) => p.plan_failed(request.id, why));
  }
}
