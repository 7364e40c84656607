// @ts-check
// Copies the link of what is shown, with the room in it if that is an own one.
import { complain, textOf, toast } from "../messages.js";
import { write } from "../keep.js";
import { aboutRoom, settingsOf } from "../settings-link.js";
import { currentTab, isOnFloor } from "../tabs.js";
import { flatOf } from "./flat.js";
import { MOST_PACKED } from "./own-rooms.js";
import { pack } from "./pack.js";

/** @param {import("../main.js").App} app */
export async function copyLink(app) {
  const link = new URL(location.href);
  let hash = app.link();
  const flat = flatOf(app);
  const settings = settingsOf(hash);
  if (flat && settings.get("path") !== "kept") hash = aboutRoom(hash, `flat=${flat}`);
  else if (settings.get("room") === "own") {
    const map = await pack(app.playground.scenario_json()).catch(() => "");
    if (!map || map.length > MOST_PACKED) {
      const why = map ? `takes ${Math.ceil(map.length / 1000)} KB in a link, more than the ${MOST_PACKED / 1000} KB that every other program passes on` : "can't be put into a link by this browser";
      const { openSave } = await import("../save.js");
      return openSave(app, "scenario", `No link was copied: ${currentTab() === "floor-plan" ? "the room in Explore" : "this room"} ${why}. Save it as a scenario file and send that.`);
    }
    hash = aboutRoom(hash, `map=${map}`);
  }
  const more = await app.share().catch((error) => void complain(`No link was copied: ${textOf(error)}`));
  if (more === undefined) return;
  const moment = isOnFloor() ? app.playground.moment_pair() : "";
  const added = [moment, more].map((pair) => pair && `&${pair}`).join("");
  // A lesson is last: its address can have an & of its own.
  link.hash = hash.replace(/(&lesson=.*)?$/, (lesson) => added + lesson);
  let done = "Link copied";
  try {
    await navigator.clipboard.writeText(link.href);
  } catch {
    write(link.hash);
    done = "The link is in the address bar";
  }
  // Without them the link is copied all the same.
  await import("../send.js").then(({ showWays }) => showWays(app, link, done, moment)).catch(() => toast(done));
}
