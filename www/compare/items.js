// @ts-check
// The lists of all entrants of a comparison, with their copies.
import { byId } from "../dom.js";
import { entrantItem, swatch } from "./entrants.js";

/** The items of all entrants, in lists of their kinds; made again when a copy comes or goes. @param {import("./tab.js").Comparing} it */
export function showItems({ app, act, view, about }) {
  const items = view.entrants.map(({ id, kind, title, mark, copy }, index) => {
    const entry = (kind === "planner" ? app.catalogue.planners : app.catalogue.behaviours).find((known) => known.id === id);
    return entrantItem({ id: copy > 1 ? `${id}-${copy}` : id, title, params: entry?.params ?? [] }, swatch(mark), kind === "planner" ? "in" : "in-behaviour", {
      choose: (takesPart) => act((c) => c.choose(index, takesPart)),
      setParam: (param, text) => act((c) => c.set_param(index, param, text)),
      about: () => about(index),
      copy: copy === 1 ? () => act((c) => c.copy(index)) : undefined,
      remove: copy > 1 ? () => act((c) => c.remove_copy(index)) : undefined,
    });
  });
  const order = view.entrants.map((entrant, index) => ({ ...entrant, index })).filter(({ copy }) => copy > 0);
  // Copies stand behind what they were made of.
  const rank = (/** @type {{ id: string, kind: string }} */ { id, kind }) => view.entrants.findIndex((entrant) => entrant.id === id && entrant.kind === kind);
  order.sort((a, b) => rank(a) - rank(b) || a.copy - b.copy);
  // The user's own program is what they look for.
  const listOf = (/** @type {{ id: string, kind: string }} */ { id, kind }) => (kind === "planner" || id === "program" ? "entrants" : "racing-behaviours");
  order.sort((a, b) => Number(b.id.startsWith("program")) - Number(a.id.startsWith("program")));
  for (const list of ["entrants", "racing-behaviours"]) {
    byId(list).replaceChildren(...order.filter((entrant) => listOf(entrant) === list).flatMap(({ index }) => items[index] ?? []));
  }
  return items;
}
