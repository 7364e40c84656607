// @ts-check
// Keeps mapping runs in this browser, one for each combination of room, robot and choices: they go on after a reload.
import { byId, setHidden, setText, button } from "../dom.js";
import { download } from "../files.js";
import { clock } from "../format.js";
import { complain, textOf, toast } from "../messages.js";
import { ASIDE, KEPT, done, openDatabase, write } from "./database.js";
import { dropLast, keepLast, theLast } from "./last.js";
import { stored_ros_map } from "../../workshop.js";

/**
 * @typedef {import("./database.js").Kept} Kept
 * @typedef {import("./tab.js").MapTab} MapTab
 */

/** Milliseconds between two looks at whether there is something new to keep. */
const EVERY = 3000;
/** The loss of a shorter run isn't reported, s. */
const LITTLE = 0.1;

/** @param {MapTab} it */
export function startKeeping(it) {
  const { session } = it;
  /** @type {Promise<IDBDatabase> | undefined} */
  let opened;
  const open = () => (opened ??= openDatabase());
  /** The recipe of the displayed run, once requested. */
  let recipe = "";
  /** Whether its stored run has been read: before that, nothing overwrites it. */
  let isKnown = false;
  /** The last stored state: its time, and its text. */
  let kept = "";
  let text = "";
  /** Its moment once the database has it. */
  let written = "";
  let last = 0;
  let warned = false;
  /** Whether a map was just left by another choice. */
  let hasParted = false;

  /** @param {unknown} error */
  const warn = (error) => {
    if (warned) return;
    warned = true;
    console.warn(error);
    toast(error instanceof DOMException && error.name === "QuotaExceededError" ? "This browser has no storage left for this map. Export it before you leave." : "This browser doesn't keep maps (a private window?). Export yours before you leave.");
  };

  /** Reads the stored run of the displayed recipe. @param {string} now */
  const look = async (now) => {
    [recipe, isKnown, kept, text] = [now, false, "", ""];
    try {
      await caughtUp;
      let found = await get(now);
      // The robot had been given a map.
      const given = now === session.home() ? await get(mark(now)) : undefined;
      if (given) found = (await get(given.text)) ?? found;
      // Another run can have been started meanwhile.
      if (recipe !== now || session.recipe() !== now) return;
      if (found && it.view.time_s === 0 && it.view.end_s === 0) void bring(found);
      else if (hasParted) toast("A new map begins. To return to the last one, choose the previous settings again.");
      hasParted = false;
      isKnown = true;
    } catch (error) {
      warn(error);
      isKnown ||= recipe === now;
    }
  };

  /** @param {string} key @returns {Promise<Kept | undefined>} */
  const get = async (key) => done((await open()).transaction(KEPT).objectStore(KEPT).get(key));

  /** @param {string} key */
  const remove = (key) => void open().then((database) => done(database.transaction(KEPT, "readwrite").objectStore(KEPT).delete(key))).catch(warn);

  /** What was kept in the last moment goes where the rest is, unless that is newer. How far the run had come then. */
  const catchUp = async () => {
    const left = theLast();
    if (!left) return undefined;
    const entries = [];
    for (const entry of left.entries) {
      const had = await get(entry.recipe);
      if (!had || had.saved < entry.saved) entries.push(entry);
    }
    await write(await open(), entries);
    dropLast();
    return left;
  };
  let caughtUp = catchUp().catch(() => undefined);
  /** The loss of a run is reported once. @param {string} key */
  const told = async (key) => {
    if ((await caughtUp)?.recipe === key) caughtUp = Promise.resolve(undefined);
  };

  /** @param {Kept} found */
  const bring = async (found) => {
    try {
      session.resume(found.text);
      recipe = session.recipe();
      text = found.text;
      kept = written = moment(it);
      const left = await caughtUp;
      const lost = left && left.recipe === found.recipe && found.end !== undefined ? left.end - found.end : 0;
      void told(found.recipe);
      if (lost > LITTLE) complain(`The run resumes ${lost < 60 ? `${lost.toFixed(1)} s` : `${clock(lost)} min`} before where you left it: this browser had no storage left for the rest.`);
    } catch (error) {
      putAside(found.text);
      explain(textOf(error), found.text);
    }
  };

  /** @param {string} what */
  const putAside = (what) => {
    void open()
      .then((database) => done(database.transaction(ASIDE, "readwrite").objectStore(ASIDE).put({ text: what, saved: Date.now() })))
      .catch(warn);
  };

  /** Explains why a run can't be continued, and offers its map. @param {string} why @param {string} what */
  const explain = (why, what) => {
    complain(`${why}. It stays in this browser; save a copy below if you need it.`);
    setHidden(byId("map-aside"), false);
    setText(byId("map-aside-why"), `${why.charAt(0).toUpperCase()}${why.slice(1)}.`);
    button("map-aside-save").onclick = () => {
      try {
        for (const { name, bytes, kind } of stored_ros_map(what, "stored-map")) download(name, bytes, kind);
      } catch {
        // A text that can't be read is kept.
        download("stored-map.json", what, "application/json");
      }
    };
  };
  button("map-aside-close").addEventListener("click", () => setHidden(byId("map-aside"), true));

  /** The state to be stored, unless it is stored already. */
  const news = () => {
    if (!isKnown || session.recipe() !== recipe) return undefined;
    const now = session.store();
    if (!now) return undefined;
    text = now;
    const [saved, end, home] = [Date.now(), it.view.end_s, session.home()];
    const given = home === recipe ? [] : [{ recipe: mark(home), text: recipe, saved }];
    return [{ recipe, text: now, saved, end }, ...given];
  };
  const save = () => {
    if (kept === moment(it)) return;
    const entries = news();
    if (!entries) return;
    const now = (kept = moment(it));
    void open()
      .then((database) => write(database, entries))
      .then(() => {
        written = now;
        // A newer state can still be being written.
        if (kept === now) dropLast();
      })
      .catch(warn);
  };
  const leave = () => {
    const entries = written === moment(it) ? undefined : news();
    if (entries) keepLast({ recipe, end: it.view.end_s, entries });
    save();
  };
  addEventListener("pagehide", leave);
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && leave());

  return {
    save,
    /** Another choice has left a map. */
    parted: () => void (hasParted = true),
    /** Once a frame while the tab is shown. */
    tend() {
      const now = session.recipe();
      if (now !== recipe) void look(now);
      if (session.take_strayed()) {
        putAside(text);
        explain("the program has changed since this map was stored, so the run can't be repeated", text);
      }
      const at = performance.now();
      if (at - last < EVERY && it.view.phase === "playing") return;
      if (at - last < 300) return;
      last = at;
      save();
    },
    /** Deletes the stored state of the displayed run. */
    forget() {
      kept = written = "";
      dropLast();
      void told(recipe);
      remove(recipe);
    },
    /** The map that the robot was given is given back, or another one comes: a reload won't bring it. */
    leave: () => remove(mark(session.home())),
  };
}

/** Under which it is kept that the robot had been given a map, with its recipe for a text. @param {string} home */
const mark = (home) => `given a map: ${home}`;

/** Key of a mapping run's state. @param {MapTab} it */
const moment = ({ view }) => `${view.time_s} ${view.end_s} ${view.version} ${view.phase === "held"}`;
