// @ts-check
// Things to try: a list beside the floor, for those who don't know where to begin. Loaded with the first input.
import { byId, changed, make } from "../dom.js";
import { complain, textOf } from "../messages.js";
import { style } from "../parts.js";
import { pickUp } from "./carry.js";

/** @typedef {import("../main.js").App} App */

/** Follows a plan, and so can be lost. */
const PLANNER = "boustrophedon";
/** How long a robot may take to set off before it is left where it is. */
const PATIENCE_MS = 10_000;

/** A link of the page, as everything that it leads to. @param {string} link */
const follow = (link) => void (location.hash = link);

/** @type {[title: string, what: string, how: (app: App) => unknown][]} */
const IDEAS = [
  ["Random walk against lanes", "Which one cleans the living room first?", () => follow("room=living&tab=compare&vs=boustrophedon&behaviours=random_walk&go=1")],
  ["Cells against metres", "Lanes in cells and lanes in metres: which plan cleans the flat a quarter of an hour faster?", () => follow("room=flat&tab=compare&vs=boustrophedon,lanes&go=1")],
  ["You against the algorithm", "Drive by hand: can you sweep more in the same time?", (app) => import("./games.js").then(({ offerVersus }) => offerVersus(app))],
  ["Break it", "Draw the room that this planner does worst in.", (app) => import("./games.js").then(({ offerWorst }) => offerWorst(app))],
  ["A cat in the way", "A robot that only has its bumper meets the cat.", (app) => meetCat(app)],
  ["Kidnap the robot", "Put it down elsewhere. Does it notice?", (app) => lift(app)],
  ["A race of six", "Six ideas in the same room, at the same time.", () => follow("room=bedroom&tab=compare&vs=boustrophedon,spiral,spiral_stc,snake&behaviours=random_walk,spiral_out&go=1")],
  ["Your own room", "Draw it, or load a floor plan.", (app) => import("./rooms.js").then(({ openRooms }) => openRooms(app))],
];

/** The cat lives in the living room, where the robot sets off. @param {App} app */
function meetCat(app) {
  app.act((p) => {
    p.select_room("living");
    p.select_algorithm("random_walk");
    p.set_speed(4);
    p.play();
  });
}

/** A robot that runs is lifted; one that doesn't sets off first. One that drives at random has nothing to notice. @param {App} app */
function lift(app) {
  if (app.view.kind !== "planner") app.act((p) => p.select_algorithm(PLANNER));
  byId("stage").scrollIntoView({ block: "nearest" });
  const until = performance.now() + PATIENCE_MS;
  // A view of the frames to come knows that it can be.
  const next = () => {
    const { can, state } = app.view;
    if (can.lift) return void pickUp(app);
    if (state !== "playing" && state !== "planning") app.act((p) => p.play());
    if (state !== "failed" && performance.now() < until) requestAnimationFrame(next);
  };
  requestAnimationFrame(() => requestAnimationFrame(next));
}

/** Puts the list beside the floor. @param {App} app */
export async function startTry(app) {
  await style(new URL("./try.css", import.meta.url).href);
  const sheet = byId("try");
  const items = IDEAS.map(([title, what, how]) => {
    const go = make("button", { type: "button", className: "idea" }, make("b", {}, title), make("span", { className: "note" }, what));
    go.addEventListener("click", () => {
      // On a small screen the list is a sheet over the floor.
      if (sheet.classList.contains("open")) close.click();
      // One thing at a time.
      document.querySelector("#game:not([hidden]) header button")?.dispatchEvent(new MouseEvent("click"));
      // A film would hide the robot.
      app.act((p) => p.show_search(false));
      Promise.resolve(how(app)).catch((error) => complain(`This could not be loaded (${textOf(error)}). Check the connection, then try again.`));
    });
    return make("li", { "data-tip": what }, go);
  });
  const close = make("button", { type: "button", className: "quiet square sheet-close", "aria-label": "Close" });
  close.append(/** @type {Node} */ (byId("setup").querySelector(".sheet-close .icon")).cloneNode(true));
  const fold = make("details", { className: "fold", open: isWanted() }, make("summary", {}, make("span", {}, "Try this")), make("ul", { className: "ideas" }, ...items));
  const head = make("div", { className: "sheet-head" }, make("h2", { id: "try-title" }, "Try this"), close);
  sheet.append(head, fold);
  sheet.hidden = false;
  // The first one is there to be seen; who folds it away has seen it.
  fold.addEventListener("toggle", () => changed(fold, "open", fold.open) && want(fold.open));
}

const KEY = "try";

function isWanted() {
  try {
    return localStorage.getItem(KEY) !== "folded";
  } catch {
    return true;
  }
}

/** @param {boolean} isOpen */
function want(isOpen) {
  try {
    localStorage.setItem(KEY, isOpen ? "open" : "folded");
  } catch {
    // Without storage it is open again the next time.
  }
}
