// @ts-check
// Generated flats: each is told by a seed and a size, and made in a worker. Nothing of them is kept: the link has their name.
import { byId, make, setHidden } from "../dom.js";
import { complain, textOf } from "../messages.js";

/** @typedef {import("../main.js").App} App */

/** Areas to choose from, m², as in a flat's name, and what they are called; the first is any that can be made. */
const AREAS = [["", "any"], ["~area:25..45", "small"], ["~area:45..75", "medium"], ["~area:75..120", "large"]];

/** Names of flats by their lineage, with the version as which they were made: changed, they are own rooms. @type {Map<number, { name: string, version: number }>} */
const made = new Map();
/** The flat that was asked for last. */
let asked = "";

/** The name of the flat that is shown, as it was made. @param {App} app */
export function flatOf({ view, playground }) {
  const flat = view.room.id ? undefined : made.get(playground.room_lineage());
  return flat?.version === playground.room_version() ? flat?.name : undefined;
}

/** Makes and shows the flat with that name. Throws what is wrong, for users. @param {App} app @param {string} name */
export async function openFlat(app, name) {
  asked = name;
  const { makeFlat } = await import("../workers.js");
  const map = await makeFlat(name).catch((error) => {
    throw error instanceof Error ? `The flat could not be made (${error.message}). Check the connection, then try again.` : error;
  });
  // Whoever asks twice gets the second.
  if (asked !== name || !app.act((p) => p.take_map(map))) return;
  made.set(app.playground.room_lineage(), { name, version: app.playground.room_version() });
}

/** Another flat of the same kind as the one that is shown, if one is. @param {App} app */
export function anotherFlat(app) {
  const { area = "", more = "" } = app.view.room.flat ?? {};
  return openFlat(app, `${Math.floor(Math.random() * 1e6)}${area}${more}`);
}

/** Seed and size of the flat, under the menu of rooms. @param {App} app @returns {(view: import("../types").PageView) => void} */
export function startFlat(app) {
  const seed = make("input", { type: "number", id: "flat-seed", min: "0", max: "4294967295", step: "1", inputMode: "numeric" });
  const area = make("select", { id: "flat-area" }, ...AREAS.map(([value = "", label = ""]) => new Option(label, value)));
  const other = make("button", { type: "button", id: "flat-other" }, "Another flat");
  const field = (/** @type {string} */ label, /** @type {HTMLElement} */ control, /** @type {string} */ tip) =>
    make("label", { className: "field inline", "data-tip": tip }, make("span", { className: "label" }, label), control);
  const fields = make(
    "div",
    { className: "params", id: "flat", hidden: true },
    field("Flat number", seed, "The same number gives the same flat on every machine."),
    field("Size", area, "Small: 25 to 45 m², medium: to 75 m², large: to 120 m²."),
    other,
  );
  byId("room-note").after(fields);

  /** The name that the fields show, and what it has besides seed and size. */
  let [shown, rest] = ["", ""];
  const take = async () => {
    const isSeed = /^\d{1,10}$/.test(seed.value) && Number(seed.value) <= 0xffffffff;
    if (!isSeed) throw `A flat's number can't be "${seed.value}"; use a whole number from 0 to 4294967295.`;
    await openFlat(app, `${Number(seed.value)}${area.value}${rest}`);
  };
  const refused = (/** @type {unknown} */ error) => {
    complain(textOf(error));
    // The fields go back to what holds.
    shown = "";
  };
  for (const control of [seed, area]) control.addEventListener("change", () => void take().catch(refused));
  other.addEventListener("click", () => void anotherFlat(app).catch(refused));

  return ({ room }) => {
    setHidden(fields, !room.flat);
    if (!room.flat) return;
    const { seed: number, area: range, more } = room.flat;
    if (shown === number + range + more) return;
    shown = number + range + more;
    rest = more;
    seed.value = number;
    if (![...area.options].some(({ value }) => value === range)) area.append(new Option(`${range.slice(range.indexOf(":") + 1).replace("..", " to ")} m²`, range));
    area.value = range;
  };
}
