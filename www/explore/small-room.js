// @ts-check
// Where a room is too large for a search to be shown, a small one is offered.
import { byId, make, setHidden } from "../dom.js";

/** Large enough for something to happen, and small enough for every cell size of the menu's middle. */
const ROOM = "lshape";
/** Least side of its planning cells, m. */
const CELL = 0.15;

/** @param {import("../main.js").App} app @returns {(view: import("../types").PageView) => void} */
export function startSmallRoom(app) {
  const title = app.catalogue.rooms.find(({ id }) => id === ROOM)?.title ?? ROOM;
  const offer = make("button", { type: "button", id: "search-small", hidden: true }, `Show it in ${title}`);
  offer.addEventListener("click", () => {
    app.act((p) => {
      p.select_room(ROOM);
      if (app.view.cell_size_m < CELL) p.set_cell_size(CELL);
      p.show_search(true);
    });
    byId("show-search").focus();
  });
  byId("search-refusal").after(offer);
  return ({ search }) => setHidden(offer, !search.fits_small);
}
