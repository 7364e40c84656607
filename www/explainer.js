// @ts-check
// What is said of an algorithm: idea, claims, colours, cost, when to use it, the paper.
import { make } from "./dom.js";

/** @typedef {import("./types").AlgorithmEntry} AlgorithmEntry */
/** @typedef {[claim: keyof AlgorithmEntry, yes: string, no: string, tipYes: string, tipNo: string]} Claim */

/** @type {Claim[]} */
const PLANNER_CLAIMS = [
  ["complete", "visits every cell", "may miss cells", "Visits every cell of the planning grid that can be reached; tests hold it to that in every room. Coverage may still stay a little below 100 %: cells are coarser than the floor, and slivers along walls remain.", "Gives no promise to visit every cell that can be reached."],
  ["deterministic", "same plan every time", "uses chance", "Gives the same plan whatever the seed.", "Draws random numbers; another seed gives another plan."],
  ["fast", "fast in large halls", "takes its time", "Plans a million cells in about a second.", "Meant for rooms of up to 200 × 200 cells; shows its best plan so far and can be cancelled."],
  ["anytime", "stops when you like", "", "Has a complete plan early on and improves it; stop it and it keeps the best so far.", ""],
];

/** @type {Claim[]} */
const BEHAVIOUR_CLAIMS = [
  ["cleans", "made to clean", "not made to clean", "Covers more and more of the floor.", "Serves another purpose. It sweeps where it drives, but doesn't set out to cover the floor."],
  ["ends", "ends by itself", "goes on and on", "Comes to an end by itself.", "Goes on until you stop it or the battery is empty."],
];

/** @type {Claim[]} */
const MANUAL_CLAIMS = [["manual", "you drive", "", "A person is at the controls; the robot only refuses what would do harm.", ""]];

/**
 * The explainer of an algorithm.
 * @param {AlgorithmEntry} algorithm
 * @param {import("./types").Catalogue["rooms"]} rooms
 * @param {((room: string) => void) | undefined} openRoom What to do when an example room is chosen.
 */
export function explainer(algorithm, rooms, openRoom) {
  const plans = algorithm.kind === "planner";
  const told = (plans ? PLANNER_CLAIMS : algorithm.manual ? MANUAL_CLAIMS : BEHAVIOUR_CLAIMS).filter(([key, , no]) => algorithm[key] || no);
  const claims = told.map(([key, yes, no, tipYes, tipNo]) =>
    make("li", { "data-tip": algorithm[key] ? tipYes : tipNo, className: algorithm[key] ? "yes" : "no" }, make("button", { type: "button", className: "term" }, algorithm[key] ? yes : no)),
  );
  /** @param {string} title @param {{ room: string, why: string }} example */
  const example = (title, { room, why }) => {
    if (!why) return [];
    const name = rooms.find(({ id }) => id === room)?.title ?? room;
    const place = openRoom ? make("button", { type: "button", className: "link", onclick: () => openRoom(room) }, name) : name;
    return [make("dt", {}, title), make("dd", {}, place, ": ", why)];
  };
  const source = make("p", { className: "source" }, algorithm.source);
  if (algorithm.link) source.append(" ", make("a", { href: algorithm.link, target: "_blank", rel: "noopener" }, "Read it"));
  return [
    make("p", {}, algorithm.idea),
    make("ul", { className: "claims" }, ...claims),
    make("dl", { className: "explained" },
      make("dt", {}, "When to use it"), make("dd", {}, algorithm.use_when),
      ...example("Shines in", algorithm.shines),
      ...example("Struggles in", algorithm.fails),
      make("dt", {}, "Cost"), make("dd", {}, algorithm.complexity),
      make("dt", {}, "Colours"), make("dd", {}, `Blue floor was swept once, the yellower the more often. ${plans ? "The thin line is the plan, the thick one" : "The line is"} where the robot has just been.`),
    ),
    source,
  ];
}
