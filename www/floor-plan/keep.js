// @ts-check
// Keeps the floor plan in this browser: opened files and their settings are restored after a reload. If that fails, it
// is explained, and the data are set aside until the user deletes them.
import { button, byId, setHidden, setText } from "../dom.js";
import { download } from "../files.js";
import { complain, toast } from "../messages.js";

/**
 * @typedef {import("./tab.js").FloorPlanTab} FloorPlanTab
 * @typedef {{ format: number, files: KeptFile[] }} KeptFiles
 * @typedef {{ name: string, bytes: ArrayBuffer }} KeptFile WebKit stores no `File` in private windows.
 * @typedef {{ format: number, settings: import("./types").FloorPlanSettings, sweeps: boolean, stage: number }} KeptChoices
 * @typedef {{ why: string, files: unknown, choices: unknown }} Aside Data that can't be restored.
 */

const DATABASE = "robovac-drafts";
/** Has "files" and "choices" of one floor plan. */
const STORE = "board";
const ASIDE = "aside";
/** Version of the format; changes when earlier data can no longer be read. */
const FORMAT = 2;
/** From a choice until it is kept, ms. */
const REST_MS = 300;

/** @param {FloorPlanTab} it */
export function startKeeping(it) {
  const { client } = it;
  /** @type {Promise<IDBDatabase> | undefined} */
  let opened;
  const store = async (/** @type {string} */ name) => (await (opened ??= openDatabase())).transaction(name, "readwrite").objectStore(name);
  /** Whether the stored data have been read: before that, nothing overwrites them. */
  let isKnown = false;
  /** The stored data: the files, and the settings as text. @type {File[]} */
  let files = [];
  let choices = "";
  /** The data being restored. @type {{ files: KeptFiles, choices: unknown } | undefined} */
  let coming;
  let warned = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;

  /** @param {unknown} error */
  const warn = (error) => {
    if (warned) return;
    warned = true;
    console.warn(error);
    toast(error instanceof DOMException && error.name === "QuotaExceededError" ? "This browser has no storage left for this floor plan: it won't survive a reload." : "This browser doesn't keep floor plans (a private window?): this one won't survive a reload.");
  };

  const write = async () => {
    const { view } = it;
    if (!isKnown || !view) return;
    const now = JSON.stringify(choicesOf(view));
    if (client.files === files && now === choices) return;
    const isNew = client.files !== files;
    [files, choices] = [client.files, now];
    try {
      const contents = isNew ? await Promise.all(files.map(async (file) => ({ name: file.name, bytes: await file.arrayBuffer() }))) : [];
      const board = await store(STORE);
      const puts = [done(board.put(choicesOf(view), "choices"))];
      if (isNew) puts.push(done(board.put({ format: FORMAT, files: contents }, "files")));
      await Promise.all(puts);
    } catch (error) {
      warn(error);
    }
  };

  let written = Promise.resolve();
  /** One after the other, or else what was chosen last could be overwritten. */
  const save = () => (written = written.then(write));

  /** @param {Aside} aside */
  const putAside = async (aside) => {
    complain(aside.why);
    try {
      await done((await store(ASIDE)).add(aside));
      await showAside();
    } catch (error) {
      warn(error);
    }
  };

  /** Shows the last that was put aside, if there is any, until it is discarded. */
  const showAside = async () => {
    const [key] = /** @type {IDBValidKey[]} */ (await done((await store(ASIDE)).getAllKeys())).slice(-1);
    setHidden(byId("floor-plan-aside"), key === undefined);
    if (key === undefined) return;
    const aside = /** @type {Aside} */ (await done((await store(ASIDE)).get(key)));
    setText(byId("floor-plan-aside-why"), aside.why);
    button("floor-plan-aside-save").onclick = () => {
      const kept = filesOf(aside.files);
      for (const file of kept ?? []) download(file.name, file, file.type);
      const rest = { ...(aside.files && !kept ? { files: aside.files } : {}), ...(aside.choices ? { choices: aside.choices } : {}) };
      if (Object.keys(rest).length > 0) download("kept-floor-plan.json", JSON.stringify(rest, null, 1), "application/json");
    };
    button("floor-plan-aside-discard").onclick = async () => {
      await store(ASIDE).then((aside) => done(aside.delete(key))).catch(warn);
      void showAside().catch(warn);
    };
  };

  /** Restores the stored data, unless another file was opened meanwhile. @param {() => boolean} isFree */
  const bring = async (isFree) => {
    try {
      const board = await store(STORE);
      const [kept, chosen] = await Promise.all(["files", "choices"].map((key) => done(board.get(key))));
      if (kept && isFree()) await layOut(kept, chosen);
      await showAside();
    } catch (error) {
      warn(error);
    }
    isKnown = true;
    void save();
  };

  /** @param {any} kept @param {any} chosen */
  const layOut = async (kept, chosen) => {
    const list = kept.format === FORMAT ? filesOf(kept.files) : undefined;
    if (!list?.length) return putAside({ why: "The floor plan was saved by another version of this page, and this one can't read it.", files: kept.files ?? kept, choices: chosen });
    const names = list.map(({ name }) => name).join(" and ");
    coming = { files: kept, choices: chosen };
    const fits = chosen?.format === FORMAT;
    if (fits) [files, choices] = [list, JSON.stringify(chosen)];
    /** @type {string | undefined} */
    let why;
    const settings = fits ? chosen.settings : {};
    await it.ask({ type: "restore", files: list, settings }, "Restoring the floor plan", (message) => (why = message));
    // It made the worker fail, and has been set aside by now.
    if (!coming) return;
    coming = undefined;
    if (why !== undefined && !it.view) return putAside({ why: `The floor plan ${names} can't be restored: ${why}`, files: kept.files, choices: chosen });
    if (why !== undefined || (chosen && !fits)) await putAside({ why: `The settings for ${names} were saved by another version of this page and don't fit this one${why === undefined ? "" : ` (${why})`}. They were reset, as for a new file.`, files: undefined, choices: chosen });
    else if (fits && chosen.sweeps && it.view?.room) {
      await it.ask({ type: "sweep" }, "Planning the sweep");
      if (chosen.stage > 0) client.say({ type: "stages", stages: [chosen.stage], moves: false });
    }
  };

  addEventListener("pagehide", () => void save());
  return {
    bring,
    /** The session has changed. */
    saw() {
      clearTimeout(rest);
      rest = setTimeout(() => void save(), REST_MS);
    },
    /** The session ended by an error; says whether the restored files caused it, and reports that. @param {string} message */
    broke(message) {
      if (!coming) return false;
      const { files: kept, choices: chosen } = coming;
      coming = undefined;
      void putAside({ why: `The saved floor plan caused an error (${message}), so it wasn't restored.`, files: kept.files, choices: chosen });
      return true;
    },
  };
}

/** @param {import("./types").FloorPlanView} view @returns {KeptChoices} */
const choicesOf = ({ settings, sweep, stage }) => ({ format: FORMAT, settings, sweeps: sweep !== null, stage });

/** The files, if it is files; earlier versions stored them as such. @param {unknown} what @returns {File[] | undefined} */
function filesOf(what) {
  const isFile = (/** @type {any} */ it) => it instanceof File || (typeof it?.name === "string" && it.bytes instanceof ArrayBuffer);
  return Array.isArray(what) && what.every(isFile) ? what.map((it) => (it instanceof File ? it : new File([it.bytes], it.name))) : undefined;
}

/** @returns {Promise<IDBDatabase>} */
function openDatabase() {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore(STORE);
    request.result.createObjectStore(ASIDE, { autoIncrement: true });
  };
  return done(request);
}

/** The result of a request. @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
function done(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser's storage doesn't respond"));
    if (request instanceof IDBOpenDBRequest) request.onblocked = () => reject(new Error("the storage is in use by another tab"));
  });
}
