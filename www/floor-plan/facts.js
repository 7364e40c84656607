// @ts-check
// Facts about the file and the resulting room.
import { button, byId, changed, make, setAttribute, setHidden, setText } from "../dom.js";
import { metres } from "../format.js";

/** @typedef {import("./types").FloorPlanView} FloorPlanView */

/** Cells with shorter sides, m, need no smaller ones to show a door. */
const SMALL_CELLS = 0.02;

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: FloorPlanView | undefined) => void} */
export function startFacts(it) {
  button("floor-plan-doors-close").addEventListener("click", async () => {
    const doors = it.view?.doors;
    if (doors) await it.set({ gap: doors.gap });
    byId("floor-plan-floor").focus();
  });
  button("floor-plan-notice-close").addEventListener("click", async () => {
    const outer = it.view?.opens ? 0 : it.view?.closes;
    if (typeof outer === "number") await it.set({ outer });
    byId("floor-plan-floor").focus();
  });
  button("floor-plan-asks-yes").addEventListener("click", () => void it.set({ confirmed: it.view?.settings.metre ?? null }));
  button("floor-plan-asks-scale").addEventListener("click", () => button("floor-plan-scale").click());
  const papers = byId("floor-plan-asks-papers");
  return (view) => {
    show(view);
    if (!changed(papers, "papers", JSON.stringify(view?.papers))) return;
    papers.replaceChildren(...(view?.papers ?? []).map(({ name, metre, size }) => make("button", { type: "button", title: size, onclick: () => void it.set({ metre }) }, name)));
  };
}

/** @param {FloorPlanView | undefined} view */
function show(view) {
  setAttribute(byId("panel-floor-plan"), "data-kind", view?.kind ?? "");
  setHidden(byId("floor-plan-empty"), view !== undefined);
  setHidden(byId("floor-plan-settings"), view === undefined);
  setHidden(byId("floor-plan-none"), view !== undefined);
  setText(byId("floor-plan-name"), view?.name ?? "No floor plan yet");
  setText(byId("floor-plan-facts"), view ? facts(view) : "");
  setAttribute(byId("floor-plan-floor"), "aria-label", view?.words ?? "Floor plan: empty");
  setText(byId("floor-plan-said"), view?.words ?? "");
  setText(byId("floor-plan-fault"), view?.fault ?? "");
  setText(byId("floor-plan-title"), view?.name ?? "No floor plan yet");
  setText(byId("floor-plan-result"), view ? result(view) : "Choose or drop a file to see it here with its size.");
  button("floor-plan-use").disabled = !view?.room;
  showDoors(view);
  showCut(view);
  showKey(view);
  setHidden(byId("floor-plan-asks"), !view?.asks);
  setHidden(byId("floor-plan-notice"), !view?.notice);
  setText(byId("floor-plan-notice-text"), view?.notice ?? "");
  setHidden(byId("floor-plan-notice-close"), !view?.closes && !view?.opens);
  setText(byId("floor-plan-notice-close"), view?.opens ? "Open them" : "Close it");
  if (view?.asks) setText(byId("floor-plan-asks-text"), `This floor plan is ${view.asks}. Is that its size?`);
}

/** Floor that a robot can't get to: the inside of furniture, or a fault; which of them, only its owner knows. @param {FloorPlanView | undefined} view */
function showCut(view) {
  // Beside a question and a notice it would be too much at once, and outside of closed doors it is meant.
  const isIndoors = view?.settings.part.kind === "whole" && view.room?.outer_doors;
  const cut = view?.doors || isIndoors || (view?.asks && view.notice) ? 0 : (view?.room?.cut_off_m2 ?? 0);
  setHidden(byId("floor-plan-cut"), !cut);
  if (!view?.room || !cut) return;
  // Of areas as they are shown, so that the sum is right.
  const [all, reached, rounded] = [view.room.floor_m2, view.room.reachable_m2 ?? view.room.floor_m2, cut].map((area) => +area.toFixed(1));
  const rest = all - reached - rounded;
  const besides = rest < 0.05 ? "" : ` Another ${metres(rest)} m² are corners and edges that its brush doesn't reach.`;
  const start = cut > all / 2 ? "If it starts in the wrong part, move the start in Explore. " : "";
  const mend = view.kind === "drawing" ? "set its layer to Ignored" : view.kind === "image" ? "read the walls in another way" : "widen the way";
  // Walls fill whole cells.
  const cells = view.room.resolution > SMALL_CELLS ? " A door that is just wide enough may need smaller cells." : "";
  setText(byId("floor-plan-cut-text"), `A robot as wide as a Roomba can't get to ${metres(cut)} m² of this floor.${besides} ${start}If furniture stands there, there is nothing to do. If a line or a door blocks the way: ${mend}, or erase it in Explore.${cells}`);
}

/** What is marked in the picture. @param {FloorPlanView | undefined} view */
function showKey(view) {
  const [isCut, hasGaps] = [(view?.room?.cut_off_m2 ?? 0) > 0, (view?.room?.gaps ?? 0) > 0];
  setHidden(byId("floor-plan-mark-key"), !isCut && !hasGaps);
  setHidden(byId("floor-plan-cut-key"), !isCut);
  setHidden(byId("floor-plan-gap-key"), !hasGaps);
}

/** Doors that the room reaches through. @param {FloorPlanView | undefined} view */
function showDoors(view) {
  const doors = view?.doors;
  setHidden(byId("floor-plan-doors"), !doors);
  if (doors) {
    const { count, gap, floor_m2 } = doors;
    const [opening, where] = count > 1 ? [`${count} openings`, ", where the rings are"] : ["an opening", count === 1 ? ", where the ring is" : ""];
    // The fault says that the room is open.
    const [what, them] = view.fault ? ["", count > 1 ? "the openings" : "the opening"] : [`This room continues through ${opening} as wide as a door${where}. `, count > 1 ? "them" : "it"];
    setText(byId("floor-plan-doors-text"), `${what}Closing ${them} leaves ${metres(floor_m2)} m² of floor.`);
    setText(button("floor-plan-doors-close"), `Close gaps up to ${gap.toFixed(2)} m`);
  }
}

/** What a size is of. */
const WHOLE = { drawing: "whole drawing", image: "whole picture", map: "whole map" };

/** @param {FloorPlanView} view */
function facts({ kind, size, strokes, layers, left_out, reduced_from }) {
  const what = kind === "drawing" ? `${strokes.toLocaleString("en")} ${strokes === 1 ? "stroke" : "strokes"} on ${layers.length} ${layers.length === 1 ? "layer" : "layers"}` : "";
  return [size && `${WHOLE[kind]}: ${size}`, what, reduced_from && `reduced from ${reduced_from}`, left_out.length && `not drawn: ${left_out.join(", ")}`].filter(Boolean).join(" · ");
}

/** As in the words for screen readers: halves go up. @param {number} metres */
const tenths = (metres) => (Math.round(10 * metres) / 10).toFixed(1);

/** @param {FloorPlanView} view */
function result({ room, settings, fault, asks, size, assumes_size }) {
  if (!room) {
    if (settings.metre === null) return "Choose the drawing's unit first.";
    return fault || (asks ? `Whole drawing: ${size}. Choose its size first.` : "No room yet.");
  }
  const { width_m, height_m, floor_m2, cells, resolution, objects, gaps, outer_doors, around_m2, reachable_m2 } = room;
  const inside = `Room ${tenths(width_m)} × ${tenths(height_m)} m`;
  if (assumes_size) return `${inside}, if the assumed scale is right. Set the size first.`;
  const reach = reachable_m2 === null ? "" : `, ${metres(reachable_m2)} m² of it reachable by a Roomba's brush`;
  const [inner, openings] = [gaps - outer_doors, outer_doors === 1 ? "opening" : "openings"];
  const more = [objects && `${objects} ${objects === 1 ? "obstacle" : "obstacles"}`, inner && `${inner} ${inner === 1 ? "gap" : "gaps"} closed`, outer_doors && `${outer_doors} ${openings} to the outside closed`, around_m2 > 0 && `${metres(around_m2)} m² round the building left out`].filter(Boolean);
  return [`${inside}, without walls`, `${metres(floor_m2)} m² of floor${reach}`, `${cells[0]} × ${cells[1]} cells of ${(100 * resolution).toLocaleString("en", { maximumFractionDigits: 2 })} cm`, ...more].join(" · ");
}
