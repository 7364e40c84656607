// @ts-check
// Where the run rests: at breakpoints, and at the same time again after they were changed.
import { STEP } from "./stage.js";

/** Steps in a frame when the same run is simulated again: a tenth of its time. */
const PART = 10_000;

export class Stops {
  #app;
  #run;
  /** Where a breakpoint paused: the steps after it, and its line. */
  #broke = { step: 0, line: 0 };
  /** The latest step that was shown while the run played. */
  #shown = 0;
  /** Where the run was before it is simulated again, steps; 0 for nowhere. */
  #before = 0;
  /** Whether it goes on from there. */
  #goesOn = false;

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
    this.#before = this.#broke.line = 0;
  }

  /** The same run is simulated again with other breakpoints, up to the time that is shown now. @param {() => Promise<void>} start Without playing. */
  async again(start) {
    const { time_s, state } = this.#app.view;
    if (!this.#before) this.#goesOn = state === "playing";
    const at = this.#before || Math.round(time_s / STEP);
    const begun = start();
    this.#before = at;
    await begun;
  }

  /** Goes on to where it was, a part in each frame. */
  #catchUp() {
    const { view } = this.#app;
    if (this.#run.state !== "running" || (view.program?.reach_steps ?? 0) < this.#before) return;
    const now = Math.round(view.time_s / STEP);
    const next = Math.min(this.#before, now + PART);
    this.#app.act((p) => {
      for (let step = now; step < next; step += 1) p.step();
    });
    this.#shown = next;
    if (next < this.#before) return;
    this.#before = 0;
    if (this.#goesOn) this.#app.act((p) => p.play());
  }

  /** In every frame. */
  frame() {
    if (this.#before) return this.#catchUp();
    const { view } = this.#app;
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
