// @ts-check
// Parts of the page that the opening scene doesn't need, loaded when needed or after the first input.
import { button, byId, typed } from "../dom.js";
import { settingsOf } from "../settings-link.js";
import { updateFolds } from "./view.js";

/**
 * @typedef {import("../types").PageView} View
 * @typedef {(view: View) => void} Update
 * @typedef {{ begin: (view: View) => Promise<void>, update: Update }} Later
 */

/** Milliseconds until what could not be loaded is tried again, or isn't waited for any more; and until the page is kept for use offline. */
const PAUSE = 3000;

/** Milliseconds after which somebody who only watches sees what there is to try. */
const WATCHED = 4000;

/** On the first input, or when somebody has watched for a while, loads the parts that are likely to be needed next. */
const visit = new Promise((/** @type {(event: unknown) => void} */ come) => {
  setTimeout(come, WATCHED);
  for (const sign of ["pointermove", "pointerdown", "keydown"]) addEventListener(sign, come, { once: true, capture: true, passive: true });
});

/** Loads the parts that are needed at once. @param {import("../main.js").App} app @returns {Promise<Update>} the
 * function to be called in every frame */
export async function startLater(app) {
  const { behaviours } = app.catalogue;
  /** Whether their menu was asked for before it was there. */
  let wantsLayers = false;
  let wantsSmallRoom = false;
  button("search-small").addEventListener("click", () => (wantsSmallRoom = true), { once: true });
  const layers = button("layers-open");
  layers.disabled = false;
  layers.addEventListener("click", () => (wantsLayers = true), { once: true });
  const parts = [
    later(
      () => document.documentElement.classList.contains("embed"),
      () => import("../frame.js").then(({ startFrame }) => startFrame(app)),
    ),
    later(
      () => ["versus", "worst"].some((key) => settingsOf(app.followed).has(key)),
      () => import("./games.js").then(({ startGames }) => startGames(app)),
    ),
    later(
      () => typed("senses-fold", HTMLDetailsElement).open,
      () => import("./senses.js").then(({ startSenses }) => startSenses(app)),
    ),
    later(
      ({ algorithm }) => behaviours.some(({ id, manual }) => manual && id === algorithm),
      () => import("./manual.js").then(({ startManual }) => startManual(app)),
    ),
    later(
      ({ plan }) => plan?.asked_coverage != null,
      () => import("./trade-off.js").then(({ startTradeOff }) => startTradeOff(app)),
    ),
    later(
      ({ tool, selected }) => tool === "place" || selected >= 0,
      () => import("./placing.js").then(({ startPlacing }) => startPlacing(app)),
    ),
    later(
      ({ room }) => room.id === "" || hasOwnRooms(),
      () => import("./rooms-menu.js").then(({ startMenu }) => startMenu(app)),
    ),
    later(
      ({ room }) => Boolean(room.flat),
      () => import("./flat.js").then(({ startFlat }) => startFlat(app)),
    ),
    later(
      () => wantsSmallRoom,
      () => import("./small-room.js").then(({ startSmallRoom }) => startSmallRoom(app, wantsSmallRoom)),
    ),
    later(
      ({ state }) => state === "finished",
      () => import("./ending.js").then(({ startEnding }) => startEnding(app)),
    ),
    later(
      ({ tool, search, state }) => !byId("message").hidden || tool === "place" || search.text !== "" || state === "finished" || document.querySelector("#game, .over-floor, .embed .to-page") !== null || !byId("manual").hidden,
      () => import("./clear.js").then(({ startClear }) => startClear(app)),
    ),
    later(
      () => wantsLayers,
      () => import("./layers.js").then(({ startLayers }) => startLayers(app, wantsLayers)),
    ),
    later(
      ({ search }) => search.film !== null || search.text !== "",
      () => import("./film.js").then(({ startFilm }) => startFilm(app)),
    ),
  ];
  void visit.then(() => Promise.all([help(), import("../tips.js").then(({ startTips }) => startTips(app)), import("../planning.js"), import("./share.js"), import("../swipe.js").then(({ startSwipe }) => startSwipe()), ideas(app)])).then(() => setTimeout(whenIdle, PAUSE)).catch(console.warn);
  const view = app.playground.view();
  updateFolds(view);
  // A part that loads slowly doesn't delay the page.
  const patience = new Promise((end) => setTimeout(end, PAUSE));
  await Promise.race([Promise.all(parts.map((part) => part.begin(view))), patience]);
  return (now) => parts.forEach((part) => part.update(now));
}

/** What nobody waits for. */
const whenIdle = () => (window.requestIdleCallback ?? setTimeout)(() => void import("../offline/register.js").then(({ startOffline }) => startOffline()).catch(console.warn));

/** @param {import("../main.js").App} app */
const ideas = (app) => Promise.all([import("./try.js").then(({ startTry }) => startTry(app)), import("../learn/offer.js").then(({ offerTour }) => offerTour(app))]);

const help = () => import("../help.js").then(({ fillHelp }) => fillHelp(byId("help-text")));

function hasOwnRooms() {
  try {
    return localStorage.getItem("own-rooms") !== null;
  } catch {
    return false;
  }
}

/**
 * A part that is loaded later; `load` returns the function to be called in every frame from then on.
 * @param {(view: View) => boolean} isNeeded
 * @param {() => Promise<Update>} load
 * @returns {Later}
 */
function later(isNeeded, load) {
  /** @type {Update | undefined} */
  let ready;
  /** @type {Promise<void> | undefined} */
  let coming;
  const fetch = () =>
    (coming ??= load().then(
      (update) => void (ready = update),
      (error) => {
        console.warn(error);
        setTimeout(() => (coming = undefined), PAUSE);
      },
    ));
  void visit.then(fetch);
  return {
    /** Waits for the part if it is needed from the beginning. */
    begin: async (view) => void (isNeeded(view) && (await fetch())),
    update: (view) => {
      if (ready) ready(view);
      else if (isNeeded(view)) void fetch();
    },
  };
}
