// @ts-check
// The comparison as files: numbers as CSV and JSON, charts as SVG and PNG.
import { byId } from "./dom.js";
import { download, fileName } from "./files.js";
import { complain } from "./messages.js";

/** What the style sheet says of charts and a file must say itself. */
const STYLES = ["fill", "stroke", "stroke-width", "stroke-dasharray", "font-family", "font-size", "font-weight", "text-anchor", "opacity"];
/** Pixels of a PNG for each unit of the drawing. */
const SCALE = 2;
const GAP = 24;

/** @param {import("./compare.js").Comparing} it */
export function startExports({ app, comparison }) {
  /** @param {string} ending */
  const name = (ending) => `comparison-${fileName(app.view.room.title)}.${ending}`;
  /** @type {Record<string, () => void | Promise<void>>} */
  const exports = {
    csv: () => download(name("csv"), comparison.csv(), "text/csv"),
    json: () => download(name("json"), comparison.json(), "application/json"),
    svg: () => download(name("svg"), drawing().text, "image/svg+xml"),
    png: async () => download(name("png"), await picture(drawing()), "image/png"),
  };
  byId("exports").addEventListener("click", (event) => {
    const kind = event.target instanceof Element ? event.target.getAttribute("data-export") : null;
    if (!kind) return;
    app.act(() => void Promise.resolve(exports[kind]?.()).catch((error) => complain(`The ${kind.toUpperCase()} could not be made: ${error}`)));
  });
}

/** All charts in one drawing, below each other. */
function drawing() {
  let y = GAP;
  let width = 0;
  const parts = [...byId("charts").querySelectorAll("figure")].map((figure) => {
    const svg = figure.querySelector("svg");
    if (!svg) return "";
    const box = svg.viewBox.baseVal;
    const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
    const [from, to] = [[svg, ...svg.querySelectorAll("*")], [copy, ...copy.querySelectorAll("*")]];
    from.forEach((node, i) => {
      const style = getComputedStyle(node);
      for (const property of STYLES) to[i]?.setAttribute(property, style.getPropertyValue(property));
    });
    const colour = getComputedStyle(figure).color;
    const title = `<text x="${GAP}" y="${y + 12}" fill="${colour}" font-family="sans-serif" font-weight="600" font-size="14">${figure.querySelector("figcaption")?.innerHTML}</text>`;
    const part = `${title}<g transform="translate(${GAP} ${y + 20})">${copy.innerHTML}</g>`;
    y += box.height + 20 + GAP;
    width = Math.max(width, box.width + 2 * GAP);
    return part;
  });
  if (width === 0) throw new Error("there are no charts yet; open Numbers first");
  const ground = getComputedStyle(byId("numbers-view")).backgroundColor;
  const text = `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${y}" viewBox="0 0 ${width} ${y}"><rect width="100%" height="100%" fill="${ground}"/>${parts.join("")}</svg>`;
  return { text, width, height: y };
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
