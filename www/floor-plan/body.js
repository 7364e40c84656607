// @ts-check
// The robot that sweeps: its outline by figures, corners or model, with a small picture.
import { byId, input, make, select, setAttribute, setHidden, setText } from "../dom.js";
import { onNumber, plain, showValue } from "./fields.js";

/** @typedef {import("./types").BodyChoice} Body */

/** Figures of each kind of outline, m. @type {Record<string, [key: string, label: string][]>} */
const FIGURES = { circle: [["radius", "Radius"]], rectangle: [["length", "Length"], ["width", "Width"]], octagon: [["width", "Width"]] };

/** @param {import("./tab.js").FloorPlanTab} it @returns {(view: import("./types").FloorPlanView | undefined) => void} */
export function startBody(it) {
  const kind = select("floor-plan-body");
  const corners = input("floor-plan-corners");
  /** @param {string} label @param {[value: string, title: string][]} options */
  const group = (label, options) => make("optgroup", { label }, ...options.map(([value, title]) => make("option", { value }, title)));
  kind.replaceChildren(
    group("Custom outline", [["octagon", "Octagon"], ["circle", "Circle"], ["rectangle", "Rectangle"], ["polygon", "Polygon"]]),
    group("Robot model", it.app.catalogue.robots.map(({ id, title }) => [`model ${id}`, title])),
  );
  /** @param {Body} body */
  const choose = (body) => void it.set({ body });
  kind.addEventListener("change", () => {
    const [name, id = ""] = kind.value.split(" ");
    // The next shape is about as large as the last one.
    const width = it.view?.body_width ?? 0.4;
    if (name === "model") choose({ kind: "model", id });
    else if (name === "circle") choose({ kind: "circle", radius: Number(plain(width / 2, 3)) });
    else if (name === "rectangle") choose({ kind: "rectangle", length: Number(plain(width, 3)), width: Number(plain(width, 3)) });
    else if (name === "octagon") choose({ kind: "octagon", width: Number(plain(width, 3)) });
    else choose({ kind: "polygon", corners: asCorners(it.view?.body ?? []) || "0.2 -0.2; 0.2 0.2; -0.1 0.2; -0.2 0; -0.1 -0.2" });
  });
  corners.addEventListener("change", () => choose({ kind: "polygon", corners: corners.value }));
  const fields = Object.fromEntries(["first", "second"].map((name) => [name, input(`floor-plan-${name}`)]));
  for (const [index, name] of ["first", "second"].entries()) {
    const field = fields[name];
    if (field) {
      onNumber(field, (value) => {
        const body = it.wanted()?.body;
        const key = body && FIGURES[body.kind]?.[index]?.[0];
        if (body && key) choose(/** @type {Body} */ ({ ...body, [key]: value }));
      });
    }
  }

  return (view) => {
    setHidden(byId("floor-plan-picture"), !view);
    if (!view) return;
    const { body } = view.settings;
    kind.value = body.kind === "model" ? `model ${body.id}` : body.kind;
    setHidden(byId("floor-plan-corners-field"), body.kind !== "polygon");
    if (body.kind === "polygon") showValue(corners, body.corners);
    for (const [index, name] of ["first", "second"].entries()) {
      const figure = FIGURES[body.kind]?.[index];
      setHidden(byId(`floor-plan-${name}-field`), !figure);
      const field = fields[name];
      if (!figure || !field) continue;
      setText(byId(`floor-plan-${name}-label`), figure[1]);
      showValue(field, plain(Number(Reflect.get(body, figure[0]))));
    }
    setText(byId("floor-plan-body-fault"), view.body_fault);
    picture(view);
  };
}

/** @param {[number, number][]} body */
const asCorners = (body) => body.map(([x, y]) => `${plain(x, 3)} ${plain(y, 3)}`).join("; ");

/** The outline from above, looking up. @param {import("./types").FloorPlanView} view */
function picture({ body, body_width, body_fault }) {
  const width = body_width ?? 0;
  const reach = Math.max(width / 2, ...body.flat().map(Math.abs)) || 1;
  const at = (/** @type {[number, number]} */ [x, y]) => `${((-y / reach) * 28).toFixed(2)},${((-x / reach) * 28).toFixed(2)}`;
  const shape = body.length ? `M${body.map(at).join("L")}Z` : "M28,0A28,28 0 1 1 -28,0A28,28 0 1 1 28,0Z";
  setAttribute(byId("floor-plan-body-shape"), "d", body_fault ? "" : shape);
  setText(byId("floor-plan-body-width"), body_width ? `${plain(body_width, 3)} m wide` : "");
}
