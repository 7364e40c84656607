// @ts-check
// Where a room is too large for a search to be shown, a small one is offered.
import { byId } from "../dom.js";

/** Large enough for something to happen, and small enough for every cell size of the menu's middle. */
const ROOM = "lshape";
/** Least side of its planning cells, m. */
const CELL = 0.15;

/** @param {import("../main.js").App} app */
export function startSmallRoom(app) {
  byId("search-small").addEventListener("click", () => {
    app.act((p) => {
      p.select_room(ROOM);
      if (app.view.cell_size_m < CELL) p.set_cell_size(CELL);
      p.show_search(true);
    });
    byId("show-search").focus();
  });
  return () => {};
}
