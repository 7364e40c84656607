// @ts-check
// The variables of the program and the line that ran, at the time that is shown: the same program runs once more in a worker
// of its own, followed line by line, up to that step.
import { byId, changed, make, setHidden, setText, typed } from "../dom.js";
import { clock } from "../format.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { kitFor } from "./kit.js";
import { STEP } from "./run.js";
import { Inmate } from "./sandbox.js";

/** Least time between looks while the run plays, ms. */
const PAUSE = 200;
/** Farthest that is looked at while it plays, steps ahead of the last look: beyond, the table waits until it is paused. */
const FAR = 20_000;

export class Watch {
  #app;
  #run;
  #light;
  /** @type {Inmate | undefined} */
  #inmate;
  #hasPython = false;
  #order = 0;
  /** What the worker runs: program and version. */
  #loaded = "";
  /** The step that it is at, and the one that was asked for; -1 for none. */
  #at = 0;
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
    this.#inmate?.end();
    this.#inmate = undefined;
    this.#asked = -1;
    this.#loaded = "";
    this.#show([], 0);
    this.#light(0);
  }

  /** @param {string} key @param {number} step */
  async #ask(key, step) {
    const program = this.#run.program;
    if (!program) return;
    this.#asked = step;
    const isPython = program.language === "python";
    try {
      if (!this.#inmate?.isAlive || (isPython && !this.#hasPython)) {
        this.#inmate?.end();
        const kit = await kitFor(program.language);
        this.#hasPython = isPython;
        this.#loaded = "";
        const failed = () => ((this.#asked = -1), (this.#at = step));
        this.#inmate = new Inmate(kit, (message) => this.#hear(message), failed);
      }
    } catch (error) {
      this.#asked = -1;
      this.#at = step;
      return console.warn(error);
    }
    const { playground } = this.#app;
    if (key !== this.#loaded || step < this.#at) {
      this.#loaded = key;
      this.#order += 1;
      const { language, source } = program;
      this.#inmate.ask({ type: "load", id: this.#order, language, source, job: playground.program_job(), traced: true, breakpoints: [], from: 0 });
    }
    this.#inmate.ask({ type: "go", id: this.#order, until: step, inspect: true });
  }

  /** @param {import("./types").FromWorker} message */
  #hear(message) {
    if (!("id" in Object(message)) || /** @type {{ id: number }} */ (message).id !== this.#order) return;
    if (message.type === "failed") {
      this.#at = this.#asked;
      this.#asked = -1;
    }
    if (message.type !== "state") return;
    this.#at = this.#asked = Number(message.step);
    this.#asked = -1;
    const { view } = this.#app;
    if (view.state !== "playing") this.#light(Number(message.line) || 0);
    if (Array.isArray(message.variables)) this.#show(message.variables, this.#at);
  }

  /** @param {[name: string, text: string, type: string][]} variables @param {number} step */
  #show(variables, step) {
    setHidden(byId("program-no-variables"), variables.length > 0);
    setText(byId("program-moment"), variables.length ? `at ${clock(step * STEP)}, step ${step.toLocaleString("en")}` : "");
    const rows = variables.map(([name, text, type]) => {
      const [key, value] = [String(name).slice(0, 60), String(text).slice(0, 200)];
      const isNew = this.#known.has(key) && this.#known.get(key) !== value;
      return make("tr", { className: isNew ? "changed" : "" }, make("th", { scope: "row", title: String(type).slice(0, 40) }, key), make("td", { title: value }, value));
    });
    this.#known = new Map(variables.map(([name, text]) => [String(name).slice(0, 60), String(text).slice(0, 200)]));
    byId("program-variables").replaceChildren(...rows);
  }
}
