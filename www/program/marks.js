// @ts-check
// Marks, lines and words that a program puts on the floor, as they are at the time that is shown.
import { make } from "../dom.js";
import { STEP } from "./stage.js";

/** @typedef {import("./types").Output} Output */

/** The colours that programs can name: those of Okabe and Ito, which also the colour-blind tell apart. */
const COLOURS = new Map(Object.entries({ blue: "#0072b2", orange: "#e69f00", green: "#009e73", red: "#d55e00", purple: "#cc79a7", grey: "#808080" }));
/** Of what names none. */
const INK = "#d55e00";

/** @param {import("../main.js").App} app @param {import("./run.js").ProgramRun} run */
export function startMarks(app, run) {
  const canvas = make("canvas", { className: "program-marks", "aria-hidden": "true" });
  document.getElementById("floor")?.after(canvas);
  const context = canvas.getContext("2d");
  let drawn = "";
  /** To be called in every frame. */
  return () => {
    const { view, playground } = app;
    const isShown = view.program !== null && run.said.all.length > 0;
    if (!context || (!isShown && !drawn)) return;
    const [scale = 1, x = 0, y = 0] = playground.floor_to_screen();
    const { clientWidth: width, clientHeight: height } = canvas;
    const now = Math.round(view.time_s / STEP);
    const shown = isShown ? visible(run.said.all, now) : [];
    const key = shown.length ? [run.said.version, shown.length, shown.at(-1)?.step, scale, x, y, width, height, devicePixelRatio].join() : "";
    if (key === drawn) return;
    drawn = key;
    const ratio = devicePixelRatio || 1;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    for (const one of shown) draw(context, one, (at) => x + scale * at, (at) => y - scale * at);
  };
}

/** What is on the floor after that many steps. @param {Output[]} output @param {number} now */
function visible(output, now) {
  let [from, to] = [0, output.length];
  while (from < to) {
    const middle = (from + to) >> 1;
    if ((output[middle]?.step ?? 0) <= now) from = middle + 1;
    else to = middle;
  }
  const cleared = output.findLastIndex(({ kind }, index) => index < from && kind === "clear");
  return output.slice(cleared + 1, from).filter(({ kind }) => kind === "mark" || kind === "line" || kind === "text");
}

/** @param {CanvasRenderingContext2D} context @param {Output} one @param {(x: number) => number} across @param {(y: number) => number} up */
function draw(context, { kind, x = 0, y = 0, x1 = 0, y1 = 0, x2 = 0, y2 = 0, text, colour }, across, up) {
  context.fillStyle = context.strokeStyle = COLOURS.get(String(colour)) ?? INK;
  if (kind === "mark") {
    context.beginPath();
    context.arc(across(x), up(y), 4, 0, 2 * Math.PI);
    context.fill();
  } else if (kind === "line") {
    context.lineWidth = 2;
    context.lineCap = "round";
    context.beginPath();
    context.moveTo(across(x1), up(y1));
    context.lineTo(across(x2), up(y2));
    context.stroke();
  } else {
    context.font = "600 13px system-ui, sans-serif";
    context.lineWidth = 3;
    context.lineJoin = "round";
    context.strokeStyle = "rgb(255 255 255 / 0.85)";
    context.fillStyle = COLOURS.get(String(colour)) ?? "#1d2129";
    context.strokeText(String(text ?? ""), across(x), up(y));
    context.fillText(String(text ?? ""), across(x), up(y));
  }
}
