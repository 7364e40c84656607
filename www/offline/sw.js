// @ts-check
// The service worker: keeps the whole page for use without a network. scripts/offline.mjs fills in the build and its
// files and puts this beside index.html, whose folder it serves.
//
// A page and its worker are of one build. A new build is fetched completely and checked beside the old one, then waits
// until no page of the old one is open, or until the only one asks for it.

const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/** Digest of the build. */
const BUILD = "@BUILD@";
/** Its files: address from this folder, and digest of the content. @type {Record<string, string>} */
const FILES = {};

const HOME = worker.registration.scope;
/** Caches of other pages of the same server have other names. */
const OURS = `robovac ${HOME} `;
const CACHE = OURS + BUILD;
/** The document for every address of the page. */
const INDEX = "index.html";

worker.addEventListener("install", (event) => event.waitUntil(fetchAll()));

worker.addEventListener("activate", (event) => event.waitUntil(dropOld().then(() => worker.clients.claim())));

worker.addEventListener("fetch", (event) => {
  const path = pathOf(event.request);
  if (path !== undefined) event.respondWith(answer(event.request, path));
});

worker.addEventListener("message", (event) => event.data === "take over" && event.waitUntil(takeOver(event)));

/** Address of a file of this build from this folder; `undefined` for all other requests. @param {Request} request */
function pathOf({ url, method, mode }) {
  if (method !== "GET" || !url.startsWith(HOME)) return undefined;
  const { pathname, searchParams } = new URL(url);
  const path = decodeURIComponent(pathname.slice(new URL(HOME).pathname.length));
  if (mode === "navigate" && path === "") return INDEX;
  const isOther = mode !== "navigate" && (searchParams.get("v") ?? BUILD) !== BUILD;
  return Object.hasOwn(FILES, path) && !isOther ? path : undefined;
}

/** @param {Request} request @param {string} path */
async function answer(request, path) {
  const kept = await (await caches.open(CACHE)).match(path, { ignoreVary: true });
  return kept ?? fetch(request);
}

/** Fetches what has changed since the last build; all or nothing. */
async function fetchAll() {
  const cache = await caches.open(CACHE);
  const older = (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== CACHE);
  try {
    // One after the other: nobody waits for it.
    for (const [path, digest] of Object.entries(FILES)) {
      if (!(await cache.match(path, { ignoreVary: true }))) await cache.put(path, (await reused(older, path, digest)) ?? (await fetched(path, digest)));
    }
  } catch (error) {
    await caches.delete(CACHE);
    throw error;
  }
}

/** The same file of an older build. @param {string[]} older @param {string} path @param {string} digest */
async function reused(older, path, digest) {
  for (const name of older) {
    const response = await (await caches.open(name)).match(path, { ignoreVary: true });
    if (response && (await digestOf(response.clone())) === digest) return response;
  }
  return undefined;
}

/** @param {string} path @param {string} digest */
async function fetched(path, digest) {
  const isIndex = path === INDEX;
  // The folder itself: some servers redirect from the name of its document, and a redirection answers no navigation.
  const response = await fetch(isIndex ? HOME : `${path}?v=${BUILD}`, { cache: isIndex ? "no-cache" : "default" });
  if (!response.ok) throw new Error(`${path}: status ${response.status}`);
  // While a new build is being uploaded, files of two builds are there. Servers may add to documents.
  const isRight = isIndex ? (await response.clone().text()).includes(BUILD) : (await digestOf(response.clone())) === digest;
  if (!isRight) throw new Error(`${path} is of another build`);
  return response;
}

/** @param {Response} response */
async function digestOf(response) {
  const bytes = new Uint8Array(await crypto.subtle.digest("SHA-256", await response.arrayBuffer()));
  return Array.from(bytes.subarray(0, 8), (byte) => byte.toString(16).padStart(2, "0")).join("");
}

async function dropOld() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(OURS) && name !== CACHE).map((name) => caches.delete(name)));
}

/** Replaces the older build if only the page that asks is open; answers whether it does. @param {ExtendableMessageEvent} event */
async function takeOver({ ports }) {
  const pages = await worker.clients.matchAll({ type: "window", includeUncontrolled: true });
  const isAlone = pages.filter(({ url }) => url.startsWith(HOME)).length <= 1;
  ports[0]?.postMessage(isAlone);
  if (isAlone) await worker.skipWaiting();
}
