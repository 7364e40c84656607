// @ts-check
// An own robot between the fields of its form and the text of links, `radius:0.2,tool:0.25`.

/**
 * @typedef {object} OwnForm Figures as they are typed; empty for the model's.
 * @property {string} shape
 * @property {string} first
 * @property {string} second
 * @property {string} corners
 * @property {boolean} cleansAll
 * @property {string} tool
 * @property {string[]} at Ahead, to the left.
 * @property {string} speed
 * @property {string} turn
 * @property {string} wheels
 * @property {string[]} without
 */

/** Kinds of shapes, with the names of their figures. @type {Record<string, { title: string, figures: string[] }>} */
export const SHAPES = {
  model: { title: "As the model", figures: [] },
  circle: { title: "Circle", figures: ["Diameter"] },
  rectangle: { title: "Rectangle", figures: ["Width", "Length"] },
  octagon: { title: "Octagon", figures: ["Width"] },
  polygon: { title: "Polygon", figures: [] },
};
/** A corner of an octagon lies tan 22.5° of half its width off the middle of a side. */
const TAN = Math.SQRT2 - 1;

/** A number of the form; throws a sentence for users if it isn't one. @param {string} text @param {string} name */
function figure(text, name) {
  const value = text.trim() === "" ? NaN : Number(text);
  if (!Number.isFinite(value)) throw `${name}: "${text}" is not a number; type metres, e.g. 0.35`;
  return value;
}

/** Corners of a shape; `undefined` for one without. @param {OwnForm} own @returns {number[][] | undefined} */
export function cornersOf({ shape, first, second, corners }) {
  if (shape === "rectangle") {
    const [y, x] = [figure(first, "Width") / 2, figure(second, "Length") / 2];
    return [[x, -y], [x, y], [-x, y], [-x, -y]];
  }
  if (shape === "octagon") {
    const far = figure(first, "Width") / 2;
    const near = TAN * far;
    return [[far, -near], [far, near], [near, far], [-near, far], [-far, near], [-far, -near], [-near, -far], [near, -far]];
  }
  if (shape !== "polygon") return undefined;
  const list = corners.split(/[;\n]/).map((corner) => corner.trim()).filter(Boolean);
  return list.map((corner, index) => {
    const numbers = corner.split(/[\s,]+/).map(Number);
    if (numbers.length !== 2 || !numbers.every(Number.isFinite)) throw `Corner ${index + 1}, "${corner}", is not two numbers; write x y; x y; … in metres`;
    return numbers;
  });
}

/** A figure as it is typed. @param {number} value */
const plain = (value) => String(+value.toFixed(6));

/** The shape with these corners, each x and y, and its figures. @param {number[]} numbers @returns {Pick<OwnForm, "shape" | "first" | "second" | "corners">} */
function shapeOf(numbers) {
  const most = (/** @type {number} */ axis) => plain(2 * Math.max(...numbers.filter((_, index) => index % 2 === axis)));
  const [first, second] = [most(1), most(0)];
  for (const shape of ["rectangle", "octagon"]) {
    const own = cornersOf(/** @type {OwnForm} */ ({ shape, first, second }))?.flat() ?? [];
    const isIt = own.length === numbers.length && own.every((value, index) => Math.abs(value - (numbers[index] ?? NaN)) < 1e-5);
    if (isIt) return { shape, first, second: shape === "rectangle" ? second : "", corners: "" };
  }
  const corners = numbers.flatMap((x, i) => (i % 2 ? [] : [`${plain(x)} ${plain(numbers[i + 1] ?? 0)}`])).join("; ");
  return { shape: "polygon", first: "", second: "", corners };
}

/** The text of a link. Throws a sentence for users if a field can't be read. @param {OwnForm} own */
export function writeOwn(own) {
  /** @type {string[]} */
  const parts = [];
  if (own.shape === "circle") parts.push(`radius:${figure(own.first, "Diameter") / 2}`);
  const corners = cornersOf(own);
  if (corners) parts.push(`corners:${corners.flat().join("_")}`);
  if (own.cleansAll) parts.push("tool:body");
  else {
    if (own.tool) parts.push(`tool:${figure(own.tool, "Tool width")}`);
    if (own.at.some(Boolean)) parts.push(`at:${own.at.map((text) => (text ? figure(text, "Tool") : 0)).join("_")}`);
  }
  if (own.speed) parts.push(`speed:${figure(own.speed, "Speed")}`);
  if (own.turn) parts.push(`turn:${figure(own.turn, "Turns at")}`);
  if (own.wheels) parts.push(`wheels:${own.wheels}`);
  if (own.without.length) parts.push(`without:${own.without.join("-")}`);
  return parts.join(",");
}

/** The fields for a text. @param {string} text @returns {OwnForm} */
export function readOwn(text) {
  const parts = text.split(",").map((part) => /** @type {[string, string]} */ (part.split(":")));
  const of = (/** @type {string} */ key) => parts.find(([name, value]) => name === key && value !== "body")?.[1] ?? "";
  const numbers = of("corners").split("_").map(Number);
  const round = { shape: "circle", first: plain(2 * Number(of("radius"))), second: "", corners: "" };
  const model = { shape: "model", first: "", second: "", corners: "" };
  return {
    ...(of("radius") ? round : numbers.length > 2 ? shapeOf(numbers) : model),
    cleansAll: text.split(",").includes("tool:body"),
    tool: of("tool"),
    at: of("at") ? of("at").split("_") : ["", ""],
    speed: of("speed"),
    turn: of("turn"),
    wheels: of("wheels"),
    without: of("without") ? of("without").split("-") : [],
  };
}
