// @ts-check
// The dialog with own rooms: a new one by its size, and those that are kept in this browser. Loaded when first opened.
import { byId, make } from "../dom.js";
import { complain } from "../messages.js";
import { style } from "../parts.js";
import { dismissSheet } from "../sheets.js";
import { addRoom, currentId, freeName, list, newId, openRoom, put, remove, scenarioOf } from "./own-rooms.js";
import { renamed } from "./scenario.js";

/** @typedef {import("../main.js").App} App */

/** Side of a cell of a new room, m, and limits of its size. */
const CELL = 0.05;
const SIZES = { min: "1", max: "100", step: "any" };

/** @type {Promise<(app: App) => void> | undefined} */
let made;

/** @param {App} app */
export async function openRooms(app) {
  made ??= build(app).catch((error) => {
    made = undefined;
    throw error;
  });
  (await made)(app);
}

/** @param {App} app */
async function build(app) {
  await style(new URL("./rooms.css", import.meta.url).href);
  const [name, width, depth] = [make("input", { type: "text", id: "new-room-name", maxLength: 60, value: "My room" }), size("new-room-width", "5"), size("new-room-depth", "4")];
  const create = make("button", { type: "submit", className: "primary" }, "Create");
  const field = (/** @type {string} */ label, /** @type {HTMLElement} */ control, unit = "") =>
    make("label", { className: "field" }, make("span", { className: "label" }, label), unit ? make("span", { className: "with-unit" }, control, unit) : control);
  const fields = make("div", { className: "new-room-fields" }, field("Name", name), field("Width", width, "m"), field("Depth", depth, "m"), create);
  const about = make("p", { className: "note" }, "An empty room with walls around it. Draw walls and place furniture in it with the tools on the floor.");
  const form = make("form", { className: "new-room" }, make("h3", {}, "New room"), fields, about);
  const items = make("ul", { id: "own-rooms" });
  const none = make("p", { className: "note" }, "None yet. Rooms that you draw in or load are kept here automatically.");
  const undo = make("button", { type: "button", className: "own-undo", hidden: true });
  const close = make("button", { type: "button", className: "quiet square", "aria-label": "Close" });
  close.append(/** @type {Node} */ (byId("help").querySelector("header .icon")).cloneNode(true));
  const dialog = make(
    "dialog",
    { id: "rooms", "aria-labelledby": "rooms-title" },
    make("div", { className: "rooms-inside" }, make("header", {}, make("h2", { id: "rooms-title" }, "Your rooms"), close), form, make("h3", {}, "In this browser"), none, items, undo),
  );
  document.body.append(dialog);
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());

  const leave = () => {
    dialog.close();
    dismissSheet("setup");
  };
  const done = (/** @type {Promise<boolean>} */ shown) => shown.then((worked) => worked && leave(), (error) => complain(`The room could not be opened (${error}).`));
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    done(addRoom(app, name.value.trim() || "My room", emptyRoom(Number(width.value), Number(depth.value))));
  });

  const show = () => {
    const rooms = list();
    none.hidden = rooms.length > 0;
    items.replaceChildren(...rooms.map((room) => item(room)).reverse());
  };
  /** @param {import("./own-rooms.js").OwnRoom} room */
  const item = ({ id, name }) => {
    const isHere = currentId(app) === id;
    const open = make("button", { type: "button", className: "quiet own-name", title: name, onclick: () => done(openRoom(app, id, true)) }, name);
    if (isHere) open.setAttribute("aria-current", "true");
    const rename = () => {
      const box = make("input", { type: "text", value: name, maxLength: 60, "aria-label": `New name of ${name}` });
      const end = (/** @type {boolean} */ isTaken) => {
        const next = box.value.trim();
        if (isTaken && next && next !== name) takeName(app, id, freeName(next, id));
        show();
      };
      box.addEventListener("keydown", (event) => {
        if (event.key !== "Enter" && event.key !== "Escape") return;
        event.preventDefault();
        event.stopPropagation();
        end(event.key === "Enter");
      });
      box.addEventListener("blur", () => end(true), { once: true });
      open.replaceWith(box);
      box.select();
    };
    const duplicate = () => {
      const scenario = scenarioOf(id);
      const copy = freeName(`${name} copy`);
      if (scenario) put({ id: newId(), name: copy }, renamed(scenario, copy));
      show();
    };
    const drop = () => {
      const scenario = scenarioOf(id) ?? "";
      // The floor shows another room then.
      if (isHere) app.act((p) => p.select_room(app.catalogue.rooms[0]?.id ?? ""));
      remove(id);
      undo.hidden = false;
      undo.textContent = `Bring back ${name}`;
      undo.onclick = () => {
        put({ id, name }, scenario);
        undo.hidden = true;
        show();
        items.querySelector("button")?.focus();
      };
      show();
      undo.focus();
    };
    const button = (/** @type {string} */ label, /** @type {() => void} */ what) =>
      make("button", { type: "button", className: "quiet", "aria-label": `${label} ${name}`, onclick: what }, label);
    return make("li", {}, open, button("Rename", rename), button("Duplicate", duplicate), button("Delete", drop));
  };

  return () => {
    undo.hidden = true;
    show();
    dialog.showModal();
    // On a phone the keyboard would cover the list.
    if (matchMedia("(hover: hover)").matches) name.select();
  };
}

/** @param {string} id @param {string} value */
const size = (id, value) => make("input", { type: "number", id, value, required: true, ...SIZES });

/** @param {App} app @param {string} id @param {string} name */
function takeName(app, id, name) {
  const scenario = scenarioOf(id);
  if (scenario) put({ id, name }, renamed(scenario, name));
  if (currentId(app) === id) app.act((p) => p.rename_room(name));
}

/** A room with nothing but walls around it, as a scenario. @param {number} width m @param {number} depth m */
export function emptyRoom(width, depth) {
  // A wall is a cell; large rooms have larger ones.
  const resolution = Math.max(width, depth) > 40 ? 2 * CELL : CELL;
  const [columns, rows] = [width, depth].map((metres) => Math.round(metres / resolution));
  const [inside, wall] = [`#${".".repeat(columns ?? 0)}#`, "#".repeat((columns ?? 0) + 2)];
  const lines = [wall, ...Array.from({ length: rows ?? 0 }, () => inside), wall];
  return JSON.stringify({ format: "robovac-scenario", version: 2, name: "", resolution, width: wall.length, height: lines.length, rows: lines });
}
