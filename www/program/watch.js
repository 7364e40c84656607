// @ts-check
// The variables of the program and the line that ran, at the time that is shown: the same program runs once more in a worker
// of its own, followed line by line, up to that step or back to it.
import { byId, changed, make, setHidden, setText, typed } from "../dom.js";
import { clock } from "../format.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { THINKING } from "./doubt.js";
import { Hired } from "./hired.js";
import { STEP } from "./stage.js";

/** Least time between looks while the run plays, ms. */
const PAUSE = 200;
/** Farthest that is looked at while it plays, steps ahead of the last look: beyond, the table waits until it is paused. */
const FAR = 20_000;

export class Watch {
  #app;
  #run;
  #light;
  #hired = new Hired((message) => this.#hear(message), () => this.#done());
  #order = 0;
  /** What the worker runs: program and version. */
  #loaded = "";
  /** The step that it is at, and the one that was asked for; -1 for none. */
  #at = -1;
  #asked = -1;
  #isDue = atMostEvery(PAUSE);
  /** @type {Map<string, string>} */
  #known = new Map();

  /** @param {import("../main.js").App} app @param {import("./run.js").ProgramRun} run @param {(line: number) => void} light */
  constructor(app, run, light) {
    this.#app = app;
    this.#run = run;
    this.#light = light;
  }

  /** In every frame. */
  frame() {
    const { view } = this.#app;
    const { program, state } = this.#run;
    const isOpen = typed("program-watch", HTMLDetailsElement).open;
    if (!program || !view.program || view.program.reach_steps === null || state === "loading" || state === "idle") return this.#light(0);
    const isPlaying = view.state === "playing";
    // While it plays, the lit line would only flicker: the table alone is kept, and only where it is open.
    if (isPlaying && !isOpen) return this.#light(0);
    const step = Math.min(Math.round(view.time_s / STEP), view.program.reach_steps);
    const key = `${program.id} ${view.program.version}`;
    if (this.#asked >= 0 || !this.#isDue(() => changed(byId("program-watch"), "moment", `${key} ${step}`) || this.#at !== step)) return;
    if (isPlaying && key === this.#loaded && step - this.#at > FAR) return;
    void this.#ask(key, step);
  }

  /** Forgets the program. */
  clear() {
    this.#hired.end();
    this.#at = this.#asked = -1;
    this.#show([], 0);
    this.#light(0);
  }

  /** The answer is there, or won't come. */
  #done() {
    this.#at = this.#asked;
    this.#asked = -1;
  }

  /** @param {string} key @param {number} step */
  async #ask(key, step) {
    const program = this.#run.program;
    if (!program) return;
    this.#asked = step;
    const { language, source } = program;
    try {
      const isNew = !this.#hired.inmate || key !== this.#loaded;
      const inmate = await this.#hired.of(language);
      if (this.#asked !== step) return;
      if (isNew) {
        this.#loaded = key;
        this.#order += 1;
        inmate.ask({ type: "load", id: this.#order, language, source, job: this.#app.playground.program_job(), traced: true, breakpoints: [], from: 0 }, THINKING);
      }
      inmate.ask({ type: "go", id: this.#order, until: step, inspect: true }, THINKING);
    } catch (error) {
      this.#done();
      console.warn(error);
    }
  }

  /** @param {import("./types").FromWorker} message */
  #hear(message) {
    if (!("id" in Object(message)) || /** @type {{ id: number }} */ (message).id !== this.#order || this.#asked < 0) return;
    const isIdle = message.type === "busy" && message.more !== true;
    if (isIdle || message.type === "failed" || message.type === "state") this.#done();
    if (message.type !== "state") return;
    if (this.#app.view.state !== "playing") this.#light(Number(message.line) || 0);
    if (Array.isArray(message.variables)) this.#show(message.variables, Number(message.step) || 0);
  }

  /** @param {[name: string, text: string, type: string][]} variables @param {number} step */
  #show(variables, step) {
    setHidden(byId("program-no-variables"), variables.length > 0);
    setText(byId("program-no-variables"), step ? "This program has no variables that last from step to step." : "Run the program to see its variables.");
    // Where it rests, a digest to compare with `robovac run`.
    const digest = this.#app.view.state !== "playing" && Math.round(this.#app.view.time_s / STEP) === step ? this.#app.playground.digest() : undefined;
    setText(byId("program-moment"), variables.length || step ? `at ${clock(step * STEP)}, step ${step.toLocaleString("en")}` : "");
    setText(byId("program-digest"), digest ? `Digest ${digest}` : "");
    setHidden(byId("program-digest"), !digest);
    const rows = variables.map(([name, text, type]) => {
      const [key, value] = [String(name).slice(0, 60), String(text).slice(0, 200)];
      const isNew = this.#known.has(key) && this.#known.get(key) !== value;
      return make("tr", { className: isNew ? "changed" : "" }, make("th", { scope: "row", title: String(type).slice(0, 40) }, key), make("td", { title: value }, value));
    });
    this.#known = new Map(variables.map(([name, text]) => [String(name).slice(0, 60), String(text).slice(0, 200)]));
    byId("program-variables").replaceChildren(...rows);
  }
}
