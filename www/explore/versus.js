// @ts-check
// You against the algorithm: in the same room from the same start, who sweeps more in the same time?
import { fill, make, select } from "../dom.js";
import { clock, percent } from "../format.js";
import { without } from "../settings-link.js";
import { act, send } from "./games.js";
import { labelled, scoreRow, sweptAt } from "./score.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("../types").PageView} View
 * @typedef {{ rival: string, seconds: number, beat: number | null }} Terms `beat`: what somebody else has swept, 0 to 1.
 */

/** Times to choose from, s; and the one that is proposed. */
const TIMES = [30, 60, 120, 300];
const USUAL = 60;

/** @param {App} app @param {import("./games.js").Card} card @returns {import("./games.js").Game} */
export function startVersus(app, card) {
  const { planners, behaviours } = app.catalogue;
  /** Those that clean, and are quick to plan. */
  const rivals = [...planners.filter(({ fast }) => fast), ...behaviours.filter(({ cleans, manual }) => cleans && !manual)];
  const person = behaviours.find(({ manual }) => manual)?.id ?? "";
  /** @type {Terms} */
  let terms = { rival: rivals[0]?.id ?? "", seconds: USUAL, beat: null };
  /** @type {"terms" | "rival" | "you" | "over"} */
  let phase = "terms";
  /** Whether a challenge waits for Start, and whether a link brought the game: a reload brings it again. */
  let [isOffered, isChallenge] = [false, false];
  /** Time and coverage of the rival's run, one behind the other. @type {Float64Array} */
  let curve = new Float64Array();
  /** What must not change meanwhile. */
  let place = "";
  let last = 0;
  let counts = true;
  let score = 0;
  /** The speed at which the user watches algorithms; the rival's is the fastest meanwhile. @type {number | undefined} */
  let pace;
  let told = () => {};

  const titleOf = (/** @type {string} */ id) => rivals.find((one) => one.id === id)?.title ?? id;
  /** The link but for what may change. */
  const placeNow = () => `${app.playground.room_version()} ${without(app.playground.link(), "speed", "show", "search")}`;

  function offer() {
    phase = "terms";
    isChallenge = false;
    terms = { ...terms, rival: rivals.some(({ id }) => id === app.view.algorithm) ? app.view.algorithm : terms.rival, beat: null };
    const rival = make("select", { id: "versus-rival" });
    fill(rival, rivals.map(({ id, title }) => [id, title]));
    rival.value = terms.rival;
    const time = make("select", { id: "versus-time" });
    fill(time, TIMES.map((seconds) => [String(seconds), `${clock(seconds)} min`]));
    time.value = String(terms.seconds);
    card.show(
      "You against the algorithm",
      make("p", {}, "Same room, same start: who sweeps more before time runs out?"),
      make("div", { className: "choices" }, labelled("Against", rival), labelled("Time", time, "field short"), act("Start", () => begin({ rival: rival.value, seconds: Number(time.value), beat: null }), "primary")),
    );
  }

  /** First the algorithm drives. @param {Terms} next */
  function begin(next) {
    terms = next;
    phase = "rival";
    const worked = app.act((p) => {
      p.select_algorithm(terms.rival);
      pace ??= p.view().speed;
      p.set_speed(0);
      p.reset();
      p.play();
    });
    if (!worked) return card.close();
    place = placeNow();
    const bar = make("progress", { max: 1, value: 0, "aria-label": "Progress" });
    card.show(`${titleOf(terms.rival)} drives first`, make("p", {}, `Its ${clock(terms.seconds)} minutes are played fast. Then it is your turn.`), bar);
    told = () => void (bar.value = Math.min(1, app.view.time_s / terms.seconds));
  }

  /** @param {import("../main.js").App["playground"]} p */
  function atUsualPace(p) {
    if (pace !== undefined) p.set_speed(pace);
    pace = undefined;
  }

  /** The algorithm has had its time. */
  function yourTurn() {
    phase = "you";
    // At a higher speed the time would be over before one can act.
    select("speed").disabled = true;
    counts = true;
    last = 0;
    const worked = app.act((p) => {
      // Driving by hand has its own speed, and leaves this one for others.
      atUsualPace(p);
      // Whoever plays sees all of the room.
      p.fit();
      p.select_algorithm(person);
      p.set_tool("view");
      p.set_speed(1);
      p.reset();
    });
    if (!worked) return card.close();
    place = placeNow();
    const [time, yours, theirs] = [scoreRow("time", "Time left"), scoreRow("you", "You"), scoreRow("", titleOf(terms.rival))];
    const toBeat = terms.beat === null ? undefined : scoreRow("", "To beat");
    const rows = [time, yours, theirs, ...(toBeat ? [toBeat] : [])];
    card.show("Your turn", make("p", { className: "how" }, "Drive with the arrow keys or the joystick."), make("div", { className: "scores" }, ...rows.flatMap(({ nodes }) => nodes)));
    document.getElementById("floor")?.focus();
    told = () => {
      const left = Math.max(0, terms.seconds - app.view.time_s);
      time.show(left / terms.seconds, app.view.time_s === 0 ? `${clock(left)} from your first move` : clock(left));
      // The best of all fills its bar: in a large room all of them sweep but a few per cent.
      const most = Math.max(at(terms.seconds), terms.beat ?? 0, app.view.coverage, 1e-9);
      const swept = (/** @type {number} */ share) => /** @type {const} */ ([share / most, `${percent(share)} %`]);
      yours.show(...swept(app.view.coverage));
      theirs.show(...swept(at(app.view.time_s)));
      toBeat?.show(...swept(terms.beat ?? 0));
    };
  }

  /** What the algorithm had swept after so many seconds, 0 to 1. @param {number} seconds */
  const at = (seconds) => sweptAt(curve, seconds);

  function over() {
    phase = "over";
    select("speed").disabled = false;
    app.act((p) => p.pause());
    score = app.view.coverage;
    const rival = at(terms.seconds);
    const verdict = Math.abs(score - rival) < 5e-4 ? "A draw." : score > rival ? "You win." : `${titleOf(terms.rival)} wins.`;
    const beaten = terms.beat === null || !counts ? "" : score > terms.beat ? ` You also beat the ${percent(terms.beat)} % of whoever sent this.` : ` Whoever sent this swept ${percent(terms.beat)} %.`;
    card.show(
      verdict,
      make("p", { role: "status" }, `In ${clock(terms.seconds)} you swept ${percent(score)} %, ${titleOf(terms.rival)} ${percent(rival)} %.${beaten}${counts ? "" : " It doesn't count: the robot was lifted or the time line was used."}`),
      make("div", { className: "choices" }, act("Again", yourTurn, "primary"), ...(counts ? [act("Challenge others", () => send(app))] : []), act("Another algorithm", offer)),
    );
    told = () => {};
  }

  return {
    key: "versus",
    offer,
    follow(value) {
      const [rival = "", seconds = "", beat = ""] = value.split(",");
      if (!rivals.some(({ id }) => id === rival)) return;
      const limit = Math.min(3600, Math.max(5, Number(seconds) || USUAL));
      const share = beat === "" || !(Number(beat) >= 0 && Number(beat) <= 100) ? null : Number(beat) / 100;
      terms = { rival, seconds: limit, beat: share };
      isOffered = isChallenge = true;
      card.show(
        "You are challenged",
        make("p", {}, `Sweep more of this room in ${clock(limit)} minutes than ${titleOf(rival)}${share === null ? "" : `, and more than the ${percent(share)} % of whoever sent this`}.`),
        make("div", { className: "choices" }, act("Start", () => begin(terms), "primary")),
      );
    },
    update(view) {
      // Nothing drives before Start.
      if (isOffered && phase === "terms" && view.state === "playing") {
        isOffered = false;
        app.act((p) => p.reset());
      }
      if (phase === "rival") {
        if (placeNow() !== place || view.state === "failed") return card.close();
        told();
        if (view.state !== "planning" && (view.time_s >= terms.seconds || view.state === "finished")) {
          curve = app.playground.coverage_curve();
          yourTurn();
        }
        return;
      }
      if (phase !== "you" && phase !== "over") return;
      // Another room or robot, or no longer driven by hand: another game.
      if (placeNow() !== place) return card.close();
      if (phase === "over") return;
      if (view.speed !== 1) app.act((p) => p.set_speed(1));
      // Back to the start is a new try; back in time is a second chance that the algorithm hadn't.
      if (view.time_s === 0) counts = true;
      else if (view.time_s < last || view.is_lifted) counts = false;
      last = view.time_s;
      told();
      if (view.time_s >= terms.seconds) over();
    },
    end() {
      phase = "terms";
      select("speed").disabled = false;
      isChallenge = false;
      if (pace !== undefined) app.act(atUsualPace);
    },
    link: () => (!isChallenge && (phase === "terms" || phase === "rival") ? "" : [terms.rival, terms.seconds, ...(phase === "over" && counts ? [percent(score)] : terms.beat === null ? [] : [percent(terms.beat)])].join(",")),
  };
}
