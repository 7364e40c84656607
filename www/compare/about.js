// @ts-check
// About one algorithm: its path in this room, and its explainer.
import { button, byId, setHidden, typed } from "../dom.js";
import { explain } from "../explainer.js";

/** @param {import("./tab.js").Comparing} it @returns {(entrant: number) => void} */
export function startAbout(it) {
  const { app, comparison } = it;
  const dialog = typed("about", HTMLDialogElement);
  let shown = 0;
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  /** @param {(p: App["playground"]) => void} what @typedef {import("../main.js").App} App */
  const explore = (what) => {
    dialog.close();
    if (app.act(what)) byId("tab-explore").click();
  };
  button("about-explore").addEventListener("click", () =>
    explore((p) => {
      const { id: algorithm, params } = it.view.entrants[shown] ?? { id: "", params: {} };
      p.select_algorithm(algorithm);
      for (const [id, value] of Object.entries(params)) p.set_param(id, String(value));
    }),
  );

  return (entrant) => {
    const { id: algorithm = "", kind, title = "" } = it.view.entrants[entrant] ?? {};
    const planner = (kind === "behaviour" ? app.catalogue.behaviours : app.catalogue.planners).find(({ id }) => id === algorithm);
    if (!planner) return;
    shown = entrant;
    byId("about-title").textContent = title;
    void explain(byId("about-text"), planner, app.catalogue.rooms, (room) =>
      explore((p) => {
        p.select_room(room);
        p.select_algorithm(planner.id);
      }),
    );
    dialog.showModal();
    // A new canvas: the old one and its content are dropped.
    const old = byId("about-path");
    const canvas = /** @type {HTMLCanvasElement} */ (old.cloneNode());
    old.replaceWith(canvas);
    canvas.hidden = false;
    canvas.setAttribute("aria-label", `Path of ${planner.title} in ${app.view.room.title}`);
    const drawn = comparison.draw_path(entrant, canvas, canvas.clientWidth, canvas.clientHeight, devicePixelRatio);
    setHidden(byId("about-none"), drawn || kind === "behaviour");
    canvas.hidden = !drawn;
  };
}
