// @ts-check
// The text about a search, and its film: pause, picture by picture, legend.
import { button, byId, changed, make, setAttribute, setEnabled, setHidden, setText } from "../dom.js";
import { style } from "../parts.js";

/** @type {[name: string, title: string, tip: string, samples: number][]} */
const KEYS = [
  ["walk", "Path", "The path at this moment of the search.", 1],
  ["tint", "About to change", "Cells that the next improvement visits in a different order.", 1],
  ["part", "Parts kept", "The path is cut where it changes. Each part has its own colour; squares mark its ends.", 4],
  ["new", "New", "The new connections between the parts.", 1],
];

/** @param {import("../main.js").App} app @returns {Promise<(view: import("../types").PageView) => void>} */
export async function startFilm(app) {
  await style(new URL("./film.css", import.meta.url).href);
  button("film-back").addEventListener("click", () => app.act((p) => p.turn_film(false)));
  button("film-next").addEventListener("click", () => app.act((p) => p.turn_film(true)));
  button("film-play").addEventListener("click", () => app.act((p) => p.hold_film(app.view.search.film?.runs ?? false)));
  const stage = byId("stage");
  const keys = KEYS.map(([name, title, tip, samples]) =>
    make(
      "div",
      { className: "key film-key", "data-tip": tip, tabIndex: 0 },
      make("span", { className: `film-sample ${name}`, "aria-hidden": "true" }, ...Array.from({ length: samples }, () => make("i"))),
      make("span", {}, title),
    ),
  );
  byId("legend").prepend(...keys);

  return ({ state, plan, search: { film } }) => {
    setHidden(byId("film"), !film);
    // A path in metres isn't improved cell by cell.
    if (keys[1]) setHidden(keys[1], plan?.reachable_cells === 0);
    const isSeen = film !== null && film.at < film.pictures && state !== "playing" && state !== "seeking";
    setAttribute(stage, "data-film", String(isSeen));
    if (!film) return;
    const { at, pictures, runs } = film;
    const isOver = at >= pictures;
    setEnabled(button("film-back"), at > 0);
    setEnabled(button("film-next"), !isOver);
    setText(byId("film-at"), isOver ? "" : `${at + 1} of ${pictures}`);
    const name = runs ? "Pause the film" : isOver ? "Play again" : "Play the film";
    if (!changed(button("film-play"), "name", name)) return;
    button("film-play").setAttribute("aria-label", name);
    byId("film-icon").setAttribute("href", runs ? "#i-pause" : isOver ? "#i-reset" : "#i-play");
  };
}
