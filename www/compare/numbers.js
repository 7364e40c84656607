// @ts-check
// The table of all numbers, sortable, the best of every column marked; the charts below it.
import { drawCharts } from "./charts.js";
import { button, byId, changed, fill, make, select, setText } from "../dom.js";
import { swatch } from "./entrants.js";
import { clock, count, metres, percent, shown, unitOf } from "../format.js";
import { cueScroll } from "./scroll-cue.js";
import { fromLink, inLink, keepingFocus, pressed, sorted, sortHead } from "./sorting.js";

/**
 * @typedef {import("../types").TableView} Table
 * @typedef {Table["rows"][number]} Row
 * @typedef {Table["metrics"][number]} Metric
 */

/** Table 2 of Emu & Obaida 2020: their three algorithms in a room with as many cells as theirs. */
const TABLE_2 = { place: "room=thesis226&robot=cell&cell=0.2&seed=1", plans: "vs=spiral,snake,genetic&rooms=this&seeds=1" };

/** Key of the column of names, by which one can sort as by a number. */
const NAME = "name";

/** @typedef {import("./sorting.js").Order} Order */

/** @param {import("./tab.js").Comparing} it */
export function startNumbers(it) {
  const { comparison, app } = it;
  /** @type {Order} */
  let order;
  /** The room of a link, until the menu has it. */
  let wanted = "";
  /** @type {Table | undefined} */
  let table;
  const head = byId("compared").querySelector("thead");
  const body = byId("compared").querySelector("tbody");
  if (!head || !body) throw new Error("the page has no table");
  for (const node of byId("panel-compare").querySelectorAll(".table-scroll")) cueScroll(/** @type {HTMLElement} */ (node));

  button("compare-table-2").addEventListener("click", () => {
    if (app.act((p) => p.restore(TABLE_2.place)) && it.act((c) => c.restore(TABLE_2.plans))) button("view-numbers").click();
  });

  /** @param {string} metric */
  const sortBy = (metric) => {
    order = pressed(order, metric);
    show();
  };

  const show = () => {
    if (!table) return;
    const { metrics, rows } = table;
    keepingFocus(byId("compared"), () => {
      head.replaceChildren(make("tr", {}, nameHeading(order, sortBy), ...metrics.map((metric, column) => heading(metric, column, rows, order, sortBy))));
      body.replaceChildren(...inOrder(rows, metrics, order, (row) => it.view.entrants[row.entrant]?.title ?? "").map((row) => line(it, row, metrics, rows, select("table-room").value === "all" ? it.view.rooms.length : 1)));
    });
    drawCharts(byId("charts"), table, it.view.entrants, it.about);
  };

  /** @param {import("../types").ComparisonView} view */
  const update = (view) => {
    const menu = select("table-room");
    if (changed(menu, "rooms", view.rooms.join("\n"))) {
      const all = view.rooms.length > 1 ? [/** @type {[string, string]} */ (["all", `all ${view.rooms.length} rooms together`])] : [];
      fill(menu, [...all, ...view.rooms.map((name, index) => /** @type {[string, string]} */ ([String(index), name]))]);
    }
    const room = [...menu.options].find(({ value }) => value === wanted);
    if (room) [menu.value, wanted] = [room.value, ""];
    if (!changed(body, "table", `${view.version} ${menu.value}`)) return;
    const chosen = menu.value === "all" ? undefined : Number(menu.value);
    table = comparison.table(chosen);
    setText(byId("table-note"), `${note(view, chosen === undefined)} ${table ? proven(table) : ""} ${table ? beside(table) : ""}`.trim());
    show();
  };

  return {
    update,
    /** What the view adds to a link. */
    link() {
      const menu = select("table-room");
      return `${inLink(order)}${menu.selectedIndex > 0 ? `&of=${menu.value}` : ""}`;
    },
    /** @param {URLSearchParams} pairs */
    restore(pairs) {
      order = fromLink(pairs);
      wanted = pairs.get("of") ?? "";
      show();
    },
  };
}

/** @param {import("../types").ComparisonView} view @param {boolean} together */
function note({ seeds, entrants }, together) {
  const drive = entrants.some(({ chosen, kind, lacks }) => chosen && kind === "behaviour" && !lacks) ? " Behaviours have no plan: they are in the race, and measured in Many runs." : "";
  const chance = seeds > 1 && entrants.some(({ chosen }) => chosen) ? ` Randomised algorithms: median of ${seeds} seeds, range below it.` : "";
  return `${together ? "Sums over the rooms; percentages are means." : ""}${chance}${drive} Numbers are of the plans, without wheel slip. In the race robots take longer: they correct their course and give way to pets and people.`.trim();
}

/** @param {Table} table */
function proven({ bounds, least }) {
  const metric = least ? ` Any path that sweeps ${percent(least.coverage, 0)} % needs at least ${metres(least.length_m)} m and ${clock(least.duration_s)}; each row's excess is relative to the bound for that row's own coverage, which is measured more finely here than in the Coverage column and is usually a little lower.` : "";
  if (!bounds) return "";
  return `Proven: no walk over these cells has fewer than ${count(bounds.steps)} steps or ${count(bounds.turns)} quarter turns, or steps + 2 × turns below ${count(bounds.cost)}.${metric}`;
}

/** @param {Table} table */
function beside({ rows }) {
  if (!rows.some(({ printed }) => printed.some((value) => value !== null))) return "";
  return "Dashed bars: Table 2 as Emu & Obaida print it. Their room is lost; this one has as many cells and was laid out so that the snake comes close to the printed numbers. Compare the order of the algorithms, not the values.";
}

/** @param {Metric} metric @param {number} column @param {Row[]} rows @param {Order} order @param {(metric: string) => void} sortBy */
function heading(metric, column, rows, order, sortBy) {
  const cell = make("th", { scope: "col", "data-tip": `${metric.definition} ${metric.better === "lower" ? "Lower" : "Higher"} is better.` });
  const most = Math.max(...rows.map(({ values }) => values[column]?.max ?? 0));
  const unit = metric.unit ? make("span", { className: "unit" }, unitOf(metric, most)) : "";
  cell.append(unit);
  sortHead(cell, metric.label, metric.id, metric.better, order, sortBy);
  return cell;
}

/** @param {Order} order @param {(metric: string) => void} sortBy */
function nameHeading(order, sortBy) {
  const cell = make("th", { scope: "col" });
  sortHead(cell, "Algorithm", NAME, "lower", order, sortBy);
  return cell;
}

/** Best first, or last. @param {Row[]} rows @param {Metric[]} metrics @param {Order} order @param {(row: Row) => string} nameOf */
function inOrder(rows, metrics, order, nameOf) {
  if (order?.key === NAME) return rows.toSorted((a, b) => nameOf(a).localeCompare(nameOf(b), "en") * (order.down ? -1 : 1));
  const column = metrics.findIndex(({ id }) => id === order?.key);
  const metric = metrics[column];
  return order && metric ? sorted(rows, order, metric.better, ({ values }) => values[column]?.median) : rows;
}

/** @param {import("./tab.js").Comparing} it @param {Row} row @param {Metric[]} metrics @param {Row[]} rows @param {number} rooms */
function line(it, row, metrics, rows, rooms) {
  const { about } = it;
  const planner = it.view.entrants[row.entrant];
  const open = make("button", { type: "button", className: "link", "data-key": String(row.entrant), onclick: () => about(row.entrant) }, planner?.title ?? "");
  const name = make("th", { scope: "row" }, swatch(planner?.mark), open);
  if (row.missing > 0 && rooms > 1) name.append(" ", make("span", { className: "status" }, `${rooms - row.missing} of ${rooms} rooms`));
  if (row.failure) name.append(make("span", { className: "failure", "data-tip": row.failure, tabIndex: 0 }, "failed"));
  if (row.leaves_floor) name.append(" ", make("span", { className: "status", "data-tip": "This plan leaves out floor that others clean, which makes it cheaper; so only its coverage can be marked as best.", tabIndex: 0 }, "not all floor"));
  const cells = metrics.map((metric, column) => {
    const spread = row.values[column];
    if (!spread) return make("td", {}, "–");
    const above = metric.id.startsWith("excess") ? bound(row) : "";
    const tip = `${difference(row, column, metric, rows, it.view.entrants)}${above && ` ${above}`}`;
    // What stands nowhere else is also there for those who have no pointer.
    const reached = above ? { tabIndex: 0, "data-key": `${row.entrant} ${metric.id}`, "aria-description": above } : {};
    const cell = make("td", { className: row.best[column] ? "best" : "", "data-tip": tip, ...reached });
    cell.append(shown(metric, spread.median));
    const [min, max] = [shown(metric, spread.min), shown(metric, spread.max)];
    if (min !== max) cell.append(make("small", {}, `${min}–${max}`));
    return cell;
  });
  const result = make("tr", { onclick: (/** @type {Event} */ event) => event.target instanceof HTMLButtonElement || about(row.entrant) }, name, ...cells);
  return result;
}

/** What the excess of a row is above. @param {Row} row */
const bound = ({ least }) => (least ? `Its paths sweep ${percent(least.coverage, 2)} %, measured exactly: any path that sweeps as much needs at least ${metres(least.length_m)} m and ${clock(least.duration_s)}.` : "");

/** How a value differs from the best of its column. @param {Row} row @param {number} column @param {Metric} metric @param {Row[]} rows @param {import("../types").ComparisonView["entrants"]} entrants */
function difference(row, column, metric, rows, entrants) {
  const best = rows.filter((other) => other.best[column]);
  const value = row.values[column]?.median ?? 0;
  const least = best[0]?.values[column]?.median;
  if (least === undefined) return metric.definition;
  if (row.best[column]) return `${metric.label}: the best here${best.length > 1 ? `, tied with ${best.length - 1} more` : ""}. ${metric.definition}`;
  const names = best.map((other) => entrants[other.entrant]?.title).join(", ");
  const more = value > least ? "more" : "less";
  const by = metric.unit === "%" || least === 0 ? `${shown(metric, Math.abs(value - least))} ${metric.unit === "%" ? "points" : ""}` : `${Math.abs((100 * (value - least)) / least).toFixed(0)} %`;
  return `${metric.label}: ${by.trim()} ${more} than the best (${shown(metric, least)}, ${names}). ${metric.definition}`;
}
