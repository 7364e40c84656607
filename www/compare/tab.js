// @ts-check
// The tab Compare: the entrants, the progress of trials, and the current view of them.
import { Comparison, SessionMirror } from "../../workshop.js";
import { startAbout } from "./about.js";
import { button, byId, input, select, setHidden, setText } from "../dom.js";
import { startExports } from "./exports.js";
import { clock } from "../format.js";
import { startMirror } from "../session-mirror.js";
import { startNumbers } from "./numbers.js";
import { complain, textOf } from "../messages.js";
import { Pool } from "./pool.js";
import { raceProgram, startRace } from "./race.js";
import { startRuns } from "./montecarlo.js";
import { startSetup, updateSetup } from "./setup.js";

/**
 * @typedef {import("../types").ComparisonView} CompareView
 * @typedef {import("../main.js").App} App
 * @typedef {object} Comparing What the modules of this tab share.
 * @property {App} app
 * @property {Comparison} comparison
 * @property {CompareView} view
 * @property {(what: (comparison: Comparison) => void) => boolean} act
 * @property {(entrant: number) => void} about Shows an algorithm's description and path.
 */

/** @typedef {"race" | "numbers" | "runs" | "study"} ViewName The views of this tab. @type {ViewName[]} */
const VIEWS = ["race", "numbers", "runs", "study"];
/** Most workers that try planners: each holds a room and a planner's memory. */
const MOST_WORKERS = 6;

/**
 * @param {App} app
 * @param {WebAssembly.Module} module
 * @param {(what: () => void) => boolean} guard
 */
export function startCompare(app, module, guard) {
  const mirror = startMirror(app, new SessionMirror());
  const comparison = new Comparison();
  /** @type {Comparing} */
  const it = {
    app,
    comparison,
    view: comparison.view(),
    act: (what) => app.act(() => what(comparison)),
    about: () => {},
  };
  it.about = startAbout(it);
  const pool = new Pool(module, trialsOf(comparison, () => app.playground.program()), guard);
  startSetup(it);
  for (const name of VIEWS) button(`view-${name}`).addEventListener("click", () => showView(name));
  byId("to-explore").addEventListener("click", (event) => {
    event.preventDefault();
    byId("tab-explore").click();
  });
  const race = startRace(it);
  const numbers = startNumbers(it);
  const runs = startRuns(app, module, guard, mirror);
  const plans = { name: "comparison", csv: () => comparison.csv(), json: () => comparison.json(), charts: byId("charts"), get place() { return byId("compare-place").textContent ?? ""; } };
  /** @type {typeof import("./study.js") | undefined} */
  let study;
  /** Shows the results of a study. @param {Iterable<File>} files */
  const take = async (files) => {
    const file = [...files].find(({ name }) => /\.parquet$/i.test(name));
    if (!file) return;
    try {
      study ??= await import("./study.js");
      await study.openStudy(file);
      showView("study");
      study.show();
    } catch (error) {
      complain(textOf(error));
    }
  };
  const picker = input("study-file");
  button("study-open").addEventListener("click", () => picker.click());
  picker.addEventListener("change", () => void take(picker.files ?? []).then(() => (picker.value = "")));
  startExports(app, () => (shownView() === "runs" ? runs.exported : shownView() === "study" && study ? study.exported() : plans));

  /** Whether the race starts as soon as all have lined up. */
  let starts = false;

  return {
    /** Once a frame while the tab is shown. @param {number} now */
    frame(now) {
      updatePlace(it);
      // What isn't an error is about the robot in Explore.
      const said = app.view.message_kind === "error" ? app.view : { message: "", message_kind: "" };
      if (shownView() === "study") return said;
      if (shownView() === "runs") {
        runs.frame();
        return said;
      }
      comparison.take(mirror());
      pool.tend();
      raceProgram(app, comparison);
      comparison.frame(now);
      it.view = comparison.view();
      const { race: lineUp, done, total } = it.view;
      if (starts && lineUp && lineUp.lanes.length > 0 && done >= total) {
        starts = false;
        it.act((c) => c.play());
      }
      updateSetup(it);
      if (shownView() === "race") race.update(it.view);
      else numbers.update(it.view);
      return said;
    },
    /** @param {string} link */
    restore(link) {
      for (const part of [comparison, runs]) {
        try {
          part.restore(link);
        } catch (error) {
          // Not by `act`, which would take back what another part of the link was refused for.
          complain(textOf(error));
        }
      }
      const pairs = new URLSearchParams(link);
      numbers.restore(pairs);
      const wanted = pairs.get("view");
      starts = pairs.has("go") && !matchMedia("(prefers-reduced-motion: reduce)").matches;
      // A link has no file.
      showView(VIEWS.find((name) => name === wanted && name !== "study") ?? "race");
    },
    link: () => `tab=compare&view=${shownView()}&${comparison.link()}${shownView() === "runs" ? `&${runs.link()}` : ""}${shownView() === "numbers" ? numbers.link() : ""}`,
    take,
    /** A single key, space for one. @param {string} key */
    key: (key) => shownView() === "race" && race.key(key),
    /** @param {boolean} dark */
    setDark: (dark) => comparison.set_dark(dark),
  };
}

/** @returns {ViewName} */
const shownView = () => VIEWS.find((name) => name === byId("panel-compare").dataset.view) ?? "race";

/** @param {ViewName} view */
function showView(view) {
  byId("panel-compare").dataset.view = view;
  for (const name of VIEWS) byId(`view-${name}`).setAttribute("aria-pressed", String(name === view));
}

/** The trials of a comparison as work for workers. @param {Comparison} comparison @param {import("./pool.js").Source["program"]} program @returns {import("./pool.js").Source} */
const trialsOf = (comparison, program) => ({
  program,
  type: "trial",
  most: MOST_WORKERS,
  take: () => comparison.take_trial(),
  isWanted: (id) => comparison.is_wanted(id),
  answered: (answer) => {
    if (answer.type === "progress") comparison.trial_progress(answer.id, answer.done);
    else if (answer.type === "tried") comparison.trial_finished(answer.id, answer.cells, answer.numbers, answer.knots);
    else if (answer.type === "failed") comparison.trial_failed(answer.id, answer.message);
  },
  failed: (id, message) => comparison.trial_failed(id, message),
});

/** Where all of it happens. @param {Comparing} it */
function updatePlace({ app: { playground, catalogue, view: session }, view: { set, sets, rooms, race } }) {
  const { room, robot, own_robot: own, twin, cell_size_m, seed, slip } = session;
  // The race is in one room all the same.
  const several = shownView() === "numbers" && rooms.length > 1 ? sets.find(([id]) => id === set)?.[1] : undefined;
  const place = several ? `${several} (${rooms.length})` : room.title;
  setText(byId("compare-room"), place);
  const title = own || twin ? playground.robot().title : catalogue.robots.find(({ id }) => id === robot)?.title;
  setHidden(byId("race-estimate"), slip === "none");
  const slips = slip === "none" ? "" : `, ${slip} wheel slip${shownView() === "runs" ? "" : " in the race"}`;
  const size = several ? "" : `${room.width_m.toFixed(1)} × ${room.height_m.toFixed(1)} m, `;
  // Each of many runs has its own.
  const seeds = shownView() === "runs" ? "" : `, seed ${seed}`;
  const where = `${size}${title}, cells of ${+(cell_size_m * 100).toFixed(1)} cm${seeds}${slips}.`;
  setText(byId("compare-robot"), where);
  // On paper, where the choices aren't.
  const results = shownView() === "numbers" ? select("table-room").selectedOptions[0]?.text : "";
  const time = shownView() === "race" && race ? ` The race after ${clock(race.time_s)}.` : "";
  setText(byId("compare-place"), `${place}, ${where}${results && results !== place ? ` Results for ${results}.` : ""}${time}`);
}
