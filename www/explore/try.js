// @ts-check
// Things to try: a list beside the floor, for those who don't know where to begin. Loaded with the first input.
import { byId, changed, make } from "../dom.js";
import { complain, textOf } from "../messages.js";
import { style } from "../parts.js";
import { pickUp } from "./carry.js";

/** @typedef {import("../main.js").App} App */

/** A link of the page, as everything that it leads to. @param {string} link */
const follow = (link) => void (location.hash = link);

/** @type {[title: string, what: string, how: (app: App) => unknown][]} */
const IDEAS = [
  ["Random walk against lanes", "Which one cleans the living room first?", () => follow("room=living&tab=compare&vs=boustrophedon&behaviours=random_walk&go=1")],
  ["You against the algorithm", "Drive by hand: can you sweep more in the same time?", (app) => import("./games.js").then(({ offerVersus }) => offerVersus(app))],
  ["Break it", "Draw the room that this planner does worst in.", (app) => import("./games.js").then(({ offerWorst }) => offerWorst(app))],
  ["A cat in the way", "A robot that only has its bumper meets the cat.", () => follow("room=living&behaviour=random_walk&speed=4")],
  ["Kidnap the robot", "Put it down elsewhere. Does it notice?", (app) => lift(app)],
  ["A race of six", "Six ideas in the same room, at the same time.", () => follow("room=bedroom&tab=compare&vs=boustrophedon,spiral,spiral_stc,snake&behaviours=random_walk,spiral_out&go=1")],
  ["Your own room", "Draw it, or load a floor plan.", (app) => import("./rooms.js").then(({ openRooms }) => openRooms(app))],
];

/** A robot that runs is lifted; one that doesn't sets off first. @param {App} app */
function lift(app) {
  if (!app.view.can.lift) app.act((p) => p.play());
  byId("stage").scrollIntoView({ block: "nearest" });
  // The view of the next frame knows whether it can be.
  requestAnimationFrame(() => requestAnimationFrame(() => pickUp(app)));
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
