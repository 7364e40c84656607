// @ts-check
// The browser's database of mapping runs.

/**
 * @typedef {{ recipe: string, text: string, saved: number, end?: number }} Kept `saved` is a time of the clock, ms; `end` how far
 *   the run had come, s.
 */

const DATABASE = "robovac-maps";
export const KEPT = "surveys"; // an older name of them
/** Runs that can't be continued and should be kept. */
export const ASIDE = "aside";
/** Mapping runs that are kept; the oldest gives way. */
const MOST = 24;

/** @returns {Promise<IDBDatabase>} */
export function openDatabase() {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore(KEPT, { keyPath: "recipe" });
    request.result.createObjectStore(ASIDE, { autoIncrement: true });
  };
  return done(request);
}

/** @param {IDBDatabase} database @param {Kept[]} what */
export async function write(database, what) {
  const store = database.transaction(KEPT, "readwrite").objectStore(KEPT);
  for (const each of what) await done(store.put(each));
  const all = /** @type {Kept[]} */ (await done(store.getAll()));
  const old = all.sort((a, b) => b.saved - a.saved).slice(MOST);
  for (const { recipe } of old) await done(store.delete(recipe));
}

/** The result of a request. @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
export function done(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser's storage doesn't respond"));
    if (request instanceof IDBOpenDBRequest) request.onblocked = () => reject(new Error("the storage is in use by another tab"));
  });
}
