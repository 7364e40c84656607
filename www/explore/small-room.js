// @ts-check
// Where a room is too large for a search to be shown, a small one is offered.
import { byId } from "../dom.js";
import { toast } from "../messages.js";
import { dismissSheet } from "../sheets.js";

/** Small enough for almost every cell size, and with furniture, so that planners have something to weigh. */
const ROOM = "bedroom";
/** Least side of its planning cells, m. */
const CELL = 0.07;

/** @param {import("../main.js").App} app @param {boolean} isPressed Whether it was asked for before this was there. */
export function startSmallRoom(app, isPressed) {
  const show = () => {
    const isFine = app.view.cell_size_m < CELL;
    app.act((p) => {
      p.select_room(ROOM);
      if (isFine) p.set_cell_size(CELL);
      p.show_search(true);
    });
    if (isFine) toast("Cells of 7 cm: smaller ones are too many for a film");
    if (!dismissSheet("setup")) byId("show-search").focus();
  };
  byId("search-small").addEventListener("click", show);
  if (isPressed) show();
  return () => {};
}
