// @ts-check
// The sweep of 001: scan width, obstacle map, the stages one after the other, their results, and export.
import { button, byId, input, select, setAttribute, setHidden, setText } from "../dom.js";
import { download } from "../files.js";
import { clock, count, metres, percent, took } from "../format.js";
import { onNumber, plain, showValue } from "./fields.js";

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startSweep(it) {
  const [width, cell, headings, slice, heading] = [input("floor-plan-scan"), input("floor-plan-space-cell"), input("floor-plan-headings"), input("floor-plan-slice"), input("floor-plan-heading")];
  onNumber(width, (metres) => void it.set({ scan_width: metres > 0 ? metres : null }));
  width.addEventListener("change", () => width.value === "" && void it.set({ scan_width: null }));
  const [order, clearance] = [select("floor-plan-order"), input("floor-plan-clearance")];
  order.addEventListener("change", () => void it.set({ order: /** @type {import("./types").FloorPlanSettings["order"]} */ (order.value) }));
  onNumber(clearance, (centimetres) => void it.set({ clearance: centimetres / 100 }));
  onNumber(cell, (centimetres) => void it.set({ cell: centimetres / 100 }));
  onNumber(headings, (count) => void it.set({ headings: Math.round(count) }));
  const showSlice = () => it.ask({ type: "slice", heading: slice.checked ? heading.valueAsNumber : -1 }, "Making the obstacle map");
  slice.addEventListener("change", () => void showSlice());
  let isAsking = false;
  heading.addEventListener("input", async () => {
    // Only the latest heading counts while one is being drawn.
    if (isAsking) return;
    isAsking = true;
    for (let shown = NaN; slice.checked && shown !== heading.valueAsNumber; ) {
      shown = heading.valueAsNumber;
      await showSlice();
    }
    isAsking = false;
  });

  const moves = () => !matchMedia("(prefers-reduced-motion: reduce)").matches;
  /** Plans the sweep unless there is one; whether there is one then. */
  const planned = async () => it.view?.sweep || Boolean(await it.ask({ type: "sweep" }, "Planning the sweep"));
  /** @param {number[]} stages @param {boolean} isMoving */
  const play = async (stages, isMoving) => {
    if (!(await planned())) return;
    it.toCanvas(false);
    it.client.say({ type: "stages", stages, moves: isMoving });
  };
  button("floor-plan-play").addEventListener("click", () => void play([1, 2, 3, 4], moves()));
  const stages = [...byId("floor-plan-stages").querySelectorAll("button")];
  for (const node of stages) node.addEventListener("click", () => void play([Number(node.dataset.stage)], moves()));

  for (const node of byId("floor-plan-exports").querySelectorAll("button")) {
    node.addEventListener("click", async () => {
      if (!(await planned())) return;
      const answer = await it.ask({ type: "export", format: node.dataset.format ?? "" }, "Writing the file");
      if (!answer) return;
      const file = /** @type {import("./types").Exported} */ (answer.result);
      download(file.name, new Blob([/** @type {BlobPart} */ (/** @type {unknown} */ (file.bytes))]), file.media);
    });
  }
  button("floor-plan-drive").addEventListener("click", async () => (await planned()) && it.use(true));

  return (view) => {
    const isReady = Boolean(view?.room) && !view?.body_fault;
    for (const node of [button("floor-plan-play"), button("floor-plan-drive"), ...stages, ...byId("floor-plan-exports").querySelectorAll("button"), slice]) node.disabled = !isReady;
    setHidden(byId("floor-plan-numbers"), !view?.sweep);
    setHidden(byId("floor-plan-sweep-note"), Boolean(view?.sweep));
    for (const node of stages) setAttribute(node, "aria-pressed", String(view?.stage === Number(node.dataset.stage)));
    if (!view) return;
    const { settings, sweep } = view;
    showValue(width, settings.scan_width === null ? "" : plain(settings.scan_width));
    width.placeholder = view.body_width === null ? "" : plain(view.body_width / 2, 3);
    showValue(order, settings.order);
    showValue(clearance, plain(100 * settings.clearance));
    showValue(cell, plain(100 * settings.cell));
    showValue(headings, String(settings.headings));
    slice.checked = view.slice >= 0;
    heading.max = String(settings.headings - 1);
    heading.disabled = view.slice < 0;
    setText(byId("floor-plan-heading-value"), `${Math.round((360 * heading.valueAsNumber) / settings.headings)}°`);
    setHidden(byId("floor-plan-slice-key"), view.slice < 0);
    if (sweep) numbers(sweep, view.seconds);
  };
}

/** @param {number} length */
const tenths = (length) => `${metres(length)} m`;

/** @param {import("./types").SweepView} sweep @param {number} seconds */
function numbers(sweep, seconds) {
  const [all, leftWall, rightWall, leftObstacle, rightObstacle] = sweep.subgoals;
  /** @type {Record<string, string>} */
  const values = {
    subgoals: count(all),
    "left-wall": count(leftWall),
    "right-wall": count(rightWall),
    "left-obstacle": count(leftObstacle),
    "right-obstacle": count(rightObstacle),
    links: count(sweep.links),
    collisions: count(sweep.collisions),
    resolved: count(sweep.resolved),
    crossings: count(sweep.crossings),
    length: tenths(sweep.length),
    linked: `${percent(sweep.linked_share)} %`,
    finish: sweep.finish[0] ? `${count(sweep.finish[0])}, ${tenths(sweep.finish[1])}` : "0",
    order: sweep.nearest ? compared(sweep, sweep.nearest) : "",
    coverage: `${percent(sweep.coverage)} %`,
    driven: `${percent(sweep.driven[0])} %, ${clock(sweep.driven[1])}`,
    seconds: took(seconds),
  };
  for (const [name, value] of Object.entries(values)) setText(byId(`floor-plan-n-${name}`), value);
  setHidden(byId("floor-plan-order-row"), !sweep.nearest);
  setHidden(byId("floor-plan-kept"), sweep.kept_free === null);
  setText(byId("floor-plan-kept"), sweep.kept_free === null ? "" : `This robot turns to face the way it drives, so ${sweep.kept_free} around its centre is kept free of obstacles.`);
}

/** What another order costs. @param {import("./types").SweepView} sweep @param {[number, number]} nearest */
function compared(sweep, [crossings, length]) {
  const [more, longer] = [sweep.crossings - crossings, sweep.length - length];
  const crossed = `${count(Math.abs(more))} ${more > 0 ? "more" : "fewer"} ${Math.abs(more) === 1 ? "crossing" : "crossings"}`;
  return `${crossed}, ${tenths(Math.abs(longer))} ${longer < 0 ? "shorter" : "longer"}`;
}
