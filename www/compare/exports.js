// @ts-check
// Exports of comparisons: numbers as CSV and JSON, charts as SVG and PNG.
import { byId, make } from "../dom.js";
import { download, fileName } from "../files.js";
import { complain, textOf } from "../messages.js";

/** Styles of charts from the style sheet, which files must contain themselves. */
const STYLES = ["fill", "fill-opacity", "stroke-linejoin", "stroke-linecap", "stroke", "stroke-width", "stroke-dasharray", "font-family", "font-size", "font-weight", "text-anchor", "opacity"];
/** Pixels of a PNG for each unit of the drawing. */
const SCALE = 2;
const GAP = 24;
/** Type sizes of the line that says where it was measured, and of titles. */
const [SMALL, LARGE] = [12, 14];
/** A letter is about half as wide as high. @param {string} text @param {number} size */
const lengthOf = (text, size) => 0.55 * size * text.length;

/**
 * @typedef {{ name: string, csv: () => string, json: () => string, charts: HTMLElement, place?: string }} Exported `place`: where it was measured, if the charts don't say so.
 * @param {import("../main.js").App} app
 * @param {() => Exported} shown The exports of the current view.
 */
export function startExports(app, shown) {
  /** @param {string} ending */
  const name = (ending) => `${shown().name}-${fileName(app.view.room.title)}.${ending}`;
  const drawn = () => drawing(shown());
  /** @type {Record<string, () => void | Promise<void>>} */
  const exports = {
    csv: () => download(name("csv"), shown().csv(), "text/csv"),
    json: () => download(name("json"), shown().json(), "application/json"),
    svg: async () => download(name("svg"), drawn().text, "image/svg+xml"),
    png: async () => download(name("png"), await picture(drawn()), "image/png"),
  };
  byId("exports").addEventListener("click", (event) => {
    const kind = event.target instanceof Element ? event.target.getAttribute("data-export") : null;
    if (!kind) return;
    app.act(() => void Promise.resolve(exports[kind]?.()).catch((error) => complain(`The ${kind.toUpperCase()} could not be created: ${textOf(error)}.`)));
  });
}

/** All charts in one drawing; several in two columns. @param {Exported} exported */
function drawing({ charts, place = "" }) {
  const found = [...charts.querySelectorAll("figure")].flatMap((figure) => {
    const svg = figure.querySelector("svg");
    return svg ? [{ figure, svg, box: svg.viewBox.baseVal, caption: figure.querySelector("figcaption") }] : [];
  });
  if (found.length === 0) throw new Error("there are no charts yet");
  const column = Math.max(...found.map(({ box, caption }) => Math.max(box.width, lengthOf(caption?.textContent ?? "", LARGE)))) + GAP;
  /** Where the next chart of each column begins. */
  const ends = Array(found.length > 2 ? 2 : 1).fill(GAP + (place ? 2 * SMALL : 0));
  const parts = found.map(({ figure, svg, box, caption }) => {
    const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
    const [from, to] = [[svg, ...svg.querySelectorAll("*")], [copy, ...copy.querySelectorAll("*")]];
    from.forEach((node, i) => {
      const style = getComputedStyle(node);
      for (const property of STYLES) to[i]?.setAttribute(property, style.getPropertyValue(property));
    });
    // The crosshair of the pointer isn't exported.
    for (const live of copy.querySelectorAll("[data-live]")) live.remove();
    const at = ends.indexOf(Math.min(...ends));
    const [x, y] = [GAP + at * column, ends[at]];
    ends[at] += box.height + 20 + GAP;
    const title = `<text x="${x}" y="${y + 12}" fill="${getComputedStyle(figure).color}" font-family="sans-serif" font-weight="600" font-size="${LARGE}">${caption?.innerHTML}</text>`;
    return `${title}<g transform="translate(${x} ${y + 20})">${copy.innerHTML}</g>`;
  });
  const height = Math.max(...ends);
  const ground = getComputedStyle(charts.closest(".ground") ?? charts).backgroundColor;
  const node = make("span", {}, place);
  const head = place ? `<text x="${GAP}" y="${GAP + SMALL}" fill="${getComputedStyle(charts).color}" font-family="sans-serif" font-size="${SMALL}">${node.innerHTML}</text>` : "";
  const width = Math.max(GAP + ends.length * column, lengthOf(place, SMALL) + 2 * GAP);
  const text = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"><rect width="100%" height="100%" fill="${ground}"/>${head}${parts.join("")}</svg>`;
  return { text, width, height };
}

/** @param {{ text: string, width: number, height: number }} drawing @returns {Promise<Blob>} */
async function picture({ text, width, height }) {
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = new OffscreenCanvas(width * SCALE, height * SCALE);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("this browser can't draw");
  context.scale(SCALE, SCALE);
  context.drawImage(image, 0, 0, width, height);
  return canvas.convertToBlob({ type: "image/png" });
}
