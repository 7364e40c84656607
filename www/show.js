// @ts-check
// Pictures of the floor to be sent: with a line below that says what they show. Loaded when one is saved.
import { select } from "./dom.js";
import { clock, metres, percent } from "./format.js";

/** @typedef {import("./main.js").App} App */

/** Height of the line below the picture, as a share of its width, and limits, pixels. */
const LINE = { share: 0.032, least: 22, most: 56 };

/** Width of a picture that fills a slide; most of a picture, pixels. */
const [SHARP, MOST] = [1920, 4096];

/** Margin round the room, as a share of its larger side; least width of a picture, whose line has to be read, pixels. */
const [MARGIN, LEAST] = [0.03, 480];

/** What is shown: room, algorithm and robot, and how far the robot is. @param {App} app */
export function caption({ view }) {
  const chosen = (/** @type {string} */ id) => select(id).selectedOptions[0]?.textContent ?? "";
  return [`${view.room.title}: ${chosen("algorithm")}, ${chosen("robot")}`, `${percent(view.coverage)} %   ${clock(view.time_s)}   ${metres(view.distance_m)} m`];
}

/**
 * What of the canvas is worth a picture, in its pixels: the room with a margin, without the space that messages take; all of
 * the canvas if the room isn't all on it.
 * @param {App} app @param {HTMLCanvasElement} floor
 */
function part({ playground, view: { room } }, floor) {
  const all = { x: 0, y: 0, width: floor.width, height: floor.height };
  const ratio = floor.width / floor.clientWidth;
  const [scale = 1, x = 0, y = 0] = playground.floor_to_screen().map((value) => value * ratio);
  const [width, height] = [room.width_m * scale, room.height_m * scale];
  const isWhole = x >= 0 && y <= floor.height && x + width <= floor.width && y - height >= 0;
  if (!isWhole) return all;
  // The same for every size of the room on the canvas, which changes when messages come and go.
  const margin = MARGIN * Math.max(width, height);
  return { x: x - margin, y: y - height - margin, width: width + 2 * margin, height: height + 2 * margin };
}

/** Size of a picture that is at most so wide; even, as encoders want it. @param {App} app @param {HTMLCanvasElement} floor @param {number} most */
export function sizeOf(app, floor, most) {
  const shown = part(app, floor);
  const width = 2 * Math.floor(Math.min(Math.max(shown.width, LEAST), most) / 2);
  const line = Math.round(Math.max(LINE.least, Math.min(LINE.most, width * LINE.share)));
  return { width, height: 2 * Math.floor((shown.height * (width / shown.width) + line) / 2), line };
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
  const shown = part(app, floor);
  into.drawImage(floor, shown.x, shown.y, shown.width, shown.height, 0, 0, width, height - line);
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

/** The page draws first in every frame, as it asked for it first. */
export const nextFrame = () => new Promise((done) => requestAnimationFrame(done));

/** Where the room is on the canvas. @param {App} app */
export const placeOf = ({ playground }) => playground.floor_to_screen().join();

/** Waits until the room is drawn where it is to be: messages that come or go move it. @param {App} app */
export async function atRest(app) {
  for (let before = ""; before !== placeOf(app); await nextFrame()) before = placeOf(app);
}

/** The floor as it is shown, as a PNG file that is sharp on a slide, too. @param {App} app @returns {Promise<Blob>} */
export async function picture(app) {
  const { playground } = app;
  const floor = /** @type {HTMLCanvasElement} */ (document.getElementById("floor"));
  const { clientWidth, clientHeight } = floor;
  // Marks of a selection are for editing.
  app.act((p) => p.select_object(undefined));
  await atRest(app);
  const finer = Math.max(1, Math.min(SHARP / part(app, floor).width, MOST / Math.max(floor.width, floor.height)));
  playground.resize(clientWidth, clientHeight, devicePixelRatio * finer);
  try {
    await nextFrame();
    const size = sizeOf(app, floor, MOST);
    const canvas = new OffscreenCanvas(size.width, size.height);
    const context = canvas.getContext("2d");
    if (!context) throw new Error("this browser can't draw it");
    drawShown(app, floor, context, size);
    return await canvas.convertToBlob({ type: "image/png" });
  } finally {
    playground.resize(clientWidth, clientHeight, devicePixelRatio);
  }
}
