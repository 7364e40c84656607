// @ts-check
// The tabs that are loaded when they are first opened.
import { byId } from "./dom.js";
import { complain } from "./messages.js";
import { currentTab, go } from "./tabs.js";

/**
 * A loaded tab. Its `frame` can return a message to show.
 * @typedef {{ frame(now: number): { message: string, message_kind: string } | void, key(key: string): boolean, link(): string, restore(link: string): void, setDark(dark: boolean): void, take?(files: File[]): Promise<boolean | void> | void, share?(): Promise<string> }} LoadedTab
 */

export class TabLoader {
  /** How each tab is loaded; Explore is there from the start.
   * @type {Record<import("./tabs.js").Tab, (() => Promise<LoadedTab>) | undefined>} */
  #doors;
  /** @type {Record<string, LoadedTab>} */
  #loaded = {};
  #isDark = false;
  /** The chosen tab; it can still be loading. */
  #wanted = currentTab();

  /** @param {import("./main.js").App} app @param {(what: () => void) => boolean} guard Runs what can fail. */
  constructor(app, guard) {
    this.#doors = {
      explore: undefined,
      program: () => import("./program/enter.js").then(({ enterProgram }) => enterProgram(app)),
      compare: () => import("./compare/enter.js").then(({ enterCompare }) => enterCompare(app, guard)),
      map: () => import("./map/enter.js").then(({ enterMap }) => enterMap(app)),
      "floor-plan": () => import("./floor-plan/enter.js").then(({ enterFloorPlan }) => enterFloorPlan(app)),
      connection: () => import("./connection/enter.js").then(({ enterConnection }) => enterConnection(app, guard)),
    };
  }

  /** The shown tab; `undefined` for Explore. @returns {LoadedTab | undefined} */
  get shown() {
    return this.#loaded[currentTab()];
  }

  /** Loads a tab, then shows it unless another was chosen meanwhile. @param {import("./tabs.js").Tab} next */
  async enter(next) {
    this.#wanted = next;
    const door = this.#doors[next];
    if (door && !this.#loaded[next]) {
      const tab = byId(`tab-${next}`);
      tab.setAttribute("aria-busy", "true");
      try {
        // Requested twice, it is loading already.
        const coming = door();
        this.#doors[next] = () => coming;
        this.#loaded[next] = await coming.catch((error) => {
          this.#doors[next] = door;
          throw error;
        });
        this.#loaded[next].setDark(this.#isDark);
      } catch (error) {
        console.warn(error);
        complain(`${tab.textContent} could not be loaded. Check the connection, then try again.`);
        return;
      } finally {
        tab.removeAttribute("aria-busy");
      }
    }
    if (this.#wanted === next) go(next);
  }

  /** Shows files: programs, results of a study, or else a floor plan. What can't be read leads nowhere else. @param {File[]} files */
  async bring(files) {
    const isAny = (/** @type {RegExp} */ ending) => files.some(({ name }) => ending.test(name));
    const next = isAny(/\.(py|m?js)$/i) ? "program" : isAny(/\.parquet$/i) ? "compare" : "floor-plan";
    const before = currentTab();
    await this.enter(next);
    if ((await this.#loaded[next]?.take?.(files)) === false && currentTab() === next) go(before);
  }

  /** @param {boolean} dark */
  setDark(dark) {
    this.#isDark = dark;
    for (const tab of Object.values(this.#loaded)) tab.setDark(dark);
    // On paper there is no next frame.
    this.shown?.frame(performance.now());
  }
}
