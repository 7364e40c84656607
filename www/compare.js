// @ts-check
// The place Compare: who takes part, how far the trials are, and which view of them is shown.
import { Comparison } from "../page.js";
import { startAbout } from "./about.js";
import { button, byId, changed, fill, make, select, setAttribute, setHidden, setText, typed } from "./dom.js";
import { startExports } from "./exports.js";
import { startNumbers } from "./numbers.js";
import { complain, textOf } from "./messages.js";
import { paramField } from "./params.js";
import { Pool } from "./pool.js";
import { startRace } from "./race.js";

/**
 * @typedef {import("./types").CompareView} CompareView
 * @typedef {import("./main.js").App} App
 * @typedef {object} Comparing What the modules of this place share.
 * @property {App} app
 * @property {Comparison} comparison
 * @property {CompareView} view
 * @property {(what: (comparison: Comparison) => void) => boolean} act
 * @property {(entrant: number) => void} about Tells about an algorithm and shows its path.
 */

/** Numbers of seeds that are offered. */
const SEEDS = [1, 3, 5, 10, 20];

/**
 * @param {App} app
 * @param {WebAssembly.Module} module
 * @param {(what: () => void) => boolean} guard
 */
export function startCompare(app, module, guard) {
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
  const pool = new Pool(module, comparison, guard);
  startSetup(it);
  startExports(it);
  const race = startRace(it);
  const updateNumbers = startNumbers(it);

  return {
    /** Once a frame while the place is shown. @param {number} now */
    frame(now) {
      comparison.take(app.playground);
      pool.tend();
      comparison.frame(now);
      it.view = comparison.view();
      updateSetup(it);
      if (byId("place-compare").dataset.view === "race") race.update(it.view);
      else updateNumbers(it.view);
    },
    /** @param {string} link */
    restore(link) {
      try {
        comparison.restore(link);
      } catch (error) {
        // Not by `act`, which would take back what another part of the link was refused for.
        complain(textOf(error));
      }
      showView(new URLSearchParams(link).get("view") === "numbers" ? "numbers" : "race");
    },
    link: () => `place=compare&view=${byId("place-compare").dataset.view}&${comparison.link()}`,
    /** A single key, space for one. @param {string} key */
    key: (key) => byId("place-compare").dataset.view === "race" && race.key(key),
    /** @param {boolean} dark */
    setDark: (dark) => comparison.set_dark(dark),
  };
}

/** @param {"race" | "numbers"} view */
function showView(view) {
  byId("place-compare").dataset.view = view;
  for (const name of ["race", "numbers"]) byId(`view-${name}`).setAttribute("aria-pressed", String(name === view));
}

/** @param {Comparing} it */
function startSetup(it) {
  const { app, act } = it;
  const { planners } = app.catalogue;
  fill(select("compare-rooms"), it.view.sets);
  fill(select("compare-seeds"), SEEDS.map((n) => [String(n), String(n)]));
  select("compare-rooms").addEventListener("change", () => act((c) => c.set_rooms(select("compare-rooms").value)));
  select("compare-seeds").addEventListener("change", () => act((c) => c.set_seeds(Number(select("compare-seeds").value))));
  button("view-race").addEventListener("click", () => showView("race"));
  button("view-numbers").addEventListener("click", () => showView("numbers"));
  byId("to-explore").addEventListener("click", (event) => {
    event.preventDefault();
    byId("tab-explore").click();
  });
  /** @param {(fast: boolean) => boolean} takesPart */
  const chooseAll = (takesPart) => act((c) => planners.forEach(({ id, fast }) => c.choose(id, takesPart(fast))));
  button("choose-fast").addEventListener("click", () => chooseAll((fast) => fast));
  button("choose-all").addEventListener("click", () => chooseAll(() => true));
  button("trying-stop").addEventListener("click", () => act((c) => (it.view.cancelled ? c.resume() : c.cancel())));
  // On a phone the choices would hide what they are about.
  const small = matchMedia("(max-width: 900px)");
  const fold = () => (typed("compare-setup", HTMLDetailsElement).open = !small.matches);
  fold();
  small.addEventListener("change", fold);
  byId("entrants").replaceChildren(...planners.map((planner, index) => entrantItem(it, planner, index)));
}

/** @param {Comparing} it @param {import("./types").PlannerEntry} planner @param {number} index */
function entrantItem(it, planner, index) {
  const box = make("input", { type: "checkbox", id: `in-${planner.id}`, onchange: () => it.act((c) => c.choose(planner.id, box.checked)) });
  const name = make("label", { for: `in-${planner.id}` }, swatch(index), planner.title);
  const about = make("button", { type: "button", className: "quiet square small", "aria-label": `About ${planner.title}`, onclick: () => it.about(index) });
  about.innerHTML = '<svg class="icon" aria-hidden="true"><use href="#i-info" /></svg>';
  const item = make("li", { "data-id": planner.id }, box, name, make("span", { className: "status" }), about);
  if (planner.params.length > 0) {
    const fields = planner.params.map((spec) => {
      const { field, controls } = paramField(spec, (text) => it.act((c) => c.set_param(planner.id, spec.id, text)), `in-${planner.id}`);
      for (const control of controls) control.dataset.param = spec.id;
      return field;
    });
    item.append(make("details", { className: "tuning" }, make("summary", {}, "Parameters"), make("div", { className: "params" }, ...fields)));
  }
  return item;
}

/** The colour and shape of a planner, the same everywhere. @param {number} index */
export function swatch(index) {
  const mark = make("i", { className: "swatch", "aria-hidden": "true" });
  mark.dataset.colour = String(index % 8);
  mark.dataset.shape = String(Math.floor(index / 8));
  return mark;
}

/** @param {Comparing} it */
function updateSetup({ app, view }) {
  const { room, robot, cell_size_m, seed, slip } = app.view;
  setText(byId("compare-room"), room.title);
  const title = app.catalogue.robots.find(({ id }) => id === robot)?.title ?? robot;
  setText(byId("compare-robot"), `${room.width_m.toFixed(1)} × ${room.height_m.toFixed(1)} m, ${title}, cells of ${+(cell_size_m * 100).toFixed(1)} cm, seed ${seed}${slip === "none" ? "" : `, ${slip} wheel slip in the race`}.`);
  if (changed(select("compare-rooms"), "set", view.set)) select("compare-rooms").value = view.set;
  if (changed(select("compare-seeds"), "seeds", view.seeds)) select("compare-seeds").value = String(view.seeds);
  view.entrants.forEach((entrant, index) => {
    const item = byId("entrants").children[index];
    if (!(item instanceof HTMLElement)) return;
    const box = item.querySelector("input");
    if (box && changed(item, "chosen", entrant.chosen)) box.checked = entrant.chosen;
    const status = item.querySelector(".status");
    const busy = view.done < view.total && !view.cancelled;
    const words = { out: "", done: "✓", failed: "failed", trying: busy ? `${Math.floor(entrant.progress * 100)} %` : "–" };
    if (status) {
      setText(status, words[entrant.state]);
      setAttribute(status, "data-tip", entrant.message);
      setAttribute(status, "tabindex", entrant.state === "failed" ? "0" : "-1");
    }
    if (changed(item, "params", JSON.stringify(entrant.params))) {
      for (const control of item.querySelectorAll("[data-param]")) {
        const value = entrant.params[/** @type {HTMLElement} */ (control).dataset.param ?? ""];
        if (control instanceof HTMLInputElement && control.type === "checkbox") control.checked = value === true;
        else Reflect.set(control, "value", String(value));
      }
    }
  });
  updateTrying(view);
}

/** @param {CompareView} view */
function updateTrying({ done, total, cancelled, entrants, race }) {
  const left = done < total;
  const failed = entrants.filter(({ state }) => state === "failed").length;
  const words = left ? `${cancelled ? "Stopped" : "Trying"}: ${done} of ${total}` : `${total} ${total === 1 ? "plan" : "plans"} made`;
  const lanes = race?.lanes.length ?? 0;
  const able = entrants.filter(({ state }) => state === "done").length;
  const most = lanes > 0 && able > lanes ? `; the first ${lanes} race` : "";
  setText(byId("trying"), `${words}${failed ? `, ${failed} failed` : ""}${most}`);
  setHidden(byId("trying-bar"), !left);
  setAttribute(typed("trying-bar", HTMLProgressElement), "value", String(Math.floor((100 * done) / Math.max(total, 1))));
  setHidden(byId("trying-stop"), !left);
  setText(byId("trying-stop"), cancelled ? "Go on" : "Cancel");
}
