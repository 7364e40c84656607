// @ts-check
// The tab Program: an editor beside the floor of Explore, and the program that runs on it.
import { button, byId, make, select, setHidden, setText } from "../dom.js";
import { clock } from "../format.js";
import { tellMore } from "../explore/more-events.js";
import { complain, textOf, toast } from "../messages.js";
import { settingsOf } from "../settings-link.js";
import { planWith } from "../start-planning.js";
import { currentTab } from "../tabs.js";
import { Editor } from "./editor.js";
import { packProgram, shareProgram, unpackProgram } from "./link.js";
import { startMarks } from "./marks.js";
import { startNames } from "./names.js";
import { find, isOwn, remember, remembered } from "./own-programs.js";
import { startPlace } from "./place.js";
import { ProgramRun } from "./run.js";
import { closeSheet, openSheet } from "./sheet.js";
import { Shelf } from "./shelf.js";
import { STEP } from "./stage.js";
import { Stops } from "./stops.js";
import { Watch } from "./watch.js";

/** @typedef {import("./own-programs.js").Program} Program */

/** There, Run has a key. */
const BY_KEY = matchMedia("(any-pointer: fine)").matches ? `, or ${/Mac/.test(navigator.platform) ? "⌘" : "Ctrl"}+Enter` : "";

/** @param {import("../main.js").App} app */
export async function startProgram(app) {
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  /** Whether the program on the page came from elsewhere and wasn't run by hand yet. */
  let isHeld = false;
  const editor = new Editor(byId("program-editor"), { changed: () => edited(), run: () => byHand(), stop: () => run.stop(), marked: () => void marked() });
  const run = new ProgramRun(app, () => show());
  /** Where it failed, the line of the fault is marked. */
  const hasFailed = () => run.fault !== undefined && app.view.time_s >= run.fault.step * STEP - 1e-6;
  const watch = new Watch(app, run, (line) => editor.light(hasFailed() ? 0 : (line && stops.line) || line));
  const stops = new Stops(app, run);
  const tellNames = startNames(() => editor.language);
  const shelf = await new Shelf({
    open(program) {
      const isOther = program.id !== run.program?.id || program.source !== editor.text;
      if (!isOther) return;
      editor.open(program.source, program.language);
      remember(program.id);
      isHeld = program.isForeign === true;
      app.isUnrun = false;
      if (isHeld || run.state !== "idle") run.stop();
      run.state = "idle";
      watch.clear();
      tellNames();
      show();
      if (!isHeld && isOpened) void start(!calm);
    },
    share: () => void import("../explore/share.js").then(({ copyLink }) => copyLink(app)).catch((error) => complain(textOf(error))),
  }).begin();
  /** Until the first program is chosen, nothing runs. */
  let isOpened = false;

  /** @param {boolean} plays */
  const start = async (plays) => {
    const program = shelf.current;
    if (!program) return;
    isHeld = app.isUnrun = false;
    stops.forget();
    run.breakpoints = editor.breakpoints;
    watch.clear();
    await run.start({ ...program, source: editor.text }, plays);
  };
  const byHand = () => {
    closeSheet();
    void start(true);
  };
  const edited = () => {
    app.isUnrun = true;
    shelf.edit(editor.text);
  };
  /** Breakpoints hold from now on. */
  const marked = () => (run.state === "running" || run.state === "stopped") && stops.again(() => start(false));

  const show = () => {
    const { state, fault, program } = run;
    setHidden(byId("program-foreign"), !isHeld);
    button("program-stop").disabled = state !== "running" && state !== "loading";
    const error = byId("program-error");
    error.hidden = !fault;
    if (fault) {
      const go = fault.line ? [make("button", { type: "button", onclick: () => (editor.show(fault.line), editor.focus()) }, `Line ${fault.line}`)] : [];
      error.replaceChildren(...go, fault.message);
    }
    editor.complain(fault && program?.id === shelf.current?.id ? fault : undefined);
    if ((isHeld || fault) && currentTab() === "program") openSheet();
  };

  button("program-run").addEventListener("click", byHand);
  button("program-stop").addEventListener("click", () => run.stop());
  planWith((request) => run.plan(request));
  startPlace();
  // By its button, or by a link: then the address says which program.
  document.addEventListener("tab", () => currentTab() === "program" && enter(location.hash.includes("tab=program") ? location.hash.slice(1) : ""));
  const draw = startMarks(app, run);
  tellMore(
    () => run.said.version,
    () => (app.view.program ? run.said.all.filter(({ kind }) => kind === "print").map(({ step = 0, text }) => ({ time: step * STEP, text: String(text ?? ""), felt: false })) : []),
  );

  /** In words, what goes on. */
  const status = () => {
    const { view } = app;
    const at = run.fault ? ` at ${clock(run.fault.step * STEP)}` : "";
    if (isHeld) return "Not run yet: read it first";
    if (app.isUnrun) return `Changed: press Run${BY_KEY}`;
    if (run.state === "loading") return shelf.current?.language === "python" ? "Loading Python…" : "Loading…";
    if (run.state === "failed") return run.fault?.isEarly ? "Not started" : `Ended by an error${at}`;
    if (run.state === "stopped") return "Stopped";
    if (run.state === "idle" || !view.program) return "";
    if (view.program.end === "done") return `Ends at ${clock((view.program.reach_steps ?? 0) * STEP)}`;
    if (view.state === "paused" && stops.line) return `Stopped at the breakpoint in line ${stops.line}: press play to continue`;
    return view.program.waits ? "Waiting for the program…" : `Change a number, then press Run${BY_KEY}`;
  };

  // Explore shows the run, too.
  const frame = () => {
    requestAnimationFrame(frame);
    run.frame();
    draw();
    stops.frame();
    if (isHeld && currentTab() === "program" && app.view.state === "playing") app.act((p) => p.pause());
    if (currentTab() !== "program") return;
    setText(byId("program-status"), status());
    const printed = app.view.program && run.said.printed(Math.round(app.view.time_s / STEP));
    setHidden(byId("program-printed"), !printed);
    if (printed) setText(byId("program-printed"), `Printed: ${String(printed.text ?? "").slice(0, 200)}`);
    watch.frame();
  };
  requestAnimationFrame(frame);

  /** Opens the program of a link, else the last one, else the first. @param {string} link */
  const open = async (link) => {
    const pairs = new URLSearchParams(link);
    const [id, code] = [pairs.get("script") ?? "", pairs.get("code")];
    try {
      const own = isOwn(id) ? find(id) : undefined;
      if (code && !(own && (await packProgram(own)) === code)) return shelf.add(await unpackProgram(code));
      if (id && id === shelf.current?.id) return;
      if (id && (await shelf.choose(id))) return;
      if (shelf.current) return;
      if (!(await shelf.choose(remembered()))) await shelf.choose(shelf.first);
    } catch (error) {
      complain(textOf(error));
      if (!shelf.current) await shelf.choose(shelf.first);
    }
  };

  /** The tab is shown: a program runs, unless it waits to be read. @param {string} link */
  const enter = async (link) => {
    isOpened = true;
    await open(link);
    if (isHeld || (run.state !== "idle" && app.view.program)) return;
    // What drove until now begins anew when it is chosen again.
    const before = app.view.program ? undefined : select("algorithm").selectedOptions[0]?.text;
    await start(!calm);
    if (before && app.view.program) toast(`Your program drives now, instead of ${before}.`);
  };

  return {
    frame() {},
    key: () => false,
    link: () => `tab=program${shelf.current ? `&script=${encodeURIComponent(shelf.current.id)}` : ""}`,
    /** What a link carries to others. */
    async share() {
      const program = shelf.current;
      return program ? shareProgram({ ...program, source: editor.text }) : "";
    },
    /** @param {string} link */
    restore: (link) => void enter(link),
    /** Keeps the program of a link for a session that says that it drives; another tab may be shown. @param {string} link */
    async hold(link) {
      await open(link);
      const program = shelf.current;
      const kind = settingsOf(link).get("planner") === "program_planner" ? "planner" : "behaviour";
      if (!program) return;
      app.act((p) => p.set_program(program.name, program.language, kind, program.source, false));
      if (!isHeld) run.adopt(program);
      else if (!isOpened) complain("A program drives in this link. Read it in the tab Program, then press Run there.");
    },
    setDark() {},
    /** @param {File[]} files */
    take: (files) => shelf.take(files),
  };
}
