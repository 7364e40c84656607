// @ts-check
// Many runs (Monte Carlo): the entrants and the number of runs, the workers, and the results.
import { MonteCarlo } from "../../workshop.js";
import { bandsOf, startChart } from "./coverage-chart.js";
import { button, byId, changed, fill, select, setAttribute, setHidden, setText, typed } from "../dom.js";
import { entrantItem, showChoice, showTitle, swatch } from "./entrants.js";
import { count } from "../format.js";
import { Pool } from "./pool.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { startTable } from "./runs-table.js";

/**
 * @typedef {import("../types").ManyRunsView} View
 * @typedef {import("../types").ManyRunsOffer} Offer
 */

/** Milliseconds between redraws while results come. */
const REDRAW = 400;
/** Most workers. A lab is small: a room and some lines. */
const MOST_WORKERS = 16;
/** The study of figure 18 of Hasan, Al-Nahid & Reza 2014: their four behaviours and their cycle, in their room. */
const FIGURE = {
  place: "room=room12ft&robot=dvr1&slip=typical&noise=typical",
  study: "runs=random_walk,spiral_out,s_path,wall_follow,cleaning_cycle&paths=&times=100&minutes=60",
};

/** The phases of the exploration strategy of Krapinec 2025, chapter 7, and the frontier explorer. */
const PHASES = {
  place: "room=flat&robot=roomba600&slip=typical&noise=typical",
  study: `runs=${["forward_rotate", "left_right", "look_ahead", "look_around", "until_obstacle", "edge", "frontier"].map((id) => `explore_${id}`).join()}&paths=&times=20&minutes=30`,
};

/**
 * @param {import("../main.js").App} app
 * @param {WebAssembly.Module} module
 * @param {(what: () => void) => boolean} guard
 * @param {() => import("../../workshop.js").SessionMirror} mirror The session, up to date.
 */
export function startRuns(app, module, guard, mirror) {
  const study = new MonteCarlo();
  /** @type {Offer} */
  const offer = study.offer();
  const pool = new Pool(module, runsOf(study, () => app.playground.program()), guard);
  const chart = startChart(byId("runs-plot"));
  const table = startTable(byId("runs-table"));
  const act = (/** @type {(study: MonteCarlo) => void} */ what) => app.act(() => what(study));
  /** @type {View} */
  let view = study.view();
  /** When the runs began, and how many there were by then. */
  let began = { at: 0, done: 0 };
  const isDue = atMostEvery(REDRAW);

  const run = () =>
    act((s) => {
      s.take(mirror());
      s.run();
      began = { at: performance.now(), done: s.view().done };
    });
  button("runs-go").addEventListener("click", () => (view.running ? act((s) => s.cancel()) : run()));
  for (const [id, { place, study: chosen }] of /** @type {const} */ ([["runs-figure", FIGURE], ["runs-phases", PHASES]])) {
    button(id).addEventListener("click", () => {
      if (app.act((p) => p.restore(place)) && act((s) => s.restore(chosen))) run();
    });
  }
  select("runs-seeds").addEventListener("change", () => act((s) => s.set_seeds(Number(select("runs-seeds").value))));
  select("runs-minutes").addEventListener("change", () => act((s) => s.set_minutes(Number(select("runs-minutes").value))));
  const items = offer.entrants.map((entrant, index) =>
    entrantItem({ ...entrant, title: view.entrants[index]?.title ?? "" }, swatch(entrant.mark), `run-${entrant.kind}`, {
      choose: (takesPart) => act((s) => s.choose(index, takesPart)),
      setParam: (param, text) => act((s) => s.set_param(index, param, text)),
    }),
  );
  offer.entrants.forEach(({ kind, explores, summary }, index) => {
    const item = items[index];
    if (!item) return;
    item.querySelector("label")?.setAttribute("data-tip", summary);
    byId(explores ? "runs-explorers" : kind === "behaviour" ? "runs-behaviours" : "runs-planners").append(item);
  });

  const results = () => {
    const shown = offer.entrants.map((entrant, index) => ({ entrant, index })).filter(({ index }) => view.entrants[index]?.chosen);
    // Behaviours first, as in the list of choices.
    shown.sort((a, b) => a.entrant.kind.localeCompare(b.entrant.kind) || a.index - b.index);
    const rows = shown.map(({ entrant, index }) => ({
      title: view.entrants[index]?.title ?? "",
      explores: entrant.explores,
      mark: swatch(entrant.mark),
      summary: study.summary(index),
      failure: view.entrants[index]?.failure ?? "",
      index,
      ...entrant.mark,
    }));
    const known = rows.filter(({ summary }) => summary);
    const any = rows.some(({ summary, failure }) => summary || failure);
    setHidden(byId("runs-empty"), any);
    for (const id of ["runs-scroll", "runs-note"]) setHidden(byId(id), !any);
    setHidden(byId("runs-chart"), known.length === 0);
    /** @type {import("../types").ManyRunsPlace | null} */
    const place = study.place();
    setText(byId("runs-title"), place ? titleOf(place, view, rows) : "");
    setText(byId("runs-note"), `Lines and large numbers are medians; bands and small numbers span the 10 % to 90 % quantiles.${view.minutes > 60 ? " When its battery is low, a robot goes to its dock or stops; from then on its curve is level." : ""}`);
    chart.show(known.map((row) => ({ ...row, ...bandsOf(study.curve(row.index)) })), view.minutes);
    const stress = (/** @type {number | undefined} */ which) => chart.stress(which === undefined ? undefined : known.findIndex((row) => row === rows[which]));
    table.show(rows, view.minutes, stress);
  };

  return {
    /** Once a frame while this view is shown. */
    frame() {
      study.take(mirror());
      pool.tend();
      view = study.view();
      updateChoices(view, offer, items);
      updateProgress(view, began);
      if (isDue(() => changed(byId("runs-view"), "version", view.version), !view.running)) results();
    },
    restore(/** @type {string} */ link) {
      study.restore(link);
      table.restore(new URLSearchParams(link));
    },
    link: () => study.link() + table.link(),
    exported: { name: "runs", csv: () => study.csv(), json: () => study.json(), charts: byId("runs-view") },
  };
}

/** Runs as work for workers. @param {MonteCarlo} study @param {import("./pool.js").Source["program"]} program @returns {import("./pool.js").Source} */
const runsOf = (study, program) => ({
  program,
  type: "runs",
  most: MOST_WORKERS,
  take: () => study.take_batch(),
  isWanted: (id) => study.is_wanted(id),
  answered: (answer) => {
    if (answer.type === "ran") study.batch_finished(answer.id, answer.outcomes);
    else if (answer.type === "failed") study.batch_failed(answer.id, answer.message);
  },
  failed: (id, message) => study.batch_failed(id, message),
});

/** @param {import("../types").ManyRunsPlace} place @param {View} view @param {{ explores: boolean }[]} rows */
function titleOf({ room, robot, slip, noise, quantised, start_charge_percent: charge }, { minutes, seeds }, rows) {
  const all = rows.every(({ explores }) => explores);
  const what = all ? "Boundary found" : rows.some(({ explores }) => explores) ? "Coverage (boundary found, for explorers)" : "Coverage";
  return `${what} over ${minutes} minutes: ${room}, ${robot}, slip ${slip}, noise ${noise}${quantised ? ", rounded wheel speeds" : ""}${charge < 100 ? `, start charge ${charge} %` : ""}. Median of ${seeds} runs each, and the band of 10 % to 90 %`;
}

/** @param {View} view @param {Offer} offer @param {HTMLElement[]} items */
function updateChoices(view, offer, items) {
  for (const [id, offered, now] of /** @type {const} */ ([["runs-seeds", offer.seeds, view.seeds], ["runs-minutes", offer.minutes, view.minutes]])) {
    if (!changed(select(id), "now", now)) continue;
    // A link can contain another number.
    const all = offered.includes(now) ? offered : [...offered, now].sort((a, b) => a - b);
    fill(select(id), all.map((n) => [String(n), String(n)]));
    select(id).value = String(now);
  }
  view.entrants.forEach((entrant, index) => {
    const item = items[index];
    if (item) setHidden(item, !entrant.offered);
    showChoice(item, entrant);
    showTitle(item, entrant.title);
    const status = items[index]?.querySelector(".status");
    if (!status) return;
    const words = entrant.failure ? "failed" : entrant.runs >= view.seeds ? "✓" : entrant.runs > 0 ? String(entrant.runs) : "";
    setText(status, entrant.lacks || (entrant.chosen ? words : ""));
    setAttribute(status, "data-tip", entrant.failure);
    setAttribute(status, "tabindex", entrant.failure ? "0" : "-1");
  });
}

/** @param {View} view @param {{ at: number, done: number }} began */
function updateProgress({ running, done, total, seeds, minutes, entrants }, began) {
  const go = button("runs-go");
  const who = entrants.filter(({ chosen }) => chosen).length;
  setText(go, running ? "Cancel" : done > 0 && done < total ? "Resume" : "Run");
  setAttribute(go, "class", running ? "" : "primary");
  const idle = !running && done >= total;
  if (go.disabled !== idle && document.activeElement !== go) go.disabled = idle;
  setAttribute(go, "aria-disabled", String(idle));
  setHidden(byId("runs-bar"), !running);
  setAttribute(typed("runs-bar", HTMLProgressElement), "value", (done / Math.max(total, 1)).toFixed(3));
  const plan = who === 0 ? "Choose at least one algorithm." : `${who} ${who === 1 ? "algorithm" : "algorithms"}, ${seeds} runs of ${minutes} minutes each: ${count((total * minutes) / 60)} h of simulated time.`;
  setText(byId("runs-plan"), plan);
  const far = total > 0 && done >= total ? `${count(total)} runs done` : done > 0 ? `${done} of ${total} runs done` : "";
  setText(byId("runs-far"), running ? `${done} of ${total} runs${timeLeft(done, total, began)}` : far);
  byId("runs-view").dataset.done = String(done);
  setText(byId("runs-said"), running ? "Running" : total > 0 && done >= total ? "All runs are done" : "");
}

/** @param {number} done @param {number} total @param {{ at: number, done: number }} began */
function timeLeft(done, total, began) {
  const made = done - began.done;
  const passed = performance.now() - began.at;
  // The first runs come late, as the workers have to start.
  if (made < 4 || passed < 1000) return "";
  const seconds = Math.ceil(((passed / made) * (total - done)) / 1000);
  return seconds < 100 ? `, about ${seconds} s left` : `, about ${Math.ceil(seconds / 60)} min left`;
}
