// @ts-check
// The description of an algorithm: idea, claims, colours, cost, when to use it, the paper.
import { make } from "./dom.js";
import { text } from "./parts.js";

/** @typedef {import("./types").CatalogueEntry} AlgorithmEntry */
/** @typedef {Record<string, import("./types").ExplainerEntry>} Explainers */
/** @typedef {[claim: keyof AlgorithmEntry, yes: string, no: string, tipYes: string, tipNo: string]} Claim */

/** @type {Claim[]} */
const PLANNER_CLAIMS = [
  ["complete", "visits every cell", "may miss cells", "Visits every reachable cell of the planning grid with its default parameters; tests check this in every room. Coverage can stay slightly below 100 %: cells are coarser than the floor, so slivers along walls remain.", "May leave reachable cells unvisited."],
  ["deterministic", "same plan every time", "randomised", "Gives the same plan whatever the seed.", "Uses random numbers: another seed gives another plan."],
  ["fast", "fast in large halls", "slow in large halls", "Plans a million cells in about a second.", "Meant for rooms of up to 200 × 200 cells; shows its best plan so far and can be cancelled."],
  ["anytime", "can be stopped early", "", "Finds a complete plan early and improves it; when stopped, it keeps the best plan so far.", ""],
];

/** @type {Claim[]} */
const BEHAVIOUR_CLAIMS = [
  ["cleans", "made to clean", "not made to clean", "Covers more and more of the floor.", "Has another purpose: it sweeps where it drives, but doesn't try to cover the floor."],
  ["ends", "stops by itself", "runs until stopped", "Stops by itself when it is done.", "Runs until you stop it or the battery is empty."],
];

/** @type {Claim[]} */
const MANUAL_CLAIMS = [["manual", "you drive", "", "You drive; only commands that would do harm are blocked.", ""]];

/** The opening scene's text, which is all that opening the page needs. */
const OPENING = new URL("./explainers-opening.json", import.meta.url);
/** All texts. Made in another way, so that scripts/size.mjs doesn't take them for a part of the first load. */
const ALL = new URL(`./explainers.json${OPENING.search}`, OPENING);

/** What was fetched. @type {Map<URL, Promise<Explainers>>} */
const texts = new Map();

/** The texts at `address`, by the algorithm's id; none while they can't be fetched. @param {URL} address */
async function load(address) {
  const coming = texts.get(address) ?? text(address).then((json) => /** @type {Explainers} */ (JSON.parse(json)));
  texts.set(address, coming);
  try {
    return await coming;
  } catch (error) {
    // Fetched again for the next algorithm; until then the claims have to do.
    texts.delete(address);
    console.warn(error);
    return {};
  }
}

/** Of every algorithm, by its id; of none while they can't be fetched. */
export const explainers = () => load(ALL);

/**
 * Explains an algorithm in `into`, once the texts are there.
 * @param {HTMLElement} into
 * @param {AlgorithmEntry} algorithm
 * @param {import("./types").Catalogue["rooms"]} rooms
 * @param {((room: string) => void) | undefined} openRoom What to do when an example room is chosen.
 * @param {boolean} withColours Whether the floor has the colours of Explore.
 */
export async function explain(into, algorithm, rooms, openRoom, withColours = true) {
  into.dataset.about = algorithm.id;
  const explained = (await load(OPENING))[algorithm.id] ?? (await explainers())[algorithm.id];
  // Another one was chosen meanwhile.
  if (into.dataset.about !== algorithm.id) return;
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
  const source = make("p", { className: "source" }, explained?.source ?? "");
  if (explained?.link) source.append(" ", make("a", { href: explained.link, target: "_blank", rel: "noopener" }, "Read it"));
  const advice = explained
    ? [
        make("dt", {}, "When to use it"), make("dd", {}, explained.use_when),
        ...example("Works well in", explained.shines),
        ...example("Works poorly in", explained.fails),
        make("dt", {}, "Cost"), make("dd", {}, explained.complexity),
      ]
    : [];
  into.replaceChildren(
    make("p", {}, explained?.idea ?? algorithm.summary),
    make("ul", { className: "claims" }, ...claims),
    make("dl", { className: "explained" },
      ...advice,
      ...(withColours ? [make("dt", {}, "Colours"), make("dd", {}, `Blue floor was swept once, yellow floor often. ${plans ? "The thin line is the plan, the thick line" : "The line is"} where the robot drove recently.`)] : []),
    ),
    source,
  );
}
