// @ts-check
// The room and its path as files of many kinds: a dialog, loaded with the module that writes them when one first saves.
import init, { export_files, export_formats } from "../floor_plan.js";
import { byId, fill, make, setHidden } from "./dom.js";
import { download, fileName } from "./files.js";
import { complain, textOf, toast } from "./messages.js";
import { style } from "./parts.js";
import { compile } from "./wasm.js";

/** @typedef {import("./main.js").App} App */
/** @typedef {{ id: string, title: string, note: string, needs_path: boolean }} Format */

/** What the page shows, for people. @type {Format[]} */
const SHOWN = [
  { id: "picture", title: "Picture (PNG)", note: "The floor as it is shown, with its numbers", needs_path: false },
  { id: "film", title: "Film of the run (WebM)", note: "The run so far, in at most 14 seconds", needs_path: false },
];

/** @type {Promise<(app: import("./main.js").App, why: string) => void> | undefined} */
let made;

/** @param {import("./main.js").App} app @param {string} [kind] The one to be proposed. @param {string} [why] What happened, if the user didn't ask for this. */
export async function openSave(app, kind, why = "") {
  made ??= build().catch((error) => {
    made = undefined;
    throw error;
  });
  const show = await made;
  const proposed = kind && document.querySelector(`input[name=kind][value=${kind}]`);
  // Before it is shown: a choice takes back what was said.
  if (proposed instanceof HTMLInputElement) proposed.click();
  show(app, why);
  if (proposed instanceof HTMLInputElement) proposed.scrollIntoView({ block: "center" });
}

async function build() {
  await Promise.all([
    compile(new URL("../floor_plan_bg.wasm", import.meta.url)).then((compiled) => init({ module_or_path: compiled })),
    style(new URL("./save.css", import.meta.url).href),
  ]);
  /** @type {Format[]} */
  const formats = [...export_formats(), ...SHOWN];

  const kinds = formats.map(({ id, title, note, needs_path }, i) =>
    make(
      "label",
      { className: "save-kind", ...(needs_path ? { "data-path": "" } : {}) },
      make("input", { type: "radio", name: "kind", value: id, defaultChecked: i === 0 }),
      make("span", {}, make("span", { className: "label" }, title), make("span", { className: "note" }, note)),
    ),
  );
  const mode = make("select", { id: "save-mode" });
  fill(mode, [["trinary", "trinary: floor, wall, unknown"], ["scale", "scale: shades are percentages"], ["raw", "raw: values from 0 to 100"]]);
  const negate = make("input", { type: "checkbox", id: "save-negate" });
  const ros = make(
    "div",
    { className: "row", hidden: true },
    make("label", { className: "field" }, make("span", { className: "label" }, "Mode"), mode),
    make("label", { className: "check" }, negate, make("span", {}, "Light pixels are walls (negate)")),
  );
  const complaint = make("p", { className: "fault", role: "alert", hidden: true });
  const save = make("button", { type: "submit", className: "primary", id: "save-now" }, "Save");
  const form = make(
    "form",
    { method: "dialog" },
    make("header", {}, make("h2", { id: "save-title" }, "Save as"), closer()),
    make("fieldset", { className: "save-kinds" }, make("legend", { className: "hidden-text" }, "Kind of file"), ...kinds),
    ros,
    complaint,
    make("div", { className: "row" }, save),
  );
  const dialog = make("dialog", { id: "save-as", "aria-labelledby": "save-title" }, form);
  document.body.append(dialog);

  const chosen = () => /** @type {string} */ (new FormData(form).get("kind"));
  form.addEventListener("change", () => {
    setHidden(ros, !chosen().startsWith("ros_"));
    complaint.hidden = true;
  });
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });

  return (/** @type {import("./main.js").App} */ app, /** @type {string} */ why) => {
    const [path, knots] = [app.playground.corners(), app.playground.knots()];
    formats.forEach(({ needs_path }, i) => {
      const radio = /** @type {HTMLInputElement} */ (kinds[i]?.querySelector("input"));
      radio.disabled = needs_path && path.length === 0;
      if (radio.disabled && radio.checked) radio.checked = false;
    });
    if (!chosen()) /** @type {HTMLInputElement} */ (kinds[0]?.querySelector("input")).checked = true;
    complaint.textContent = why;
    complaint.hidden = !why;
    form.onsubmit = (event) => {
      try {
        if (["run_mcap", "film"].includes(chosen()) && app.view.run_end_s === 0) throw "There is no run yet: press play first.";
        if (chosen() === "film" || chosen() === "picture") return void shown(app, chosen());
        if (chosen() === "run_mcap") {
          const request = { snapshot: app.playground.snapshot(), corners: path, knots, inputs: app.playground.inputs(), end_s: app.view.run_end_s, log: app.playground.program_log() };
          void import("./bags.js").then(({ saveBag }) => saveBag(request, `${fileName(app.view.room.title)}.run`)).catch((error) => complain(textOf(error)));
          return;
        }
        const files = export_files(chosen(), app.playground.scenario_json(), path, knots, fileName(app.view.room.title), mode.value, negate.checked);
        for (const { name, bytes, kind } of files) download(name, bytes, kind);
      } catch (error) {
        event.preventDefault();
        complaint.textContent = String(error);
        complaint.hidden = false;
      }
    };
    dialog.showModal();
    save.focus();
  };
}

/** Saves what is shown. @param {App} app @param {string} kind */
async function shown(app, kind) {
  const name = fileName(app.view.room.title);
  try {
    const [blob, ending] = kind === "film" ? [await (await import("./run-film.js")).film(app), "webm"] : [await (await import("./show.js")).picture(app), "png"];
    if (!blob) return toast("The film was given up");
    download(`${name}.${ending}`, blob, blob.type);
    toast(`Saved as ${name}.${ending}`);
  } catch (error) {
    complain(`It could not be saved: ${textOf(error)}.`);
  }
}

function closer() {
  const close = make("button", { type: "button", className: "quiet square", "aria-label": "Close" });
  close.addEventListener("click", () => close.closest("dialog")?.close());
  // The same cross as everywhere.
  close.append(/** @type {Node} */ (byId("help").querySelector("header .icon")).cloneNode(true));
  return close;
}
