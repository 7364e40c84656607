// @ts-check
// Where the run rests: at breakpoints, and at the same time again after they were changed.
import { STEP } from "./stage.js";

export class Stops {
  #app;
  #run;
  /** Where a breakpoint paused: the steps after it, and its line. */
  #broke = { step: 0, line: 0 };
  /** The latest step that was shown while the run played. */
  #shown = 0;
  /** Where the run was before it was simulated again, s; 0 for nowhere. */
  #before = 0;

  /** @param {import("../main.js").App} app @param {import("./run.js").ProgramRun} run */
  constructor(app, run) {
    this.#app = app;
    this.#run = run;
  }

  /** The line of the breakpoint that paused at the time that is shown; 0 for none. */
  get line() {
    const { step, line } = this.#broke;
    return step === Math.round(this.#app.view.time_s / STEP) ? line : 0;
  }

  /** Another run begins. */
  forget() {
    this.#before = 0;
  }

  /** The same run is simulated again with other breakpoints: it then goes to the time that is shown now. @param {() => Promise<void>} start */
  async again(start) {
    const at = this.#before || this.#app.view.time_s;
    await start();
    this.#before = at;
  }

  /** In every frame. */
  frame() {
    const [before, { view }] = [this.#before, this.#app];
    if (before && this.#run.state === "running" && (view.program?.reach_steps ?? 0) * STEP >= before) {
      this.#app.act((p) => p.seek(before));
      this.#shown = Math.round(before / STEP);
      this.#before = 0;
    }
    if (this.#before) return;
    const [now, shown] = [Math.round(view.time_s / STEP), this.#shown];
    const isPassed = (/** @type {import("./types").Output} */ { kind, step = 0 }) => kind === "break" && step > shown && step <= now;
    const hit = view.state === "playing" && now > shown ? this.#run.said.all.find(isPassed) : undefined;
    this.#shown = now;
    if (!hit) return;
    // The line ran in the step that follows what it had read.
    const step = (hit.step ?? 0) + 1;
    this.#broke = { step, line: Number(hit.line) || 0 };
    this.#shown = step;
    this.#app.act((p) => (p.pause(), p.seek(step * STEP)));
  }
}
