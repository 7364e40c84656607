// @ts-check
// Applies the settings of a lesson to the page.
import { complain, textOf } from "../messages.js";
import { settingsOf } from "../settings-link.js";

/** What links of lessons don't name is as on a new page. */
export const DEFAULTS = "seed=1&slip=none&noise=off&quantised=false&charge=100&odometry=arc";

/**
 * @param {import("../main.js").App} app
 * @param {string} link Settings, as in links; `tab=...` in it opens that tab.
 * @param {boolean} plays Whether it starts at once.
 */
export async function applyLink(app, link, plays) {
  const settings = settingsOf(link);
  const tab = settings.get("tab") ?? "explore";
  const hasSettings = ["room", "robot", "planner", "behaviour"].some((key) => settings.has(key));
  if (tab !== "explore") {
    // The tab reads the rest of its link.
    location.hash = hasSettings ? `${DEFAULTS}&${link}` : `${app.playground.link()}&${link}`;
    return;
  }
  document.getElementById("tab-explore")?.click();
  const flat = settings.get("room") === "own" ? settings.get("flat") : null;
  if (flat) {
    const { openFlat } = await import("../explore/flat.js");
    const failed = await openFlat(app, flat).then(() => "", textOf);
    if (failed) return complain(failed);
  }
  if (hasSettings && !app.act((p) => p.restore(`search=0&${DEFAULTS}&${link}`))) return;
  app.act((p) => {
    if (!plays) p.reset();
    else p.play();
  });
}

/** @param {import("../main.js").App} app @param {string} scenario */
export async function applyScenario(app, scenario) {
  document.getElementById("tab-explore")?.click();
  await app.takeFiles([{ name: "scene.json", bytes: new TextEncoder().encode(scenario) }]);
}
