// @ts-check
// Own rooms in the menu of rooms.
import { changed, make, select } from "../dom.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { currentId, list } from "./own-rooms.js";

/** Lists the own rooms in the menu of rooms, but for the one that is shown. @param {import("../main.js").App} app @returns {() => void} To be called in every frame. */
export function startMenu(app) {
  const menu = select("room");
  const group = make("optgroup", { label: "Your rooms" });
  const isDue = atMostEvery(500);
  return () => {
    if (!isDue()) return;
    const id = currentId(app);
    const others = list().filter((room) => room.id !== id);
    if (!changed(group, "rooms", JSON.stringify(others))) return;
    group.replaceChildren(...others.map((room) => make("option", { value: `:${room.id}` }, room.name)));
    const shown = menu.value;
    if (others.length === 0) group.remove();
    else if (!group.isConnected) menu.append(group);
    menu.value = shown;
  };
}
