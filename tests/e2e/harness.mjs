// What every end-to-end test needs: the built page in a window that no other test uses meanwhile, and an eye on everything
// that goes wrong.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { DIST, ROOT, launchBrowser, serveFolder, withFewFrames, withoutServiceWorkers } from "./browser.mjs";
import { ends } from "./ends.mjs";

export { DIST, ROOT };

const SCREENSHOTS = path.join(ROOT, "target/e2e");

// One browser per process, started by the first test that needs it.
let sharedBrowser;
const servers = [];
ends.push(async () => {
  await (await sharedBrowser)?.close();
  for (const server of servers) await server.close();
});

/**
 * Windows whose tests have passed, by their options. The page opens in them four times as quickly as in new ones, as compiled
 * code and the process are there already; nothing of the test before is.
 */
const idle = new Map();

/** A window of its own for each set of options, with a server: an origin that no other window has. */
async function openWindow({ mount, isNew, init, allFrames, ...asked }) {
  // Only tests of it have a service worker: others ask what the server is asked for.
  const { serviceWorkers, ...options } = asked;
  const server = await serveFolder(DIST, { mount, headers: isNew ? {} : { "cache-control": "max-age=3600" } });
  servers.push(server);
  const browser = await (sharedBrowser ??= launchBrowser());
  const context = await browser.newContext(options);
  if (serviceWorkers !== "allow") await withoutServiceWorkers(context);
  if (!allFrames) await withFewFrames(context);
  if (init) await context.addInitScript(init);
  const window = { server, context, options, allow: [], problems: [] };
  const note = (message) => window.isLeft || window.allow.some((pattern) => pattern.test(message)) || window.problems.push(message);
  // On the context rather than the page: this includes workers and pages that the page opens.
  context.on("console", (message) => {
    if (message.type() === "error") note(`console: ${message.text()} (${message.location().url})`);
  });
  context.on("weberror", (error) => note(`uncaught: ${error.error().stack || String(error.error())}`));
  context.on("requestfailed", (request) => {
    const cause = request.failure()?.errorText;
    // Leaving or reloading a page drops what it was still loading.
    if (cause !== "net::ERR_ABORTED") note(`failed: ${request.url()} ${cause}`);
  });
  context.on("response", (response) => {
    if (response.status() >= 400) note(`status ${response.status()}: ${response.url()}`);
  });
  window.page = await context.newPage();
  return window;
}

/** Makes a window as it was when it was new, but for what is compiled and cached. */
async function tidy(window) {
  const { server, context, options, page } = window;
  // What the page was still loading comes too late, and Chromium says so in the name of the empty page.
  window.isLeft = true;
  for (const other of context.pages()) if (other !== page) await other.close();
  await page.unrouteAll({ behavior: "ignoreErrors" });
  await page.goto("about:blank");
  const session = await context.newCDPSession(page);
  await session.send("Storage.clearDataForOrigin", { origin: new URL(server.url).origin, storageTypes: "all" });
  await session.detach();
  await page.mouse.move(-1, -1);
  await page.setViewportSize(options.viewport);
  await page.emulateMedia({ colorScheme: options.colorScheme ?? "light", reducedMotion: options.reducedMotion ?? "no-preference" });
  server.requests.length = 0;
  window.isLeft = false;
}

/**
 * Opens the built page for the test `t` and closes it afterwards. The test fails if by then the page has logged an error,
 * thrown one, or failed to load a file, unless a pattern in `allow` matches the message.
 *
 * `address` is relative to the folder the page is served from: "", "?room=flat", "www/bench.html".
 * `init` is run in the page before any of its scripts. With `isNew`, nothing is in any cache. With `allFrames`, the page draws
 * as often as for users. Other options go to Playwright's browser context. The window is small unless a test needs it larger:
 * painting is most of what these tests cost.
 */
export async function openPage(t, { address = "", allow = [], init, isNew = init !== undefined, mount = "/", ...contextOptions } = {}) {
  const options = { viewport: { width: 1000, height: 640 }, ...contextOptions };
  const key = JSON.stringify({ mount, ...options });
  const window = (!isNew && idle.get(key)) || (await openWindow({ mount, isNew, init, ...options }));
  if (!isNew) idle.delete(key);
  const { server, context, page } = window;
  Object.assign(window, { allow, problems: [] });

  const title = t.name.replace(/\W+/g, "-");
  const picture = (name) => {
    fs.mkdirSync(SCREENSHOTS, { recursive: true });
    return page.screenshot({ path: path.join(SCREENSHOTS, `${name}.png`) });
  };
  t.after(async () => {
    // Taken while it is still there: the first thing to look at when a test fails.
    if (!t.passed) await picture(`${title}-end`).catch(() => {});
    // A request that a test answers may still be on its way.
    await context.unrouteAll({ behavior: "ignoreErrors" });
    const isReusable = t.passed && !isNew && (await tidy(window).then(() => true, () => false));
    if (isReusable && window.problems.length === 0) idle.set(key, window);
    else await context.close();
    assert.deepEqual(window.problems, [], "the page reported problems");
  });
  await page.goto(server.url + address);
  /** With PICTURES=1 there are pictures in target/e2e to be looked at, besides those of tests that fail. */
  const screenshot = async (name) => (process.env.PICTURES ? picture(name) : undefined);
  return { page, context, server, screenshot };
}
