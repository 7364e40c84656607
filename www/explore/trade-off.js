// @ts-check
// What other coverages would take: a curve below the slider of a planner that is asked for a coverage.
import { byId, make, setHidden, setText } from "../dom.js";
import { clock, metres, percent } from "../format.js";
import { style } from "../parts.js";
import { hire } from "../workers.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("../types").PageView} View
 * @typedef {{ share: number, seconds: number, metres: number }} Point `share`: the coverage asked for, or less where none was found that sweeps so much.
 */

/** Shares of the floor that are tried. */
const SHARES = [0.8, 0.85, 0.9, 0.93, 0.95, 0.97, 0.98, 0.985, 0.99, 0.993, 0.996, 0.999];
/** Less than asked for that is nothing missing. */
const SHORT = 0.0005;
/** Of the picture, px: its size and the room for the words at its sides. */
const [WIDTH, HEIGHT] = [300, 132];
const [LEFT, RIGHT, TOP, BOTTOM] = [34, 18, 8, 20];

/** @param {App} app @returns {Promise<(view: View) => void>} */
export async function startTradeOff(app) {
  await style(new URL("./trade-off.css", import.meta.url).href);
  const picture = make("div", { className: "trade-off-picture", role: "img" });
  const words = make("p", { className: "note", role: "status" });
  const fold = make("details", { id: "trade-off", className: "each" }, make("summary", {}, "Time for other coverages"), words, picture);
  const missing = make("p", { className: "note", id: "coverage-missed", role: "status", hidden: true });
  byId("params").after(missing, fold);
  /** @type {Point[]} */
  let points = [];
  /** @type {Worker | undefined} */
  let worker;
  /** Number of the curve that is wanted. */
  let wanted = 0;
  /** The coverage at the slider, and that of the plan, 0 to 1. */
  let [shown, planned] = [0, 0];
  /** Whether something less than was asked for was found; whether all was tried. */
  let [isShort, isWhole] = [false, false];
  /** The plan whose curve is shown or searched: its length and time. */
  let of = "";

  const end = () => {
    wanted += 1;
    worker?.terminate();
    worker = undefined;
  };
  /** Nobody looks, or another plan comes: what is missing is searched again for it. */
  const leave = () => {
    if (!isWhole) of = "";
    end();
  };

  /** Asks for the curve of the present plan. */
  async function begin() {
    end();
    const number = wanted;
    [points, isShort, isWhole] = [[], false, false];
    draw();
    const { playground } = app;
    const [snapshot, corners] = [playground.snapshot(undefined), playground.corners()];
    const hired = await hire();
    if (number !== wanted) return hired.terminate();
    worker = hired;
    hired.addEventListener("message", (/** @type {MessageEvent<import("../worker-types").FromTradeOff>} */ { data }) => {
      if (data.type === "point") {
        const [asked = 0, coverage = 0, seconds = 0, metres = 0] = data.point;
        const isLess = coverage < asked - SHORT;
        isShort ||= isLess;
        points = [...points, { share: isLess ? coverage : asked, seconds, metres }].sort((a, b) => a.share - b.share);
        draw();
      } else {
        isWhole = data.type === "traded";
        end();
        draw(data.type === "failed" ? data.message : "");
      }
    });
    hired.addEventListener("error", (event) => {
      end();
      draw(event.message || "The search could not be loaded.");
    });
    hired.postMessage({ type: "trade-off", request: { id: 0, snapshot, corners, shares: new Float64Array(SHARES) } });
  }

  /** @param {string} [error] */
  function draw(error = "") {
    const most = points.at(-1);
    const limit = isShort && most ? ` No path was found that sweeps more than ${percent(most.share)} %.` : "";
    setText(words, error || `${points.length < 2 ? "Searching for paths…" : said(points, shown, planned, isWhole)}${limit}`);
    picture.innerHTML = points.length < 2 ? "" : svg(points, shown, planned);
    picture.setAttribute("aria-label", points.map(({ share, seconds }) => `${percent(share)} %: ${clock(seconds)}`).join(", "));
  }

  fold.addEventListener("toggle", () => fold.open || leave());
  document.addEventListener("tab", leave);
  // Both the slider and the number.
  byId("params").addEventListener("input", ({ target }) => {
    if (!(target instanceof HTMLInputElement) || target.closest(".field")?.querySelector(`#explore-param-${fold.dataset.param}`) == null) return;
    shown = Number(target.value) / 100;
    if (fold.open) draw();
  });

  return (view) => {
    const param = app.catalogue.planners.find(({ id }) => id === view.algorithm)?.coverage_param;
    const asked = view.plan?.asked_coverage ?? null;
    setHidden(fold, asked === null);
    const swept = view.plan?.least?.coverage;
    setHidden(missing, asked === null || swept === undefined || swept > asked - SHORT);
    if (asked === null) return leave();
    if (swept !== undefined) setText(missing, `No path was found that sweeps ${percent(asked)} %: this one sweeps ${percent(swept)} %.${Number(view.params.overlap ?? 0) > 0 ? " Less overlap reaches more." : ""}`);
    fold.dataset.param = param ?? "";
    // Where less was found, that is what other coverages are compared with.
    planned = swept === undefined || swept > asked - SHORT ? asked : swept;
    const { plan } = view;
    if (plan?.running && of !== "") [of, isWhole] = ["", false];
    if (plan?.running) return end();
    const now = `${plan?.length_m} ${plan?.duration_s}`;
    if (!fold.open || !plan || of === now) return;
    of = now;
    shown = planned;
    void begin().catch((error) => draw(error instanceof Error ? error.message : String(error)));
  };
}

/** What the curve says at a coverage, and how that differs from the plan's. @param {Point[]} points @param {number} shown @param {number} planned @param {boolean} isWhole */
function said(points, shown, planned, isWhole) {
  const [there, here] = [at(points, shown), at(points, planned)];
  if (!there) return isWhole ? `${percent(shown)} % is outside of what was tried.` : `Searching for ${percent(shown)} %…`;
  const text = `${percent(shown)} % of the floor: about ${clock(there.seconds)}, ${metres(there.metres)} m`;
  const less = here ? here.seconds - there.seconds : 0;
  return Math.abs(less) < 1 || Math.abs(shown - planned) < 5e-4 ? `${text}.` : `${text}, ${clock(Math.abs(less))} ${less > 0 ? "less" : "more"} than for ${percent(planned)} %.`;
}

/** The curve at a coverage, between the points beside it. @param {Point[]} points @param {number} share */
function at(points, share) {
  const next = points.findIndex((point) => point.share >= share - 1e-9);
  const [a, b] = [points[Math.max(0, next - 1)], points[next]];
  if (!a || !b || (next === 0 && b.share - share > SHORT)) return;
  const part = b.share > a.share ? (share - a.share) / (b.share - a.share) : 1;
  const mix = (/** @type {number} */ x, /** @type {number} */ y) => x + part * (y - x);
  return { seconds: mix(a.seconds, b.seconds), metres: mix(a.metres, b.metres) };
}

/** @param {Point[]} points @param {number} shown @param {number} planned */
function svg(points, shown, planned) {
  const [first, last] = [/** @type {Point} */ (points[0]), /** @type {Point} */ (points.at(-1))];
  const most = Math.max(...points.map(({ seconds }) => seconds));
  const step = [1, 2, 5, 10, 20, 50, 100, 200, 500].find((minutes) => most / 60 / minutes <= 4) ?? 1000;
  const top = Math.max(step, Math.ceil(most / 60 / step) * step);
  const x = (/** @type {number} */ share) => LEFT + ((share - first.share) / Math.max(1e-6, last.share - first.share)) * (WIDTH - LEFT - RIGHT);
  const y = (/** @type {number} */ seconds) => HEIGHT - BOTTOM - (seconds / 60 / top) * (HEIGHT - TOP - BOTTOM);
  const lines = Array.from({ length: Math.round(top / step) + 1 }, (_, i) => i * step).map((minutes) => `<line class="grid" x1="${LEFT}" x2="${WIDTH - RIGHT}" y1="${y(60 * minutes)}" y2="${y(60 * minutes)}"/><text x="${LEFT - 5}" y="${y(60 * minutes) + 4}" text-anchor="end">${minutes}</text>`);
  const ticks = [first.share, 0.9, 0.95, 0.99].filter((share, i) => i === 0 || (x(share) > LEFT + 30 && share <= last.share)).map((share) => `<text x="${x(share)}" y="${HEIGHT - 5}" text-anchor="middle">${+(100 * share).toFixed(1)} %</text>`);
  const path = points.map(({ share, seconds }, i) => `${i ? "L" : "M"}${x(share).toFixed(1)} ${y(seconds).toFixed(1)}`).join("");
  const mark = (/** @type {number} */ share, /** @type {string} */ name) => {
    const point = at(points, share);
    return point ? `<circle class="${name}" cx="${x(share)}" cy="${y(point.seconds)}" r="4.5"/>` : "";
  };
  return `<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" aria-hidden="true">${lines.join("")}${ticks.join("")}<text x="${LEFT + 4}" y="${TOP + 10}">min</text><path d="${path}"/>${mark(planned, "planned")}${mark(shown, "shown")}</svg>`;
}
