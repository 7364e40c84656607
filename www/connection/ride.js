// @ts-check
// Algorithms that drive the robot: chosen here or in Explore, planned first where there is something to plan.
import { button, byId, changed, fill, input, make, select, setAttribute, setEnabled, setHidden, setText } from "../dom.js";
import { ODOMETRIES, ODOMETRY_TIP } from "../odometry.js";
import { textOf } from "../messages.js";
import { Planning } from "../planning.js";
import { choose, keep, kept } from "./dialogs.js";
import { PROGRAM, PROGRAM_PLANNER } from "./room.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */

/** Whether brushes and vacuum run: "on" or "off". */
const CLEANS = "connection-cleans";

/** The user's program gets ready to answer. @param {ConnectionTab} it */
async function takeSeat(it) {
  const { pilot } = await import("../program/pilot.js");
  return pilot(it.app, it.connection, it.complain);
}

/** Whether the user's program may drive the robot. @param {ConnectionTab} it */
async function mayPlan(it) {
  const { isAllowed } = await import("../program/pilot.js");
  return isAllowed(it.room.own);
}

/** @param {ConnectionTab} it */
export function startRide(it) {
  const { room } = it;
  const choice = select("connection-algorithm");
  const group = (/** @type {string} */ label, /** @type {string} */ kind) =>
    make("optgroup", { label }, ...room.all.filter((entry) => entry.kind === kind).map(({ id, title }) => make("option", { value: id }, title)));
  choice.replaceChildren(group("Behaviours: for any room", "behaviour"), group("Planned paths: for a known room", "planner"));
  choice.addEventListener("change", () => {
    cancel();
    room.choose(choice.value);
    it.live.map.set_planned(room.mirror.corners());
  });

  const cleans = input("connection-cleans");
  let wantsCleaning = kept(CLEANS) !== "off";
  cleans.addEventListener("change", () => {
    wantsCleaning = cleans.checked;
    keep(CLEANS, wantsCleaning ? "on" : "off");
  });

  const odometry = select("connection-odometry");
  fill(odometry, ODOMETRIES);
  setAttribute(byId("connection-odometry-field"), "data-tip", `${ODOMETRY_TIP} Calibration applies to counts; the packets use the robot's own figures.`);
  odometry.addEventListener("change", async () => {
    if (!(await it.request({ do: "odometry", model: /** @type {import("../types").OdometryModel} */ (odometry.value) }))) odometry.value = it.view.odometry;
  });

  /** The user's program plans in its sandbox. @param {import("../worker-types").PlanRequest} request */
  const planByProgram = async (request) => {
    const { own } = room;
    knots = undefined;
    try {
      if (!own) return answer(false);
      const { planned } = await import("../program/pilot.js");
      const { cells, seconds } = await planned(own, request);
      // It may have been cancelled.
      if (!waiting) return;
      if (it.app.act(() => room.mirror.plan_finished(request.id, cells, seconds))) planning.prove(request, cells);
      else answer(false);
    } catch (error) {
      it.complain(`The planner failed: ${textOf(error)}.`);
      answer(false);
    }
  };

  /** The last plan with rounded corners. @type {import("../worker-types").Knots} */
  let knots;
  /** Resolves the pending plan. @type {((worked: boolean) => void) | undefined} */
  let waiting;
  const answer = (/** @type {boolean} */ worked) => {
    waiting?.(worked);
    waiting = undefined;
    setText(byId("connection-planning"), "");
  };
  const planning = new Planning({
    progress: (_, done) => setText(byId("connection-planning"), `Planning… ${Math.round(100 * done)} %`),
    finished: (id, cells, seconds, _trace, _proof, rounded) => {
      knots = rounded;
      answer(it.app.act(() => room.mirror.plan_finished(id, cells, seconds)));
      it.live.map.set_planned(room.mirror.corners());
    },
    // Of what a program has planned.
    smoothed: (_, rounded) => (knots = rounded),
    proven: () => answer(true),
    failed: (_, message) => {
      it.complain(`The planner failed: ${message}.`);
      answer(false);
    },
  });
  const cancel = () => {
    planning.cancel();
    answer(false);
  };

  /** Corners of the line to drive; `undefined` if there is none. @returns {Promise<Float64Array | undefined>} */
  const corners = async () => {
    if (room.algorithm?.kind === "behaviour") return new Float64Array();
    const request = room.mirror.take_plan_request();
    if (request) {
      setText(byId("connection-planning"), "Planning…");
      if (request.planner === PROGRAM_PLANNER) void planByProgram(request);
      else planning.start(request);
      if (!(await new Promise((resolve) => (waiting = resolve)))) return undefined;
    }
    const line = room.mirror.corners();
    if (line.length > 0) return line;
    it.complain("There is no path for this room yet. Choose another algorithm, or change the room in Explore.");
    return undefined;
  };

  button("connection-go").addEventListener("click", async () => {
    if (!it.view.can.ride || waiting) return;
    if (room.algorithm?.kind === "planner" && !it.live.isKnown()) {
      it.complain("A planned path needs a known room: choose Explore's room as the map, or a behaviour.");
      return;
    }
    if (it.live.isKnown() && placeOf(it.view) === "elsewhere") {
      const answer = await choose({
        title: "It isn't at the start",
        points: ["In a known room, the robot is assumed to start on the dashed circle, facing along its arrow. This one is elsewhere, so its position estimate would be wrong."],
        yes: "Put it at the start",
        other: "Start anyway",
      });
      if (answer === "no") return;
      if (answer === "yes") putAtStart();
    }
    const refusal = room.refusal();
    if (refusal) return it.complain(refusal);
    if (room.algorithm?.id === PROGRAM_PLANNER && !(await mayPlan(it))) return;
    const line = await corners();
    // After a stop or a loss of control it must not start.
    if (!line || !it.view.can.ride) return;
    it.connection.follow(room.followed());
    if (room.algorithm?.id === PROGRAM && !(await takeSeat(it))) return;
    if (!it.view.can.ride) return;
    it.live.map.set_planned(line);
    await it.connection.ride(line, wantsCleaning, room.algorithm?.kind === "planner" ? knots : undefined);
  });
  button("connection-end").addEventListener("click", () => {
    cancel();
    void it.request({ do: "stop" });
  });
  const putAtStart = () => {
    const [x, y, heading] = room.mirror.start();
    if (x !== undefined && y !== undefined && heading !== undefined) it.connection.virtual({ do: "put_at_start", x, y, heading });
  };
  button("connection-to-start").addEventListener("click", putAtStart);

  /** Where the virtual robot stands, seen from the start. @param {import("./types").ConnectionView} view */
  const placeOf = ({ virtual }) => (virtual ? room.mirror.start_place(...virtual.pose) : "at");

  return {
    cancel,
    /** @param {import("./types").ConnectionView} view */
    update(view) {
      if (changed(choice, "path", room.hasPath)) {
        choice.querySelector("option[value=path]")?.remove();
        if (room.hasPath) choice.append(new Option("Path from Floor plan", "path"));
      }
      const own = room.program();
      if (changed(choice, "program", own && own.id + own.title)) {
        choice.querySelector(`option[value^=${PROGRAM}]`)?.remove();
        if (own) choice.prepend(new Option(own.title, own.id));
      }
      if (document.activeElement !== choice) choice.value = room.algorithm?.id ?? "";
      const { can, is_moving: goes } = view;
      setHidden(button("connection-to-start"), goes || !it.live.isKnown() || placeOf(view) === "at");
      const where = it.live.isKnown() ? "It is assumed to start on the dashed circle, facing along its arrow." : "It starts from where it stands.";
      const charging = room.algorithm?.kind === "planner" ? " On a planned path it does not go home to charge." : "";
      const question = view.calibration.step === "asking" ? "Calibration waits for your answer: answer or skip it in Tools, Calibrate." : where + charging;
      setText(byId("connection-ride-note"), room.refusal() || (can.drive ? question : "Take control first."));
      setEnabled(button("connection-go"), can.ride);
      setEnabled(button("connection-end"), goes || waiting !== undefined);
      setEnabled(choice, !goes);
      // Those that don't clean leave them off, whatever is wanted for others.
      const canClean = room.mirror.cleans();
      cleans.disabled = goes || !canClean;
      if (changed(cleans, "shown", canClean)) cleans.checked = canClean && wantsCleaning;
      if (document.activeElement !== odometry) odometry.value = view.odometry;
      setEnabled(odometry, !goes && !view.is_recording);
    },
  };
}
