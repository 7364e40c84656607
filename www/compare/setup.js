// @ts-check
// The choices of a comparison: entrants, rooms and seeds, and how far their plans are.
import { button, byId, changed, fill, select, setAttribute, setHidden, setText, typed } from "../dom.js";
import { showChoice, showTitle } from "./entrants.js";
import { showItems } from "./items.js";
import { winner } from "./race.js";

/** @typedef {import("./tab.js").Comparing} Comparing */

/** Numbers of seeds that are offered. */
const SEEDS = [1, 3, 5, 10, 20];

/** @param {Comparing} it */
export function startSetup(it) {
  const { app, act } = it;
  fill(select("compare-rooms"), it.view.sets);
  fill(select("compare-seeds"), SEEDS.map((n) => [String(n), String(n)]));
  select("compare-rooms").addEventListener("change", () => act((c) => c.set_rooms(select("compare-rooms").value)));
  select("compare-seeds").addEventListener("change", () => act((c) => c.set_seeds(Number(select("compare-seeds").value))));
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

/** @type {HTMLElement[]} */
let items = [];

/** @param {Comparing} it */
export function updateSetup(it) {
  const { view } = it;
  if (changed(byId("entrants"), "copies", view.entrants.map(({ copy }) => copy).join())) items = showItems(it);
  if (changed(select("compare-rooms"), "set", view.set)) select("compare-rooms").value = view.set;
  if (changed(select("compare-seeds"), "seeds", view.seeds)) select("compare-seeds").value = String(view.seeds);
  view.entrants.forEach((entrant, index) => {
    const item = items[index];
    showChoice(item, entrant);
    showTitle(item, entrant.title);
    const status = item?.querySelector(".status");
    const busy = view.done < view.total && !view.cancelled;
    const words = { out: "", done: "✓", failed: "failed", trying: busy ? `${Math.floor(entrant.progress * 100)} %` : "–" };
    if (status) {
      setText(status, entrant.lacks || words[entrant.state]);
      setAttribute(status, "data-tip", entrant.message);
      setAttribute(status, "tabindex", entrant.state === "failed" ? "0" : "-1");
    }
  });
  updateTrying(view);
}

/** @param {Comparing["view"]} view */
function updateTrying(view) {
  const { done, total, cancelled, entrants } = view;
  const left = done < total;
  const failed = entrants.filter(({ state }) => state === "failed").length;
  const words = left ? `${cancelled ? "Stopped" : "Planning"}: ${done} of ${total}` : winner(view) || `${total} ${total === 1 ? "plan" : "plans"} made`;
  setText(byId("trying"), `${words}${failed ? `, ${failed} failed` : ""}`);
  setHidden(byId("trying-bar"), !left);
  setAttribute(typed("trying-bar", HTMLProgressElement), "value", String(Math.floor((100 * done) / Math.max(total, 1))));
  setHidden(byId("trying-stop"), !left);
  setText(byId("trying-stop"), cancelled ? "Resume" : "Cancel");
}
