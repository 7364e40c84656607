// @ts-check
// The room that the robot is in, as the page's copy and the worker's have it, and the algorithm that is to drive.
import { SessionMirror } from "../../workshop.js";

/** Stands for the path of Explore in place of an algorithm's id. */
const PATH = "path";
/** Stand for the user's program: a behaviour, or a planner. */
export const PROGRAM = "program";
export const PROGRAM_PLANNER = "program_planner";

/**
 * The playground's room as it was when it was last taken over, with an algorithm of one's own choice.
 * @param {import("../main.js").App} app
 */
export function startRoom({ playground, catalogue }) {
  const mirror = new SessionMirror();
  let taken = playground.snapshot();
  /** The algorithm chosen in Explore. @type {string | null | undefined} */
  let chosenThere;
  /** The one that is to drive. @type {string | undefined} */
  let algorithm;
  /** @type {string | undefined} */
  let refusal;
  // Explore's catalogue lacks those that keep a map.
  const all = [...SessionMirror.behaviours(), ...catalogue.planners];
  /** The path that Explore drives, in place of an algorithm. */
  const path = { .../** @type {import("../types").CatalogueEntry} */ (catalogue.planners[0]), id: PATH, title: "Path from Floor plan" };

  let own = playground.program();
  /** The user's program as an entry of the list. */
  const program = () => {
    if (!own) return undefined;
    const [base, id] = own.kind === "planner" ? [catalogue.planners[0], PROGRAM_PLANNER] : [catalogue.behaviours[0], PROGRAM];
    return { .../** @type {import("../types").CatalogueEntry} */ (base), id, title: `Your program: ${own.name}`, params: [], cleans: true, manual: false };
  };
  const find = (/** @type {string | null | undefined} */ id) => [...all, program()].find((entry) => entry && entry.id === id);

  /** Says which room it is, and where the robot starts in it. */
  const version = () => JSON.stringify([taken.room_version, taken.room, taken.start]);
  const follow = () => mirror.follow(taken, algorithm);

  return {
    mirror,
    /** Algorithms that can drive a robot. */
    all,
    get algorithm() {
      return algorithm === PATH ? path : find(algorithm);
    },
    /** Whether Explore drives a path from the tab Floor plan. */
    get hasPath() {
      return Boolean(taken.choices.path);
    },
    program,
    /** Its text. */
    get own() {
      return own;
    },
    /** Why a Roomba can't ride the chosen path; `undefined` if it can. */
    refusal: () => (algorithm === PATH ? refusal : undefined),
    /** Takes over what Explore shows now; says whether the room is another one. */
    take() {
      const before = version();
      taken = playground.snapshot();
      own = playground.program();
      const there = taken.choices.path ? PATH : (taken.choices.behaviour ?? taken.choices.planner);
      // Manual driving needs no algorithm here.
      if (there === PATH) algorithm = there === chosenThere ? algorithm : PATH;
      else if (there !== chosenThere || !algorithm) algorithm = find(there)?.id ?? (algorithm && algorithm !== PATH ? algorithm : all[0]?.id);
      chosenThere = there;
      refusal = SessionMirror.path_refusal(taken);
      follow();
      return version() !== before;
    },
    /** @param {string} id */
    choose(id) {
      algorithm = id;
      follow();
    },
    /** The snapshot for the worker's mirror. */
    followed: () => ({ snapshot: taken, algorithm }),
    version,
  };
}
