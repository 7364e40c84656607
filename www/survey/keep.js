// @ts-check
// Keeps surveys in this browser, one for each combination of room, robot and choices: they go on after a reload.
import { byId, setHidden, setText, button } from "../dom.js";
import { download } from "../files.js";
import { complain, textOf, toast } from "../messages.js";
import { stored_ros_map } from "../../survey.js";

/**
 * @typedef {{ recipe: string, text: string, saved: number }} Kept
 * @typedef {import("./place.js").Surveying} Surveying
 */

const DATABASE = "robovac-maps";
const KEPT = "surveys";
/** What can't go on, and had better not be lost. */
const ASIDE = "aside";
/** Surveys that are kept; the oldest gives way. */
const MOST = 24;
/** Milliseconds between two looks at whether there is something new to keep. */
const EVERY = 3000;

/** @param {Surveying} it */
export function startKeeping(it) {
  const { survey } = it;
  /** @type {Promise<IDBDatabase> | undefined} */
  let opened;
  const open = () => (opened ??= openDatabase());
  /** What is being shown, as far as it was asked for. */
  let recipe = "";
  /** Whether what was kept of it has been looked for: before, nothing is written over it. */
  let isKnown = false;
  /** What was kept last of it: its moment, and its text. */
  let kept = "";
  let text = "";
  let last = 0;
  let warned = false;

  /** @param {unknown} error */
  const warn = (error) => {
    if (warned) return;
    warned = true;
    console.warn(error);
    toast(error instanceof DOMException && error.name === "QuotaExceededError" ? "There is no room left in this browser to keep this map. Export it before you leave." : "This browser keeps no maps, as in private windows. Export yours before you leave.");
  };

  /** Looks for what was kept of what is shown now. @param {string} now */
  const look = async (now) => {
    [recipe, isKnown, kept, text] = [now, false, "", ""];
    try {
      let found = await get(now);
      // The robot had been given a map.
      const given = now === survey.home() ? await get(mark(now)) : undefined;
      if (given) found = (await get(given.text)) ?? found;
      // Something else may have been chosen or begun meanwhile.
      if (recipe !== now || survey.recipe() !== now) return;
      if (found && it.view.time_s === 0 && it.view.end_s === 0) bring(found);
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

  /** @param {Kept} found */
  const bring = (found) => {
    try {
      survey.resume(found.text);
      recipe = survey.recipe();
      text = found.text;
      kept = moment(it);
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

  /** Tells why something can't go on, and offers what is left of it. @param {string} why @param {string} what */
  const explain = (why, what) => {
    complain(`${why}. It is kept aside in this browser; save a copy of it below if you need it.`);
    setHidden(byId("survey-aside"), false);
    setText(byId("survey-aside-why"), `${why.charAt(0).toUpperCase()}${why.slice(1)}.`);
    button("survey-aside-save").onclick = () => {
      try {
        for (const { name, bytes, kind } of stored_ros_map(what, "stored-map")) download(name, bytes, kind);
      } catch {
        // What can't be read is at least not lost.
        download("stored-map.json", what, "application/json");
      }
    };
  };
  button("survey-aside-close").addEventListener("click", () => setHidden(byId("survey-aside"), true));

  const save = () => {
    if (!isKnown || survey.recipe() !== recipe || kept === moment(it)) return;
    const now = survey.store();
    if (!now) return;
    kept = moment(it);
    text = now;
    const what = { recipe, text: now, saved: Date.now() };
    const home = survey.home();
    const given = home === recipe ? [] : [{ recipe: mark(home), text: recipe, saved: Date.now() }];
    void open().then((database) => write(database, [what, ...given])).catch(warn);
  };
  for (const [target, event] of /** @type {[EventTarget, string][]} */ ([[window, "pagehide"], [document, "visibilitychange"]])) {
    target.addEventListener(event, () => save());
  }

  return {
    save,
    /** Once a frame while the place is shown. */
    tend() {
      const now = survey.recipe();
      if (now !== recipe) void look(now);
      if (survey.take_strayed()) {
        putAside(text);
        explain("the program drives otherwise than when this map was stored, so it doesn't get there any more", text);
      }
      const at = performance.now();
      if (at - last < EVERY && it.view.phase === "playing") return;
      if (at - last < 300) return;
      last = at;
      save();
    },
    /** Forgets what was kept of what is shown. */
    forget() {
      kept = "";
      remove(recipe);
    },
    /** The map that the robot was given is given back, or another one comes: a reload won't bring it. */
    leave: () => remove(mark(survey.home())),
  };
}

/** Under which it is kept that the robot had been given a map, with its recipe for a text. @param {string} home */
const mark = (home) => `given a map: ${home}`;

/** Tells one state of a survey from another. @param {Surveying} it */
const moment = ({ view }) => `${view.time_s} ${view.end_s} ${view.version} ${view.phase === "held"}`;

/** @returns {Promise<IDBDatabase>} */
function openDatabase() {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore(KEPT, { keyPath: "recipe" });
    request.result.createObjectStore(ASIDE, { autoIncrement: true });
  };
  return done(request);
}

/** @param {IDBDatabase} database @param {Kept[]} what */
async function write(database, what) {
  const store = database.transaction(KEPT, "readwrite").objectStore(KEPT);
  for (const each of what) await done(store.put(each));
  const all = /** @type {Kept[]} */ (await done(store.getAll()));
  const old = all.sort((a, b) => b.saved - a.saved).slice(MOST);
  for (const { recipe } of old) await done(store.delete(recipe));
}

/** What a request comes to. @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
function done(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser's store doesn't answer"));
    if (request instanceof IDBOpenDBRequest) request.onblocked = () => reject(new Error("the store is open elsewhere"));
  });
}
