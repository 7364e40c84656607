// @ts-check
// A twin of the robot, made from the recording that is replayed: its figures, its predictions, the robot in Explore.
import { Twin } from "../../workshop.js";
import { button, byId, input, make, setHidden, setText } from "../dom.js";
import { download } from "../files.js";
import { textOf } from "../messages.js";

/** @typedef {import("../types").TwinFigure} TwinFigure @typedef {import("../types").Prediction} Prediction */

/** @param {import("../main.js").App} app */
export function startTwin(app) {
  const [told, figures, checks, second] = [byId("twin-told"), byId("twin-figures"), byId("twin-checks"), input("twin-second")];
  /** Content and name of the recording, once there is one. @type {{ text: string, name: string } | undefined} */
  let recording;
  /** @type {Twin | undefined} */
  let twin;

  /** Does what takes a moment once the page shows that it is at it. @param {string} words @param {() => void} what */
  const work = (words, what) => {
    setText(told, words);
    setHidden(told, false);
    requestAnimationFrame(() =>
      setTimeout(() => {
        try {
          what();
          setHidden(told, true);
        } catch (error) {
          setText(told, textOf(error));
        }
      }),
    );
  };

  button("replay-twin").addEventListener("click", () => {
    const from = recording;
    if (!from) return;
    forget();
    work("Fitting the twin…", () => {
      twin = new Twin(from.text);
      figures.replaceChildren(...twin.figures().map(figureRow));
      setHidden(byId("twin"), false);
    });
  });
  button("twin-explore").addEventListener("click", () => {
    const link = twin?.link();
    if (link && app.act((p) => p.restore(link))) byId("tab-explore").click();
  });
  button("twin-save").addEventListener("click", () => twin && download(`${recording?.name ?? "robot"}-twin.json`, twin.json(), "application/json"));
  button("twin-check").addEventListener("click", () => second.click());
  second.addEventListener("change", async () => {
    const chosen = second.files?.[0];
    second.value = "";
    if (!chosen || !twin) return;
    const text = await chosen.text();
    work("Predicting the other recording…", () => {
      checks.replaceChildren(headRow(chosen.name), ...(twin?.check(text) ?? []).map(checkRow));
      setHidden(checks, false);
    });
  });

  const forget = () => {
    twin?.free();
    twin = undefined;
    for (const node of [byId("twin"), told, checks]) setHidden(node, true);
  };
  return {
    /** Begins with another recording, or none. @param {{ text: string, name: string }} [other] */
    begin(other) {
      forget();
      recording = other;
    },
  };
}

/** @param {TwinFigure} figure */
function figureRow({ name, value, uncertainty, model, unit, digits, how }) {
  const number = (/** @type {number | null} */ value) => (value === null ? "–" : value.toFixed(digits));
  const around = uncertainty === null ? "" : ` ± ${number(uncertainty)}`;
  const beside = model === null || uncertainty === null ? "" : `model ${number(model)}`;
  const what = make("span", {}, make("b", {}, name), make("output", {}, value === null ? "" : `${number(value)}${around} ${unit}`), make("small", {}, beside));
  return make("li", {}, what, make("p", { className: "note" }, how));
}

/** @param {string} name */
const headRow = (name) => make("li", { className: "note" }, `How far predictions of ${name} are off:`);

/** @param {Prediction} prediction */
function checkRow({ what, unit, digits, twin, model, how }) {
  const values = make("output", {}, `${twin.toFixed(digits)} ${unit}`);
  return make("li", {}, make("span", {}, make("b", {}, what), values, make("small", {}, `model ${model.toFixed(digits)} ${unit}`)), make("p", { className: "note" }, how));
}
