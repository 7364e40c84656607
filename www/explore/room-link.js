// @ts-check
// Links with an own room: one that is kept in this browser, or that the link carries.
import { WRITTEN } from "../keep.js";
import { openFlat } from "./flat.js";
import { OLD, addRoom, keptAs, openRoom, remove, scenarioOf, show } from "./own-rooms.js";
import { pack, unpack } from "./pack.js";
import { isRenamed, renamed } from "./scenario.js";

/** @typedef {import("../main.js").App} App */

/** Shows the own room of a link: one that is kept here, or the one that the link carries. @param {App} app @param {string} link @returns {Promise<string>} why not, if it can't be */
export async function openLink(app, link) {
  const pairs = new URLSearchParams(link);
  const [id, map, flat] = [pairs.get("kept") ?? "", pairs.get("map"), pairs.get("flat")];
  if (flat) return openFlat(app, flat).then(() => "", String);
  const here = id ? scenarioOf(id) : null;
  const unread = "The room of this link could not be read.";
  // Back and forward lead to the room as it is now.
  if (here && (!map || history.state === WRITTEN || (await pack(here).catch(() => "")) === map)) return (await openRoom(app, id)) ? "" : unread;
  if (map) {
    try {
      const scenario = await unpack(map);
      // Its link may be from before it got its name.
      if (here && isRenamed(here, scenario)) return (await openRoom(app, id)) ? "" : unread;
      // One that was opened before is shown as this link has it.
      const same = keptAs(scenario);
      const shown = same ? show(app, same.id, same.name, renamed(scenario, same.name), false) : addRoom(app, JSON.parse(scenario).name || "Room of a link", scenario);
      return (await shown) ? "" : unread;
    } catch (error) {
      console.warn(error);
      return "The room in this link is damaged, perhaps because the link was cut off. Ask its author for the whole link, or for the scenario file.";
    }
  }
  const old = scenarioOf(OLD);
  if (old) {
    remove(OLD);
    return (await addRoom(app, JSON.parse(old).name || "Own room", old)) ? "" : unread;
  }
  return "This link's room was drawn or loaded in another browser, and the link doesn't carry it. Ask its author to press Copy link, or for the scenario file.";
}
