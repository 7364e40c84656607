// @ts-check
// The film of a search: pause, and picture by picture.
import { button, byId, changed, setEnabled, setHidden, setText } from "./dom.js";

/** @param {import("./main.js").App} app @returns {(view: import("./types").View) => void} */
export function startFilm(app) {
  button("film-back").addEventListener("click", () => app.act((p) => p.turn_film(false)));
  button("film-next").addEventListener("click", () => app.act((p) => p.turn_film(true)));
  button("film-play").addEventListener("click", () => app.act((p) => p.hold_film(app.view.search.film?.runs ?? false)));
  return ({ search: { film } }) => {
    setHidden(byId("film"), !film);
    if (!film) return;
    const { at, pictures, runs } = film;
    const isOver = at >= pictures;
    setEnabled(button("film-back"), at > 0);
    setEnabled(button("film-next"), !isOver);
    setText(byId("film-at"), isOver ? "" : `${at + 1} of ${pictures}`);
    const name = runs ? "Pause the film" : isOver ? "Show it again" : "Show the film";
    if (!changed(button("film-play"), "name", name)) return;
    button("film-play").setAttribute("aria-label", name);
    byId("film-icon").setAttribute("href", runs ? "#i-pause" : isOver ? "#i-reset" : "#i-play");
  };
}
