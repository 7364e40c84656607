// @ts-check
// Planning for the page, loaded with the first request: the opening scene's plan is shipped.

/** @typedef {import("./worker-types").PlanRequest} PlanRequest */

/** Who plans for programs of users, once their tab is loaded. @type {((request: PlanRequest) => void) | undefined} */
let byProgram;
/** @param {(request: PlanRequest) => void} plan */
export const planWith = (plan) => void (byProgram = plan);

/** @param {import("../page.js").Playground} playground @param {(what: () => void) => boolean} guard Runs what can fail. */
export function startPlanning(playground, guard) {
  /** @type {import("./planning.js").Planning | undefined} */
  let planning;
  /** Id of the latest request. */
  let wanted = NaN;
  /** @type {import("./planning.js").Listeners} */
  const listeners = {
    progress: (id, done, cells, proof) => guard(() => playground.plan_progress(id, done, cells, proof)),
    finished: (id, cells, seconds, trace, proof, knots, film) => {
      guard(() => playground.plan_finished(id, cells, seconds, trace, proof));
      if (knots) guard(() => playground.plan_smoothed(id, knots));
      if (film) listeners.filmed?.(id, film);
    },
    filmed: (id, film) => guard(() => playground.plan_filmed(id, film)),
    smoothed: (id, knots) => guard(() => playground.plan_smoothed(id, knots)),
    proven: (id, proof, least) => guard(() => playground.plan_proven(id, proof, least)),
    failed: (id, message) => guard(() => playground.plan_failed(id, message)),
  };
  return {
    /** @param {PlanRequest} request */
    async start(request) {
      wanted = request.id;
      if (request.planner === "program_planner") return byProgram?.(request);
      try {
        const { Planning } = await import("./planning.js");
        if (wanted === request.id) (planning ??= new Planning(listeners)).start(request);
      } catch {
        listeners.failed(request.id, "it could not be loaded. Check the connection, then press play");
      }
    },
    cancel() {
      wanted = NaN;
      planning?.cancel();
    },
    /** Ends the search, whose best plan so far is to be kept. @returns {number | undefined} Seconds since it began, if it has. */
    keep: () => planning?.keep(),
  };
}
