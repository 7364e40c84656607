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
  ["Random walk against lanes", "Which one cleans the living room first?", () => follow("room=living&tab=compare&vs=boustrophedon&behaviours=random_walk")],
  ["You against the algorithm", "Drive by hand: can you sweep more in the same time?", (app) => import("./games.js").then(({ offerVersus }) => offerVersus(app))],
  ["Break it", "Draw the room that this planner does worst in.", (app) => import("./games.js").then(({ offerWorst }) => offerWorst(app))],
  ["A cat in the way", "A robot that only has its bumper meets the cat.", () => follow("room=living&behaviour=random_walk&speed=4")],
  ["Kidnap the robot", "Put it down elsewhere. Does it notice?", (app) => lift(app)],
  ["A race of six", "Six ideas in the same room, at the same time.", () => follow("room=bedroom&tab=compare&vs=boustrophedon,spiral,spiral_stc,snake&behaviours=random_walk,spiral_out")],
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
  const items = IDEAS.map(([title, what, how]) => {
    const go = make("button", { type: "button", className: "idea" }, make("b", {}, title), make("span", { className: "note" }, what));
    go.addEventListener("click", () => {
      // On a small screen the list is a sheet over the floor.
      if (byId("try").classList.contains("open")) button.click();
      Promise.resolve(how(app)).catch((error) => complain(`This could not be loaded (${textOf(error)}). Check the connection, then try again.`));
    });
    return make("li", { "data-tip": what }, go);
  });
  const close = make("button", { type: "button", className: "quiet square sheet-close", "aria-label": "Close" });
  close.append(/** @type {Node} */ (byId("setup").querySelector(".sheet-close .icon")).cloneNode(true));
  const fold = make("details", { className: "fold", open: isWanted() }, make("summary", {}, make("span", {}, "Try this")), make("ul", { className: "ideas" }, ...items));
  const head = make("div", { className: "sheet-head" }, make("h2", { id: "try-title" }, "Try this"), close);
  byId("facts").after(make("section", { className: "sheet try", id: "try", "aria-labelledby": "try-title" }, head, fold));
  // The first one is there to be seen; who folds it away has seen it.
  fold.addEventListener("toggle", () => changed(fold, "open", fold.open) && want(fold.open));

  const button = make("button", { type: "button", "data-sheet": "try", "aria-expanded": "false", "aria-controls": "try" }, "Try this");
  button.prepend(star());
  byId("panel-explore").querySelector(".sheet-bar")?.append(button);
}

/** The sign of the list. */
function star() {
  const sign = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  sign.setAttribute("class", "icon");
  sign.setAttribute("viewBox", "0 0 24 24");
  sign.setAttribute("aria-hidden", "true");
  sign.innerHTML = '<path d="M12 3.5l2.5 5.6 6 .6-4.5 4.1 1.3 6-5.3-3.1-5.3 3.1 1.3-6L3.5 9.7l6-.6z" />';
  return sign;
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
