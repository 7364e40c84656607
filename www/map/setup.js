// @ts-check
// The settings of the Map tab: the behaviour and its parameters, tracking, wheels and sensors.
import { button, byId, changed, fill, select, setAttribute, setHidden, setText } from "../dom.js";
import { explain } from "../explainer.js";
import { ODOMETRIES, ODOMETRY_TIP } from "../odometry.js";
import { paramField } from "../params.js";

/** Menus by their name in links. */
const MENUS = /** @type {const} */ ([["map-explorer", "explorer", "behaviour"], ["map-track", "track", "tracking"], ["map-counts", "counts", "counts"], ["map-wheels", "wheels", "wheels"], ["map-senses", "senses", "senses"], ["map-grid", "grid", "grid"]]);

/** @param {import("./tab.js").MapTab} it */
export function startSetup(it) {
  const { explorers } = it;
  const made = explorers.filter(({ id }) => id.startsWith("explore_"));
  const own = explorers.filter(({ id }) => id === "program");
  const others = explorers.filter(({ id }) => !id.startsWith("explore_") && id !== "program");
  const menu = select("map-explorer");
  /** @param {string} label @param {typeof explorers} list */
  const group = (label, list) => {
    const node = document.createElement("optgroup");
    node.label = label;
    node.append(...list.map(({ id, title }) => new Option(title, id)));
    return node;
  };
  if (made.length > 0) menu.replaceChildren(group("Exploration", made), group("Cleaning", others), group("Your own", own));
  else fill(menu, [...others, ...own].map(({ id, title }) => [id, title]));
  fill(select("map-counts"), ODOMETRIES);
  setAttribute(byId("map-counts-field"), "data-tip", ODOMETRY_TIP);
  /** A refused field shows the current value again. @param {string} id @param {string} key */
  const choose = (id, key) => {
    it.set(key, select(id).value);
    changed(select(id), "value", undefined);
  };
  for (const [id, key] of MENUS) select(id).addEventListener("change", () => choose(id, key));
  button("map-elsewhere").addEventListener("click", () => byId("tab-explore").click());

  /** @type {Map<string, HTMLElement[]>} */
  let controls = new Map();
  /** @param {import("../types").CatalogueEntry} entry */
  const build = (entry) => {
    controls = new Map();
    // How it keeps track is chosen for all of them, below.
    const fields = entry.params.filter(({ id }) => !["tracking", "odometry"].includes(id)).map((spec) => {
      const made = paramField(spec, (text) => void it.set(`x.${spec.id}`, text), "map");
      controls.set(spec.id, made.controls);
      return made.field;
    });
    byId("map-params").replaceChildren(...fields);
    setText(byId("map-explorer-note"), entry.summary);
    setText(byId("map-explainer-title"), entry.title);
    // The colours of Explore's floor aren't those of this one.
    void explain(byId("map-explainer-text"), entry, it.app.catalogue.rooms, (room) => void it.app.act((p) => p.select_room(room)), false);
  };

  /** @param {import("../types").MapView} view */
  return (view) => {
    for (const [id, , name] of MENUS) {
      const node = select(id);
      const value = view[name];
      if (!changed(node, "value", value)) continue;
      // Levels that differ from sensor to sensor come from Explore.
      if (id === "map-senses") byId("map-senses-mixed").hidden = [...node.options].some((option) => option.value === value && !option.hidden);
      node.value = [...node.options].some((option) => option.value === value) ? value : "mixed";
    }
    const entry = explorers.find(({ id }) => id === view.behaviour);
    if (entry && changed(byId("map-params"), "behaviour", entry.id)) build(entry);
    for (const [id, nodes] of controls) {
      const value = view.params[id];
      for (const node of nodes) {
        if (value === undefined || document.activeElement === node || !changed(node, "value", String(value))) continue;
        if (node instanceof HTMLInputElement && node.type === "checkbox") node.checked = value === true;
        else Reflect.set(node, "value", String(value));
      }
    }
    const perfect = view.wheels === "none" && view.senses === "off";
    setText(byId("map-real-note"), perfect ? "Perfect wheels don't drift: there is nothing to correct." : "Without slip nothing drifts, so perfect wheels in Explore become typical ones here.");
    setHidden(byId("map-expected"), !view.expectation);
    setText(byId("map-expected"), view.expectation);
    setText(byId("map-seed"), String(it.app.view.seed));
    const { robot: model, own_robot: own, twin } = it.app.view;
    const robot = byId("map-robot");
    if (changed(robot, "robot", `${model} ${own ?? ""} ${twin}`)) {
      setText(robot, own || twin ? it.app.playground.robot().title : (it.app.catalogue.robots.find(({ id }) => id === model)?.title ?? ""));
    }
    // Where the setup is in a sheet.
    setText(byId("map-now"), `${select("map-explorer").selectedOptions[0]?.textContent ?? ""}, ${robot.textContent}`);
  };
}
