// @ts-check
// What a scenario says, as text: its room, its name and what was chosen in it.

/** What a scenario says besides its room. */
const CHOICES = ["name", "robot", "twin", "own_robot", "planner", "behaviour", "program", "params", "path", "cell_size", "cell_offset", "seed", "slip", "noise", "quantised", "start_charge_percent", "odometry", "smooth"];

/** What a scenario says of the room, without its name and what was chosen in it. @param {string | null} scenario */
export function roomIn(scenario) {
  try {
    const all = Object.entries(JSON.parse(scenario ?? "null"));
    return JSON.stringify(all.filter(([key]) => !CHOICES.includes(key)));
  } catch {
    return "";
  }
}

/** Whether two scenarios differ by their names alone. @param {string} one @param {string} other */
export function isRenamed(one, other) {
  return renamed(one, "") === renamed(other, "");
}

/** @param {string} scenario @param {string} name */
export function renamed(scenario, name) {
  try {
    return JSON.stringify({ ...JSON.parse(scenario), name });
  } catch {
    return scenario;
  }
}
