// @ts-check
// Break it: draw the room in which a planner does worst, measured by how far its plan is above the proven minimum.
import { make, setText } from "../dom.js";
import { perMilleAbove, shareAbove } from "../format.js";
import { toast } from "../messages.js";
import { act, send } from "./games.js";
import { addRoom } from "./own-rooms.js";
import { emptyRoom } from "./rooms.js";
import { isRenamed } from "./scenario.js";

/** @typedef {import("../main.js").App} App */

/** Room to begin with, m: small, so that bounds are proven at once. */
const [WIDTH, DEPTH] = [4, 3];
/** Least floor, m²: in a closet everything is far from the minimum. */
const LEAST = 4;

/** @param {App} app @param {import("./games.js").Card} card @returns {import("./games.js").Game} */
export function startWorst(app, card) {
  const { planners } = app.catalogue;
  /** The worst so far, and its room. @type {{ whose: string, excess: number, scenario: string } | undefined} */
  let best;
  /** Whether the room is the one to draw in. */
  let isReady = true;
  /** What somebody else has reached. @type {number | null} */
  let toBeat = null;
  const [now, record] = [make("b"), make("b")];
  const status = make("p", { role: "status", className: "note" });
  const titleOf = (/** @type {string} */ id) => planners.find((one) => one.id === id)?.title ?? id;
  const showWorst = async () => best && !isRenamed(best.scenario, app.playground.scenario_json()) && addRoom(app, "The worst so far", best.scenario);
  const again = act("Show the worst", showWorst);
  const challenge = act("Challenge others", () => showWorst().then(() => send(app)));

  function show() {
    const { algorithm } = app.view;
    setText(now, "…");
    setText(record, "–");
    card.show(
      `Break ${titleOf(algorithm)}`,
      make("p", { className: "how" }, "Draw walls until its plan is as far above the proven minimum as you can get it."),
      make("div", { className: "scores worst" }, make("span", {}, "Now"), now, make("span", {}, "Worst so far"), record),
      status,
      make("div", { className: "choices" }, again, challenge),
    );
  }

  return {
    key: "worst",
    offer() {
      best = undefined;
      toBeat = null;
      const isPlanner = app.view.kind === "planner" && planners.some(({ id, fast }) => fast && id === app.view.algorithm);
      if (!isPlanner) {
        const why = app.view.kind === "planner" ? `${titleOf(app.view.algorithm)} searches too long for this game` : "This game is about planners";
        toast(`${why}: it is played with ${planners[0]?.title}.`);
        app.act((p) => p.select_algorithm(planners[0]?.id ?? ""));
      }
      // Own rooms are taken as they are.
      isReady = app.view.room.id === "";
      if (!isReady) void addRoom(app, "Break it", emptyRoom(WIDTH, DEPTH)).then(() => (isReady = app.act((p) => p.set_tool("wall"))));
      show();
    },
    follow(value) {
      best = undefined;
      isReady = true;
      const excess = Number(value);
      toBeat = value !== "" && excess >= 0 ? excess / 100 : null;
      app.act((p) => p.set_tool("wall"));
      show();
    },
    update(view) {
      if (!isReady) return;
      // A room of the menu isn't drawn.
      if (view.kind !== "planner" || view.path_corners > 0 || view.room.id !== "") return card.close();
      // What another planner, robot or grid does worse is no worse room.
      const whose = [view.algorithm, view.robot, view.twin, view.own_robot, view.cell_size_m, view.cell_offset_m].join();
      if (best && best.whose !== whose) best = undefined;
      const excess = excessOf(view);
      const isSmall = view.room.reachable_m2 < LEAST;
      if (excess !== null && !isSmall && (!best || excess > best.excess)) best = { whose, excess, scenario: app.playground.scenario_json() };
      setText(/** @type {Element} */ (card.node.querySelector("h2")), `Break ${titleOf(view.algorithm)}`);
      setText(now, view.state === "planning" ? "…" : excess === null ? "–" : `${shareAbove(excess)} above`);
      setText(record, best ? `${shareAbove(best.excess)} above` : "–");
      setText(status, isSmall ? `A room counts if the robot reaches at least ${LEAST} m².` : excess === null && view.state !== "planning" ? "A plan counts when it visits every cell and its minimum is proven." : told());
      again.disabled = challenge.disabled = !best;
    },
    end: () => void (app.view.tool === "wall" && app.act((p) => p.set_tool("view"))),
    link: () => (best ? perMilleAbove(best.excess) / 10 : toBeat === null ? "" : perMilleAbove(toBeat) / 10).toString(),
  };

  function told() {
    if (toBeat === null) return "";
    const isBeaten = best && perMilleAbove(best.excess) > perMilleAbove(toBeat);
    return isBeaten ? `You beat this link's record of ${shareAbove(toBeat)}.` : `To beat: ${shareAbove(toBeat)} above the minimum, this link's record.`;
  }
}

/** How far the plan is above the minimum, as a share; of plans in metres their time. @param {import("../types").PageView} view */
function excessOf({ plan, state }) {
  if (!plan || state === "planning") return null;
  if (plan.above_bound !== null) return Math.max(0, plan.above_bound);
  const isWalk = plan.steps > 0;
  return isWalk || !plan.least ? null : Math.max(0, plan.duration_s / plan.least.duration_s - 1);
}
