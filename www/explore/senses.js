// @ts-check
// Sensors and events, in the panel of that name.
import { startDashboard } from "../dashboard.js";
import { startEvents } from "./events.js";
import { style } from "../parts.js";

/** @param {import("../main.js").App} app @returns {Promise<(view: import("../types").PageView) => void>} */
export async function startSenses(app) {
  await style(new URL("../senses.css", import.meta.url).href);
  const updates = [startDashboard(app), startEvents(app)];
  return (view) => updates.forEach((update) => update(view));
}
