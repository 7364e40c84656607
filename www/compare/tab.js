// @ts-check
// The tab Compare: the entrants, the progress of trials, and the current view of them.
import { Comparison, SessionMirror } from "../../workshop.js";
import { startAbout } from "./about.js";
import { button, byId, changed, fill, input, select, setAttribute, setHidden, setText, typed } from "../dom.js";
import { showChoice } from "./entrants.js";
import { showItems } from "./items.js";
import { startExports } from "./exports.js";
import { startMirror } from "../session-mirror.js";
import { startNumbers } from "./numbers.js";
import { complain, textOf } from "../messages.js";
import { Pool } from "./pool.js";
import { raceProgram, startRace } from "./race.js";
import { startRuns } from "./montecarlo.js";

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
/** Numbers of seeds that are offered. */
const SEEDS = [1, 3, 5, 10, 20];

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
  const race = startRace(it);
  const updateNumbers = startNumbers(it);
  const runs = startRuns(app, module, guard, mirror);
  const plans = { name: "comparison", csv: () => comparison.csv(), json: () => comparison.json(), charts: byId("charts") };
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

  return {
    /** Once a frame while the tab is shown. @param {number} now */
    frame(now) {
      updatePlace(app);
      if (shownView() === "study") return;
      if (shownView() === "runs") {
        runs.frame();
        return;
      }
      comparison.take(mirror());
      pool.tend();
      raceProgram(app, comparison);
      comparison.frame(now);
      it.view = comparison.view();
      updateSetup(it);
      if (shownView() === "race") race.update(it.view);
      else updateNumbers(it.view);
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
      const wanted = new URLSearchParams(link).get("view");
      // A link has no file.
      showView(VIEWS.find((name) => name === wanted && name !== "study") ?? "race");
    },
    link: () => `tab=compare&view=${shownView()}&${comparison.link()}${shownView() === "runs" ? `&${runs.link()}` : ""}`,
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

/** @param {Comparing} it */
function startSetup(it) {
  const { app, act } = it;
  fill(select("compare-rooms"), it.view.sets);
  fill(select("compare-seeds"), SEEDS.map((n) => [String(n), String(n)]));
  select("compare-rooms").addEventListener("change", () => act((c) => c.set_rooms(select("compare-rooms").value)));
  select("compare-seeds").addEventListener("change", () => act((c) => c.set_seeds(Number(select("compare-seeds").value))));
  for (const name of VIEWS) button(`view-${name}`).addEventListener("click", () => showView(name));
  byId("to-explore").addEventListener("click", (event) => {
    event.preventDefault();
    byId("tab-explore").click();
  });
  const isFast = (/** @type {string} */ id) => app.catalogue.planners.some((planner) => planner.id === id && planner.fast);
  /** @param {(id: string) => boolean} takesPart */
  const chooseAll = (takesPart) =>
    act((c) => it.view.entrants.forEach(({ id, kind, copy, chosen }, index) => kind === "planner" && copy === 1 && chosen !== takesPart(id) && c.choose(index, takesPart(id))));
  button("choose-fast").addEventListener("click", () => chooseAll(isFast));
  button("choose-all").addEventListener("click", () => chooseAll(() => true));
  button("trying-stop").addEventListener("click", () => act((c) => (it.view.cancelled ? c.resume() : c.cancel())));
  // On a phone the choices would hide the results.
  const small = matchMedia("(max-width: 900px)");
  const fold = () => (typed("compare-setup", HTMLDetailsElement).open = !small.matches);
  fold();
  small.addEventListener("change", fold);
}

/** Where all of it happens. @param {App} app */
function updatePlace({ view: { room, robot, cell_size_m, seed, slip }, catalogue }) {
  setText(byId("compare-room"), room.title);
  const title = catalogue.robots.find(({ id }) => id === robot)?.title ?? robot;
  const slips = slip === "none" ? "" : `, ${slip} wheel slip${shownView() === "runs" ? "" : " in the race"}`;
  setText(byId("compare-robot"), `${room.width_m.toFixed(1)} × ${room.height_m.toFixed(1)} m, ${title}, cells of ${+(cell_size_m * 100).toFixed(1)} cm, seed ${seed}${slips}.`);
}

/** @type {HTMLElement[]} */
let items = [];

/** @param {Comparing} it */
function updateSetup(it) {
  const { view } = it;
  if (changed(byId("entrants"), "copies", view.entrants.map(({ copy }) => copy).join())) items = showItems(it);
  if (changed(select("compare-rooms"), "set", view.set)) select("compare-rooms").value = view.set;
  if (changed(select("compare-seeds"), "seeds", view.seeds)) select("compare-seeds").value = String(view.seeds);
  view.entrants.forEach((entrant, index) => {
    const item = items[index];
    showChoice(item, entrant);
    const status = item?.querySelector(".status");
    const busy = view.done < view.total && !view.cancelled;
    const words = { out: "", done: "✓", failed: "failed", trying: busy ? `${Math.floor(entrant.progress * 100)} %` : "–" };
    if (status) {
      setText(status, words[entrant.state]);
      setAttribute(status, "data-tip", entrant.message);
      setAttribute(status, "tabindex", entrant.state === "failed" ? "0" : "-1");
    }
  });
  updateTrying(view);
}

/** @param {CompareView} view */
function updateTrying({ done, total, cancelled, entrants }) {
  const left = done < total;
  const failed = entrants.filter(({ state }) => state === "failed").length;
  const words = left ? `${cancelled ? "Stopped" : "Planning"}: ${done} of ${total}` : `${total} ${total === 1 ? "plan" : "plans"} made`;
  setText(byId("trying"), `${words}${failed ? `, ${failed} failed` : ""}`);
  setHidden(byId("trying-bar"), !left);
  setAttribute(typed("trying-bar", HTMLProgressElement), "value", String(Math.floor((100 * done) / Math.max(total, 1))));
  setHidden(byId("trying-stop"), !left);
  setText(byId("trying-stop"), cancelled ? "Resume" : "Cancel");
}
