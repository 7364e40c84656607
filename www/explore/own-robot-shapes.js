// @ts-check
// The shapes that one can choose for an own robot.

/** Kinds of shapes, with the names of their figures. @type {Record<import("../types").OwnShape, { title: string, figures: string[] }>} */
export const SHAPES = {
  model: { title: "As the model", figures: [] },
  circle: { title: "Circle", figures: ["Diameter"] },
  rectangle: { title: "Rectangle", figures: ["Width", "Length"] },
  octagon: { title: "Octagon", figures: ["Width"] },
  polygon: { title: "Polygon", figures: [] },
};
