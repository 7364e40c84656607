// @ts-check
// Files in and out: picker, drop anywhere, download, link.
import { button, byId, input } from "./dom.js";
import { complain, textOf } from "./messages.js";

/** @param {import("./main.js").App} app */
export function startFiles(app) {
  const picker = input("files");
  button("load").addEventListener("click", () => picker.click());
  picker.addEventListener("change", () => {
    app.bring([...(picker.files ?? [])]);
    // So that the same file can be chosen again.
    picker.value = "";
  });

  startDrop(app.bring);

  const scenario = () => app.act((p) => download(`${fileName(app.view.room.title)}.json`, p.scenario_json(), "application/json"));
  // Errors of loading shouldn't prevent saving.
  const save = button("save");
  save.addEventListener("click", () => {
    save.setAttribute("aria-busy", "true");
    void import("./save.js").then(({ openSave }) => openSave(app)).catch(scenario).finally(() => save.removeAttribute("aria-busy"));
  });

  button("rooms-open").addEventListener("click", () => {
    const failed = (/** @type {unknown} */ error) => complain(`The rooms could not be opened (${textOf(error)}). Check the connection, then try again.`);
    void import("./explore/rooms.js").then(({ openRooms }) => openRooms(app)).catch(failed);
  });

  const share = button("share");
  share.disabled = false;
  share.addEventListener("click", () => {
    const failed = (/** @type {unknown} */ error) => complain(`The link could not be copied (${textOf(error)}). Check the connection, then try again.`);
    void import("./explore/share.js").then(({ copyLink }) => copyLink(app)).catch(failed);
  });
}

/** Takes files that are dropped anywhere on the page. @param {(files: File[]) => void} take */
function startDrop(take) {
  const overlay = byId("drop");
  let depth = 0;
  const holdsFiles = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.includes("Files") ?? false;
  const show = (/** @type {number} */ next) => {
    depth = Math.max(next, 0);
    overlay.hidden = depth === 0;
  };
  addEventListener("dragenter", (event) => holdsFiles(event) && show(depth + 1));
  addEventListener("dragleave", (event) => holdsFiles(event) && show(depth - 1));
  addEventListener("dragover", (event) => {
    if (holdsFiles(event)) event.preventDefault();
  });
  addEventListener("drop", (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    show(0);
    take([...(event.dataTransfer?.files ?? [])]);
  });
}

/** @param {string} title */
export function fileName(title) {
  const plain = title.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "");
  return plain || "room";
}

/** @param {string} name @param {BlobPart} content @param {string} type */
export function download(name, content, type) {
  const url = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
