// @ts-check
// Starts the page and drives it: one frame and one view per animation frame.
import init, { Playground } from "../page.js";
import { byId } from "./dom.js";
import { startFiles } from "./files.js";
import { keepState } from "./keep.js";
import { startKeys } from "./keys.js";
import { startLater } from "./explore/later.js";
import { startNumbers } from "./explore/numbers.js";
import { startLinks } from "./links.js";
import { complain, cover, forgive, isFatal, startMessages, textOf, updateMessage } from "./messages.js";
import { startObjects } from "./explore/objects.js";
import { startPanel } from "./explore/panel.js";
import { endOpening, tellBefore, tellOpening } from "./explore/opening.js";
import { TabLoader } from "./tab-loader.js";
import { isOnFloor, startTabs } from "./tabs.js";
import { startPlanning } from "./start-planning.js";
import { startPlaybar } from "./explore/playbar.js";
import { startSheets } from "./sheets.js";
import { startStage } from "./explore/stage.js";
import { startTheme } from "./theme.js";
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
 * @property {(files: { name: string, bytes: Uint8Array }[], isRoom?: boolean) => Promise<boolean>} takeFiles Reads a map and takes it, or only its room; says whether it worked.
 * @property {(files: File[]) => void} bring Shows files as a floor plan, before they become the room.
 * @property {() => void} cancelPlanning
 * @property {() => void} keepPlan Ends planning with the best plan so far.
 * @property {string} extra What a part of Explore adds to the link; empty for nothing.
 * @property {string} followed The link that was followed last, without `#`.
 * @property {() => string} link The link of the current state, after `#`.
 * @property {string} lesson What leads to the open lesson; empty for none.
 * @property {boolean} isUnrun Whether the program's text was changed since it was last run.
 * @property {() => Promise<string>} share What the tab adds to a link that is to be passed on.
 * @property {(isDark: boolean) => void} setDark
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
    takeFiles: async (files, isRoom = false) => {
      /** @type {Uint8Array} */
      let map;
      try {
        const { readMap } = await import("./workers.js");
        map = await readMap(files);
      } catch (error) {
        if (error instanceof Error) console.warn(error);
        complain(error instanceof Error ? `The map could not be read (${error.message}). Check the connection, then try again.` : textOf(error));
        return false;
      }
      return app.act((p) => (isRoom ? p.take_room(map) : p.take_map(map)));
    },
    bring: (files) => {
      const lesson = files.find(({ name }) => /\.md$/i.test(name));
      void (lesson ? learn(lesson) : tabs.bring(files));
    },
    lesson: "",
    isUnrun: false,
    cancelPlanning: () => {
      planning.cancel();
      app.act((p) => p.cancel_plan());
    },
    keepPlan: () => {
      const seconds = planning.keep();
      if (seconds !== undefined) app.act((p) => p.keep_plan(seconds));
    },
    extra: "",
    followed: "",
    link: () => [playground.link(), tabs.shown ? tabs.shown.link() : app.extra, app.lesson && `lesson=${encodeURIComponent(app.lesson)}`].filter(Boolean).join("&"),
    share: async () => (await tabs.shown?.share?.()) ?? "",
    setDark: (isDark) => {
      playground.set_dark(isDark);
      tabs.setDark(isDark);
    },
    tabKey: (key) => tabs.shown?.key(key) ?? false,
  };
  const planning = startPlanning(playground, guard);

  const tabs = new TabLoader(app, guard);
  /** Opens or closes Learn. @param {string | File} [lesson] */
  const learn = (lesson) =>
    import("./learn/enter.js")
      .then(({ enterLearn }) => enterLearn(app, lesson))
      .catch((error) => complain(`Learn could not be loaded (${textOf(error)}). Check the connection, then try again.`));
  byId("learn-open").addEventListener("click", () => void learn());
  startTheme((dark) => guard(() => app.setDark(dark)));
  const links = await startLinks(app, tabs, (lesson) => void learn(lesson));
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    playground.hold_motion();
  }

  // An error belongs to the tab in which it was made.
  startTabs((next) => (forgive(), void tabs.enter(next)));
  const [stage, playbar] = [startStage(app), startPlaybar(app)];
  const updates = [startPanel(app), playbar.update, startNumbers(app), startObjects(app)];
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
      if (request) void planning.start({ ...request, place: playground.snapshot() });
      if (isOnFloor()) {
        stage.resized();
        playground.frame(now);
      }
      const view = (app.view = playground.view());
      // Only the opening scene doesn't begin with its beginning.
      if (isFirst && view.time_s > 60 && app.followed === "") tellOpening();
      else if (view.time_s < 60) endOpening();
      tellBefore(view.swept_before);
      isFirst = false;
      const notice = tabs.shown?.frame(now);
      if (!isOnFloor()) return updateMessage(notice ?? view);
      updateView(app);
      for (const update of updates) update(view);
      updateLater(view);
    });
  };
  requestAnimationFrame(frame);
  const keep = () => guard(() => !links.isFollowing() && keepState(app));
  setInterval(keep, 500);
  addEventListener("pagehide", keep);
  // Back right after a tab was opened leads to the one before.
  document.addEventListener("tab", () => setTimeout(keep));
  document.body.dataset.boot = "ready";
}

async function boot() {
  startMessages();
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
