// @ts-check
// Starts the page and drives it: one frame and one view per animation frame.
import init, { Playground } from "../page.js";
import { byId } from "./dom.js";
import { startFiles } from "./files.js";
import { keepRoom, restoreLink } from "./keep.js";
import { startKeys } from "./keys.js";
import { startLater } from "./explore/later.js";
import { startLayers } from "./explore/layers.js";
import { complain, cover, forgive, isFatal, startMessages, textOf, updateMessage } from "./messages.js";
import { startObjects } from "./explore/objects.js";
import { startPanel } from "./explore/panel.js";
import { currentTab, go, tabOf, startTabs } from "./tabs.js";
import { Planning } from "./planning.js";
import { startPlaybar } from "./explore/playbar.js";
import { startSheets } from "./sheets.js";
import { startStage } from "./explore/stage.js";
import { startTheme } from "./theme.js";
import { startTips } from "./tips.js";
import { updateView } from "./explore/view.js";
import { compile, missing } from "./wasm.js";

/**
 * @typedef {import("./types").PageView} View
 * @typedef {object} App What the modules of the page share.
 * @property {Playground} playground
 * @property {import("./types").Catalogue} catalogue
 * @property {View} view The latest view.
 * @property {(what: (playground: Playground) => void) => boolean} act Runs an action that can fail; returns whether it
 * succeeded.
 * @property {(files: { name: string, bytes: Uint8Array }[]) => Promise<boolean>} takeFiles Reads a map and takes it; says whether it worked.
 * @property {(files: File[]) => void} bring Shows files as a floor plan, before they become the room.
 * @property {() => void} cancelPlanning
 * @property {() => void} keepPlan Ends planning with the best plan so far.
 * @property {() => string} link The link of the current state, after `#`.
 * @property {(key: string) => boolean} tabKey A single key in another tab; says whether it was used.
 */

/** @param {unknown} error */
function die(error) {
  console.error(error);
  cover("failed", "The simulator has stopped", `Internal error: ${textOf(error)}. Reload the page; room and settings are kept.`);
}

async function start() {
  const playground = new Playground(/** @type {HTMLCanvasElement} */ (byId("floor")));
  let alive = true;

  /** @param {() => void} what */
  const guard = (what) => {
    if (!alive) return false;
    try {
      what();
      return true;
    } catch (error) {
      if (isFatal(error)) {
        alive = false;
        die(error);
      } else {
        // Rust throws messages for users; anything else is a mistake of ours.
        if (error instanceof Error) console.error(error);
        complain(textOf(error));
      }
      return false;
    }
  };

  /** @type {App} */
  const app = {
    playground,
    catalogue: Playground.catalogue(),
    view: playground.view(),
    act: (what) => {
      const worked = guard(() => what(playground));
      if (worked) forgive();
      return worked;
    },
    takeFiles: async (files) => {
      /** @type {import("./worker-types").ReadMap} */
      let map;
      try {
        const { readMap } = await import("./workers.js");
        map = await readMap(files);
      } catch (error) {
        if (error instanceof Error) console.warn(error);
        complain(error instanceof Error ? `The map could not be read (${error.message}). Check the connection, then try again.` : textOf(error));
        return false;
      }
      return app.act((p) => p.take_map(map));
    },
    bring: async (files) => {
      await enter("floor-plan");
      others["floor-plan"]?.take?.(files);
    },
    cancelPlanning: () => {
      planning.cancel();
      app.act((p) => p.cancel_plan());
    },
    keepPlan: () => {
      const seconds = planning.keep();
      app.act((p) => p.keep_plan(seconds));
    },
    link: () => [playground.link(), ...(here() ? [here()?.link()] : [])].join("&"),
    tabKey: (key) => here()?.key(key) ?? false,
  };
  const planning = new Planning({
    progress: (id, done, cells, proof, film) => guard(() => playground.plan_progress(id, done, cells, proof, film)),
    finished: (id, cells, seconds, trace, proof) => guard(() => playground.plan_finished(id, cells, seconds, trace, proof)),
    proven: (id, proof) => guard(() => playground.plan_proven(id, proof)),
    failed: (id, message) => guard(() => playground.plan_failed(id, message)),
  });

  /**
   * A tab that is loaded when it is first opened. Its `frame` can return a message to show.
   * @typedef {{ frame(now: number): { message: string, message_kind: string } | void, key(key: string): boolean, link(): string, restore(link: string): void, setDark(dark: boolean): void, take?(files: File[]): void }} Other
   * @type {Record<import("./tabs.js").Tab, (() => Promise<Other>) | undefined>}
   */
  const doors = {
    explore: undefined,
    compare: () => import("./compare/enter.js").then(({ enterCompare }) => enterCompare(app, guard)),
    map: () => import("./map/enter.js").then(({ enterMap }) => enterMap(app)),
    "floor-plan": () => import("./floor-plan/enter.js").then(({ enterFloorPlan }) => enterFloorPlan(app)),
    connection: () => import("./connection/enter.js").then(({ enterConnection }) => enterConnection(app, guard)),
  };
  /** @type {Record<string, Other>} */
  const others = {};
  const here = () => others[currentTab()];
  let isDark = false;
  /** The chosen tab; it can still be loading. */
  let wanted = currentTab();
  /** @param {import("./tabs.js").Tab} next */
  const enter = async (next) => {
    wanted = next;
    const door = doors[next];
    if (door && !others[next]) {
      const tab = byId(`tab-${next}`);
      tab.setAttribute("aria-busy", "true");
      try {
        // Requested twice, it is loading already.
        const coming = door();
        doors[next] = () => coming;
        others[next] = await coming.catch((error) => {
          doors[next] = door;
          throw error;
        });
        others[next].setDark(isDark);
      } catch (error) {
        console.warn(error);
        complain(`${tab.textContent} could not be loaded. Check the connection, then try again.`);
        return;
      } finally {
        tab.removeAttribute("aria-busy");
      }
    }
    if (wanted === next) go(next);
  };

  /** Links that are still being followed: until then, the address is theirs. */
  let following = 0;
  /** @param {string} address */
  const restore = async (address) => {
    const { hash } = new URL(address);
    // Other fragments are positions on the page, such as that of the skip link.
    if (!hash.includes("=")) return;
    const link = hash.slice(1);
    following += 1;
    await restoreLink(app, link);
    await enter(tabOf(link));
    following -= 1;
    here()?.restore(link);
  };
  startTheme((dark) =>
    guard(() => {
      isDark = dark;
      playground.set_dark(dark);
      for (const other of Object.values(others)) other.setDark(dark);
    }),
  );
  await restore(location.href);
  // One after the other, and not the address as it is by then: `keepLink` may have been faster.
  let restored = Promise.resolve();
  addEventListener("hashchange", ({ newURL }) => (restored = restored.then(() => restore(newURL))));
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    playground.pause();
    playground.hold_films();
  }

  startTabs((next) => void enter(next));
  const [stage, playbar] = [startStage(app), startPlaybar(app)];
  const updates = [startPanel(app), playbar.update, startLayers(app), startObjects(app)];
  startFiles(app);
  startKeys(app, [stage, playbar]);
  const updateLater = await startLater(app);

  let isFirst = true;
  /** @param {number} now */
  const frame = (now) => {
    if (!alive) return;
    requestAnimationFrame(frame);
    guard(() => {
      const request = playground.take_plan_request();
      if (request) planning.start(request);
      if (currentTab() === "explore") {
        stage.resized();
        playground.frame(now);
      }
      const view = (app.view = playground.view());
      // Only the opening scene doesn't begin with its beginning.
      if (isFirst && view.time_s > 60) tellOpening();
      else if (view.time_s < 60) endOpening();
      isFirst = false;
      const other = here();
      if (other) return updateMessage(other.frame(now) ?? view);
      updateView(app);
      for (const update of updates) update(view);
      updateLater(view);
    });
  };
  requestAnimationFrame(frame);
  let kept = "";
  const keep = () => guard(() => {
    if (following > 0) return;
    const link = app.link();
    keepLink(link);
    const version = `${link} ${playground.room_version()}`;
    if (version !== kept) keepRoom(app, link);
    kept = version;
  });
  setInterval(keep, 500);
  addEventListener("pagehide", keep);
  document.body.dataset.boot = "ready";
}

/** Explains for a while why the robot has already cleaned; and, until the first input, what the page is. */
function tellOpening() {
  byId("opening").textContent = ": started ten minutes ago";
  setTimeout(endOpening, 15_000);
  byId("welcome").hidden = false;
  for (const sign of ["pointerdown", "keydown"]) addEventListener(sign, () => (byId("welcome").hidden = true), { once: true, capture: true });
}

function endOpening() {
  const told = byId("opening");
  if (told.textContent) told.textContent = "";
}

/** Keeps the address such that it leads back here. @param {string} link */
function keepLink(link) {
  const hash = link.startsWith("#") ? link : `#${link}`;
  if (hash !== location.hash) history.replaceState(null, "", hash);
}

async function boot() {
  startMessages();
  startTips();
  startSheets(byId("panel-explore"), byId("floor"));
  const lack = missing();
  if (lack) {
    startTheme(() => {});
    cover("unsupported", "This browser can't run the simulator", `It lacks ${lack}. Recent versions of Firefox, Chrome, Edge and Safari have it.`);
    return;
  }
  try {
    await init({ module_or_path: await compile(new URL("../page_bg.wasm", import.meta.url)) });
    await start();
  } catch (error) {
    console.error(error);
    cover("failed", "The simulator could not be started", `${textOf(error)}. Check the connection, then reload.`);
  }
}

void boot();
