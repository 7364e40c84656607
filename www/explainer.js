// @ts-check
// What is said of an algorithm: idea, claims, colours, cost, when to use it, the paper.
import { make } from "./dom.js";

/** @typedef {import("./types").PlannerEntry} PlannerEntry */

/** @type {[keyof PlannerEntry, string, string, string, string][]} */
const CLAIMS = [
  ["complete", "visits every cell", "may miss cells", "Visits every cell of the planning grid that can be reached; tests hold it to that in every room. Coverage may still stay a little below 100 %: cells are coarser than the floor, and slivers along walls remain.", "Gives no promise to visit every cell that can be reached."],
  ["deterministic", "same plan every time", "uses chance", "Gives the same plan whatever the seed.", "Draws random numbers; another seed gives another plan."],
  ["fast", "fast in large halls", "takes its time", "Plans a million cells in about a second.", "Meant for rooms of up to 200 × 200 cells; shows its best plan so far and can be cancelled."],
];

/**
 * The explainer of an algorithm.
 * @param {PlannerEntry} planner
 * @param {import("./types").Catalogue["rooms"]} rooms
 * @param {((room: string) => void) | undefined} openRoom What to do when an example room is chosen.
 */
export function explainer(planner, rooms, openRoom) {
  const claims = CLAIMS.map(([key, yes, no, tipYes, tipNo]) =>
    make("li", { "data-tip": planner[key] ? tipYes : tipNo, className: planner[key] ? "yes" : "no" }, make("button", { type: "button", className: "term" }, planner[key] ? yes : no)),
  );
  /** @param {string} title @param {{ room: string, why: string }} example */
  const example = (title, { room, why }) => {
    const name = rooms.find(({ id }) => id === room)?.title ?? room;
    const place = openRoom ? make("button", { type: "button", className: "link", onclick: () => openRoom(room) }, name) : name;
    return [make("dt", {}, title), make("dd", {}, place, ": ", why)];
  };
  const source = make("p", { className: "source" }, planner.source);
  if (planner.link) source.append(" ", make("a", { href: planner.link, target: "_blank", rel: "noopener" }, "Read it"));
  return [
    make("p", {}, planner.idea),
    make("ul", { className: "claims" }, ...claims),
    make("dl", { className: "explained" },
      make("dt", {}, "When to use it"), make("dd", {}, planner.use_when),
      ...example("Shines in", planner.shines),
      ...example("Struggles in", planner.fails),
      make("dt", {}, "Cost"), make("dd", {}, planner.complexity),
      make("dt", {}, "Colours"), make("dd", {}, "Blue floor was swept once, the yellower the more often. The thin line is the plan, the thick one where the robot has just been."),
    ),
    source,
  ];
}
