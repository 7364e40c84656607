// @ts-check
// Pictures of the floor to be sent: with a line below that says what they show. Loaded when one is saved.
import { select } from "./dom.js";
import { clock, metres, percent } from "./format.js";

/** @typedef {import("./main.js").App} App */

/** Height of the line below the picture, as a share of its width, and limits, pixels. */
const LINE = { share: 0.032, least: 22, most: 56 };

/** What is shown: room, algorithm and robot, and how far the robot is. @param {App} app */
export function caption({ view }) {
  const chosen = (/** @type {string} */ id) => select(id).selectedOptions[0]?.textContent ?? "";
  return [`${view.room.title}: ${chosen("algorithm")}, ${chosen("robot")}`, `${percent(view.coverage)} %   ${clock(view.time_s)}   ${metres(view.distance_m)} m`];
}

/** Size of a picture that is at most so wide; even, as encoders want it. @param {HTMLCanvasElement} floor @param {number} most */
export function sizeOf(floor, most) {
  const width = 2 * Math.floor(Math.min(floor.width, most) / 2);
  const line = Math.round(Math.max(LINE.least, Math.min(LINE.most, width * LINE.share)));
  return { width, height: 2 * Math.floor((floor.height * (width / floor.width) + line) / 2), line };
}

/**
 * Draws the floor as it is shown, with the line below.
 * @param {App} app @param {HTMLCanvasElement} floor
 * @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} into @param {{ width: number, height: number, line: number }} size
 */
export function drawShown(app, floor, into, { width, height, line }) {
  const style = getComputedStyle(document.body);
  into.fillStyle = style.backgroundColor;
  into.fillRect(0, 0, width, height);
  into.imageSmoothingQuality = "high";
  into.drawImage(floor, 0, 0, width, height - line);
  const [what, numbers] = caption(app);
  const gap = line * 0.4;
  into.fillStyle = style.color;
  into.textBaseline = "middle";
  into.font = `600 ${line * 0.5}px ${style.fontFamily}`;
  into.textAlign = "right";
  into.fillText(numbers ?? "", width - gap, height - line / 2);
  const room = width - 3 * gap - into.measureText(numbers ?? "").width;
  into.font = `400 ${line * 0.5}px ${style.fontFamily}`;
  into.textAlign = "left";
  into.fillText(what ?? "", gap, height - line / 2, room);
}

/** The floor as it is shown, as a PNG file. @param {App} app @returns {Promise<Blob>} */
export function picture(app) {
  const floor = /** @type {HTMLCanvasElement} */ (document.getElementById("floor"));
  const size = sizeOf(floor, 4096);
  const canvas = new OffscreenCanvas(size.width, size.height);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser can't draw it");
  drawShown(app, floor, context, size);
  return canvas.convertToBlob({ type: "image/png" });
}
