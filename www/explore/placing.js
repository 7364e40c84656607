// @ts-check
// Placing objects: the menu of kinds, and the bar for the selected one.
import { byId, changed, fill, select, setAttribute, setEnabled, setHidden, setText } from "../dom.js";
import { style, text } from "../parts.js";

/** @param {import("../main.js").App} app @returns {Promise<(view: import("../types").PageView) => void>} */
export async function startPlacing(app) {
  const [fragment] = await Promise.all([text(new URL("./placing.html", import.meta.url)), style(new URL("./placing.css", import.meta.url).href)]);
  byId("placing").innerHTML = fragment;
  const kinds = [...byId("kinds").querySelectorAll("button")];
  for (const node of kinds) {
    node.addEventListener("click", () => app.act((p) => p.set_placing(node.dataset.kind ?? "")));
  }
  const edits = [...byId("selection").querySelectorAll("button")];
  for (const node of edits) {
    node.addEventListener("click", () => {
      if (app.view.selected < 0) return;
      const action = node.dataset.edit ?? "";
      app.act((p) => p.edit_selected(action));
      // The bar can be gone by then.
      if (action === "delete") byId("floor").focus();
    });
  }
  const menu = select("selected");
  menu.addEventListener("change", () => app.act((p) => p.select_object(menu.value === "" ? undefined : Number(menu.value))));

  /** @type {string[]} */
  let names = [];
  return (view) => {
    const { tool, objects, placing, selected, is_carried } = view;
    setHidden(byId("kinds"), tool !== "place");
    for (const node of kinds) setAttribute(node, "aria-pressed", String(node.dataset.kind === placing));
    // Over the floor only while it serves. By keyboard, N selects the next object.
    setHidden(byId("selection"), selected < 0 || is_carried);
    if (changed(menu, "names", objects.join())) {
      names = numbered(objects);
      fill(menu, [["", "Nothing selected"], ...names.map((name, index) => /** @type {[string, string]} */ ([String(index), name]))]);
      changed(menu, "selected", undefined);
    }
    if (changed(menu, "selected", selected)) {
      menu.value = selected < 0 ? "" : String(selected);
      const name = names[selected];
      setText(byId("selection-said"), name ? `${name} selected. Arrow keys move it, Shift + arrow keys turn and resize it, Delete removes it.` : "");
    }
    for (const node of edits) setEnabled(node, selected >= 0);
  };
}

/** Names of objects; those that share one are numbered. @param {string[]} objects */
function numbered(objects) {
  /** @type {Map<string, number>} */
  const seen = new Map();
  return objects.map((name) => {
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    const shown = name[0]?.toUpperCase() + name.slice(1);
    return objects.indexOf(name) === objects.lastIndexOf(name) ? shown : `${shown} ${count}`;
  });
}
