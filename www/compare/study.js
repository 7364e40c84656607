// @ts-check
// The results of a study (docs/studies.md): a Parquet file, read here, as table and chart. Loaded with the first such file.
import { parquetMetadata, parquetReadObjects } from "../../hyparquet.js";
import { MonteCarlo, bands_of_runs, summary_of_runs } from "../../workshop.js";
import { bandsOf, startChart } from "./coverage-chart.js";
import { byId, fill, select, setHidden, setText } from "../dom.js";
import { swatch } from "./entrants.js";
import { count } from "../format.js";
import { startTable } from "./runs-table.js";

/**
 * @typedef {object} Row A run, with what is taken of its columns.
 * @property {string} room
 * @property {string} robot
 * @property {string} kind
 * @property {string} algorithm
 * @property {string} params
 * @property {string} conditions
 * @property {string} measure
 * @property {string | null} error
 * @property {number[]} numbers As the workshop takes them.
 */

/** Columns without which a file isn't a study. */
const NEEDED = ["room", "robot", "kind", "algorithm", "params", "conditions", "measure", "minutes", "seed", "error", "coverage", "curve"];
const NUMBERS = ["time_s", "distance_m", "dirt_left", "excess_distance", "excess_time", "bumps", "falls", "time_to_90_s", "time_to_99_s"];
/** A choice of rooms that holds several. */
const [ALL, FLATS] = ["all rooms", "all flats"];

/** @type {{ name: string, rows: Row[], minutes: number } | undefined} */
let opened;
/** @type {ReturnType<typeof startChart> | undefined} */
let chart;
/** @type {ReturnType<typeof startTable> | undefined} */
let table;
/** What the table shows, for the files. @type {Record<string, unknown>[]} */
let told = [];

/** Reads a file and shows it; throws a sentence. @param {File} file */
export async function openStudy(file) {
  opened = { name: file.name.replace(/\.parquet$/i, ""), ...(await read(file)) };
  for (const [id, values] of /** @type {const} */ ([["study-rooms", rooms(opened.rows)], ["study-robot", distinct("robot")], ["study-conditions", distinct("conditions")]])) {
    const menu = select(id);
    fill(menu, values.map((value) => [value, value || "as they are"]));
    menu.onchange = show;
    setHidden(menu.closest("label") ?? menu, values.length < 2);
  }
  chart ??= startChart(byId("study-plot"));
  table ??= startTable(byId("study-table"));
  setHidden(byId("view-study"), false);
}

/** What can be saved of it. */
export const exported = () => ({
  name: opened?.name ?? "study",
  csv: () => [Object.keys(told[0] ?? {}), ...told.map(Object.values)].map((line) => line.map((value) => JSON.stringify(value)).join()).join("\n"),
  json: () => JSON.stringify(told),
  charts: byId("study-view"),
});

/** @param {File} file */
async function read(file) {
  const bytes = await file.arrayBuffer();
  /** @type {import("hyparquet").FileMetaData} */
  let metadata;
  try {
    metadata = parquetMetadata(bytes);
  } catch {
    throw new Error(`${file.name} isn't a complete Parquet file. Make it again with "robovac study".`);
  }
  const columns = new Set(metadata.schema.map(({ name }) => name));
  const missing = NEEDED.find((name) => !columns.has(name));
  if (missing) throw new Error(`${file.name} isn't the result of a study: it has no column "${missing}". Open a file that "robovac study" wrote.`);
  const found = await parquetReadObjects({ file: bytes, metadata, columns: [...NEEDED, ...NUMBERS.filter((name) => columns.has(name))] });
  if (found.length === 0) throw new Error(`${file.name} has no runs.`);
  return { minutes: Number(found[0]?.minutes), rows: found.map(rowOf) };
}

/** @param {Record<string, any>} found @returns {Row} */
function rowOf(found) {
  const at = (/** @type {string} */ name, missing = NaN) => (found[name] === null || found[name] === undefined ? missing : Number(found[name]));
  const curve = found.curve?.length ? found.curve : [at("coverage")];
  const head = [curve.length, at("seed"), at("time_s"), at("distance_m"), at("dirt_left"), at("excess_distance"), at("excess_time"), at("bumps", 0), at("falls", 0)];
  const { room, robot, kind, algorithm, params, conditions, measure, error } = found;
  // A digest is two numbers; nobody asks for it here.
  const numbers = error === null ? [...head, 0, 0, at("time_to_90_s", Infinity), at("time_to_99_s", Infinity), ...curve] : [];
  return { room, robot, kind, algorithm, params, conditions, measure, error, numbers };
}

/** @param {"robot" | "conditions"} column */
const distinct = (column) => [...new Set(opened?.rows.map((row) => row[column]))];

/** @param {Row[]} rows */
function rooms(rows) {
  const each = [...new Set(rows.map(({ room }) => room))];
  const flats = each.filter(isFlat);
  const several = [...(each.length > 1 ? [ALL] : []), ...(flats.length > 1 && flats.length < each.length ? [FLATS] : [])];
  return [...several, ...each];
}

/** @param {string} room */
const isFlat = (room) => room.startsWith("flat:");

/** Draws what is chosen. */
export function show() {
  if (!opened) return;
  const { rows, minutes, name } = opened;
  const [room, robot, conditions] = ["study-rooms", "study-robot", "study-conditions"].map((id) => select(id).value);
  const isChosen = (/** @type {Row} */ row) => row.robot === robot && row.conditions === conditions && (room === ALL || row.room === room || (room === FLATS && isFlat(row.room)));
  const chosen = rows.filter(isChosen);
  /** @type {Map<string, Row[]>} */
  const groups = new Map();
  for (const row of chosen) {
    const key = `${row.kind} ${row.algorithm}${row.params ? `~${row.params}` : ""}`;
    const runs = groups.get(key);
    if (runs) runs.push(row);
    else groups.set(key, [row]);
  }
  const offer = new MonteCarlo().offer();
  const lines = [...groups].map(([key, runs], index) => {
    const first = /** @type {Row} */ (runs[0]);
    const known = offer.entrants.find(({ id, kind }) => id === first.algorithm && kind === first.kind);
    const mark = known?.mark ?? { colour: index % 8, shape: 0 };
    const numbers = new Float64Array(runs.flatMap((run) => run.numbers));
    const failed = runs.filter(({ error }) => error !== null);
    return {
      key,
      title: (known?.title ?? first.algorithm) + (first.params ? ` (${first.params})` : ""),
      explores: first.measure === "boundary",
      mark: swatch(mark),
      summary: summary_of_runs(numbers),
      // Some rooms may be too small for a robot: only where nothing is known has it failed.
      failure: failed.length === runs.length ? (failed[0]?.error ?? "") : "",
      failed: failed.length,
      numbers,
      ...mark,
    };
  });
  const known = lines.filter(({ summary }) => summary);
  const curves = known.map((line) => ({ ...line, ...bandsOf(bands_of_runs(line.numbers)) })).filter(({ median }) => median.length > 1);
  const failures = lines.reduce((sum, { failed }) => sum + failed, 0);
  setText(byId("study-title"), `Coverage over ${minutes} minutes: ${name}`);
  setText(byId("study-note"), `${count(chosen.length)} of ${count(rows.length)} runs${failures ? `, ${count(failures)} of them without results` : ""}. Lines and large numbers are medians; bands and small numbers span the 10 % to 90 % quantiles.`);
  setHidden(byId("study-chart"), curves.length === 0);
  chart?.show(curves, minutes);
  table?.show(lines, minutes, (which) => chart?.stress(which === undefined ? undefined : curves.findIndex(({ key }) => key === lines[which]?.key)));
  told = lines.map(({ key, summary }) => ({ algorithm: key, rooms: room, robot, conditions, runs: summary?.runs ?? 0, coverage: summary?.coverage.median ?? null, low: summary?.coverage.low ?? null, high: summary?.coverage.high ?? null }));
}
