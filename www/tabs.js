// @ts-check
// The tabs of the page: one of them is shown, and its name is in the address.
import { byId } from "./dom.js";

const TABS = /** @type {const} */ (["explore", "program", "compare", "map", "floor-plan", "connection"]);
/** @typedef {typeof TABS[number]} Tab */
/** Names in older links. @type {Record<string, Tab>} */
const OLD = { draft: "floor-plan", robot: "connection" };

/** @type {Tab} */
let current = "explore";

export const currentTab = () => current;
/** Whether the floor of Explore is shown: Program has it, too. */
export const isOnFloor = () => panelOf(current) === panelOf("explore");
/** @param {Tab} name */
const panelOf = (name) => byId(`panel-${name === "program" ? "explore" : name}`);

/** @param {Tab} next */
export function go(next) {
  current = next;
  for (const name of TABS) {
    panelOf(name).hidden = panelOf(name) !== panelOf(next);
    const tab = byId(`tab-${name}`);
    if (name === next) {
      tab.setAttribute("aria-current", "page");
      tab.scrollIntoView({ block: "nearest", inline: "nearest" });
    } else tab.removeAttribute("aria-current");
  }
  document.body.dataset.tab = next;
  // Messages show in every tab.
  panelOf(next).querySelector(".notices")?.prepend(byId("message"));
  document.dispatchEvent(new Event("tab"));
}

/** The tab that a link leads to; older links name it `place`. @param {string} link @returns {Tab} */
export function tabOf(link) {
  const pairs = new URLSearchParams(link);
  const name = pairs.get("tab") ?? pairs.get("place") ?? "";
  return TABS.find((known) => known === name) ?? OLD[name] ?? "explore";
}

/** @param {(next: Tab) => void} enter Opens a tab, once it is loaded. */
export function startTabs(enter) {
  for (const name of TABS) byId(`tab-${name}`).addEventListener("click", () => enter(name));
}
