// @ts-check
// What is known of the file and the room that comes of it.
import { button, byId, setAttribute, setHidden, setText } from "../dom.js";

/** @typedef {import("./types").DraftView} DraftView */

/** @param {import("./tab.js").Desk} it @returns {(view: DraftView | undefined) => void} */
export function startFacts(it) {
  button("draft-doors-close").addEventListener("click", async () => {
    const doors = it.view?.doors;
    if (doors) await it.set({ gap: doors.gap });
    byId("draft-floor").focus();
  });
  return show;
}

/** @param {DraftView | undefined} view */
function show(view) {
  setAttribute(byId("place-draft"), "data-kind", view?.kind ?? "");
  setHidden(byId("draft-empty"), view !== undefined);
  setHidden(byId("draft-settings"), view === undefined);
  setHidden(byId("draft-none"), view !== undefined);
  setText(byId("draft-name"), view?.name ?? "No floor plan yet");
  setText(byId("draft-facts"), view ? facts(view) : "");
  setAttribute(byId("draft-floor"), "aria-label", view?.words ?? "Floor plan: nothing here yet");
  setText(byId("draft-said"), view?.words ?? "");
  setText(byId("draft-fault"), view?.fault ?? "");
  setText(byId("draft-title"), view?.name ?? "No floor plan yet");
  setText(byId("draft-result"), view ? result(view) : "Choose or drop a file to see it here with its size.");
  button("draft-use").disabled = !view?.room;
  showDoors(view);
}

/** Doors that the room reaches through. @param {DraftView | undefined} view */
function showDoors(view) {
  const doors = view?.doors;
  setHidden(byId("draft-doors"), !doors);
  if (doors) {
    const { count, gap, floor_m2 } = doors;
    const opening = count === 1 ? "an opening" : `${count} openings`;
    setText(byId("draft-doors-text"), `${view?.room ? "This room reaches on" : "The floor here runs out"} through ${opening} as wide as a door. With ${count === 1 ? "it" : "them"} closed it has ${floor_m2.toFixed(1)} m² of floor.`);
    setText(button("draft-doors-close"), `Close gaps up to ${gap.toFixed(2)} m`);
  }
}

/** @param {DraftView} view */
function facts({ kind, size, strokes, layers, room, left_out }) {
  const what = kind === "drawing" ? `${strokes.toLocaleString("en")} strokes on ${layers.length} layers` : room ? `${room.cells[0]} × ${room.cells[1]} cells of ${(100 * room.resolution).toLocaleString("en", { maximumFractionDigits: 2 })} cm` : "";
  return [size && `${kind === "drawing" ? "all that is drawn" : "all of it"}: ${size}`, what, left_out.length && `not drawn: ${left_out.join(", ")}`].filter(Boolean).join(" · ");
}

/** @param {DraftView} view */
function result({ room, settings, fault }) {
  if (!room) return settings.metre === null ? "How long is a unit of the drawing? Choose it first." : fault || "No room yet.";
  const { width_m, height_m, floor_m2, cells, objects, gaps } = room;
  const more = [objects && `${objects} obstacles`, gaps && `${gaps} ${gaps === 1 ? "gap" : "gaps"} closed`].filter(Boolean);
  return [`Room ${width_m.toFixed(1)} × ${height_m.toFixed(1)} m, walls included`, `${floor_m2.toFixed(1)} m² of floor`, `${cells[0]} × ${cells[1]} cells`, ...more].join(" · ");
}
