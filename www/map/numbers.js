// @ts-check
// The figures: three large ones, and the table that holds the map against one by odometry alone.
import { byId, make, setText } from "../dom.js";
import { clock, percent, smallLength } from "../format.js";

/**
 * @typedef {import("../types").MapErrorFigures} Figures
 * @typedef {import("../types").MapView} MapView
 * @typedef {{ label: string, tip: string, of: (figures: Figures) => string }} Row
 */

/** @type {Row[]} */
const ROWS = [
  { label: "Position error", tip: "Current distance between true and estimated position.", of: ({ position_m }) => (position_m === null ? "lost" : smallLength(position_m)) },
  { label: "Heading error", tip: "Current angle between true and estimated heading.", of: ({ heading_deg }) => (heading_deg === null ? "lost" : `${heading_deg.toFixed(1)}°`) },
  { label: "Cells right", tip: "Share of the map's known cells that are right, to within one 5 cm cell.", of: ({ right }) => `${percent(right)} %` },
  { label: "Boundary mapped", tip: "Share of the walls and furniture within the bumper's reach that are on the map, to within one cell.", of: ({ boundary }) => `${percent(boundary)} %` },
  { label: "Floor known", tip: "Share of the floor within reach of the robot's body that it knows to be free.", of: ({ known }) => `${percent(known)} %` },
];

/** @type {{ label: string, tip: string, of: (view: MapView) => string }[]} */
const SINGLE = [
  { label: "Own error estimate", tip: "The robot's own estimate: one standard deviation of the position (along the longer axis) and of the heading. Ellipse and wedge on the map show two.", of: ({ spread }) => (spread ? `±${smallLength(spread[0])}, ±${spread[1].toFixed(1)}°` : "–") },
  { label: "Cleaned by its map", tip: "Estimated swept share of the reachable floor on its own map, and what is left. Shown once it cleans with its map.", of: ({ by_map }) => (by_map ? `${percent(by_map[0] / Math.max(by_map[1], 1e-9))} %, ${(by_map[1] - by_map[0]).toFixed(1)} m² left` : "–") },
  { label: "Actually cleaned", tip: "Share of the reachable floor actually swept since the figures started.", of: ({ coverage }) => `${percent(coverage)} %` },
  { label: "Estimated cleaned", tip: "Estimated swept area on its own map; not counted while it is lost.", of: ({ cleaned_m2 }) => `${cleaned_m2.toFixed(1)} m²` },
  { label: "Dirt found", tip: "Area where its dirt sensor triggered.", of: ({ dirt_m2 }) => `${dirt_m2.toFixed(2)} m²` },
];

/** Ways of dead reckoning, in the order of `view.drifts`. */
const RECKONINGS = ["Counts, arcs", "Counts, straight", "Packets, arcs", "Packets, straight"].map((label, i) => ({
  label,
  tip: `Pose estimated from ${i < 2 ? "encoder counts" : "packets 19 and 20 (whole millimetres and degrees, every 0.24 s)"} alone, each step taken ${i % 2 === 0 ? "along an arc" : "straight, then turned"}.`,
}));

/** @param {import("./tab.js").MapTab} _it */
export function startNumbers(_it) {
  /** @param {{ label: string, tip: string }} row @param {HTMLElement[]} cells */
  const line = ({ label, tip }, cells) => make("tr", { "data-tip": tip }, make("th", { scope: "row" }, make("button", { type: "button", className: "term" }, label)), ...cells);
  const rows = ROWS.map((row) => ({ row, cells: [make("td"), make("td")] }));
  const single = SINGLE.map((row) => ({ row, cell: make("td", { colSpan: 2 }) }));
  byId("map-figures").replaceChildren(...rows.map(({ row, cells }) => line(row, cells)));
  const drifts = RECKONINGS.map((row) => ({ row, cells: [make("td"), make("td")] }));
  byId("map-drifts").replaceChildren(...drifts.map(({ row, cells }) => line(row, cells)));
  byId("map-more").replaceChildren(...single.map(({ row, cell }) => line(row, [cell])));

  /** @param {MapView} view */
  return (view) => {
    for (const { row, cells } of rows) {
      [view.figures, view.odometry].forEach((figures, i) => {
        const cell = cells[i];
        if (cell) setText(cell, figures && view.time_s > 0 ? row.of(figures) : "–");
      });
    }
    drifts.forEach(({ cells }, i) => {
      const [position, heading] = view.drifts[i] ?? [0, 0];
      [smallLength(position), `${heading.toFixed(1)}°`].forEach((text, j) => cells[j] && setText(cells[j], view.time_s > 0 ? text : "–"));
    });
    for (const { row, cell } of single) setText(cell, row.of(view));
    setText(byId("map-here"), view.known !== null ? "Relocalising" : view.grid === "thesis" ? "Thesis" : view.tracking === "odometry" ? "Robot" : "Corrected");
    const has = view.figures && view.time_s > 0;
    setText(byId("map-n-boundary"), view.figures ? percent(view.figures.boundary) : "–");
    setText(byId("map-n-time"), clock(view.time_s));
    setText(byId("map-n-time-unit"), view.time_s < 3600 ? "min" : "h");
    const [error = "–", unit = ""] = !has ? [] : view.figures?.position_m === null ? ["lost"] : smallLength(view.figures?.position_m ?? 0).split(/\s/);
    setText(byId("map-n-error"), error);
    setText(byId("map-n-error-unit"), unit);
  };
}
