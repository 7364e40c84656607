// What every end-to-end test needs: the built page served under any folder, in a browser context of its own, and an eye on
// everything that goes wrong.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { after } from "node:test";
import { DIST, ROOT, launchBrowser, serveFolder } from "./browser.mjs";

export { DIST, ROOT, launchBrowser, serveFolder };

const SCREENSHOTS = path.join(ROOT, "target/e2e");

// One browser per test file, started by the first test that needs it. Tests stay apart by a browser context of their own.
let sharedBrowser;
after(async () => (await sharedBrowser)?.close());

/**
 * Opens the built page for the test `t` and closes it afterwards. The test fails if by then the page has logged an error,
 * thrown one, or failed to load a file, unless a pattern in `allow` matches the message.
 *
 * `address` is relative to the folder the page is served from: "", "?room=flat", "www/bench.html".
 * `init` is run in the page before any of its scripts. Other options go to Playwright's browser context.
 */
export async function openPage(t, { address = "", mount = "/", headers, allow = [], init, browser, ...contextOptions } = {}) {
  const server = await serveFolder(DIST, { mount, headers });
  browser ??= await (sharedBrowser ??= launchBrowser());
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 }, ...contextOptions });
  if (init) await context.addInitScript(init);

  const problems = [];
  const note = (message) => {
    if (!allow.some((pattern) => pattern.test(message))) problems.push(message);
  };
  // On the context rather than the page: this includes workers and pages that the page opens.
  context.on("console", (message) => {
    if (message.type() === "error") note(`console: ${message.text()} (${message.location().url})`);
  });
  context.on("weberror", (error) => note(`uncaught: ${error.error().stack ?? error.error()}`));
  context.on("requestfailed", (request) => {
    const cause = request.failure()?.errorText;
    // Leaving or reloading a page drops what it was still loading.
    if (cause !== "net::ERR_ABORTED") note(`failed: ${request.url()} ${cause}`);
  });
  context.on("response", (response) => {
    if (response.status() >= 400) note(`status ${response.status()}: ${response.url()}`);
  });

  const page = await context.newPage();
  const title = t.name.replace(/\W+/g, "-");
  const screenshot = (name = title) => {
    fs.mkdirSync(SCREENSHOTS, { recursive: true });
    return page.screenshot({ path: path.join(SCREENSHOTS, `${name}.png`) });
  };
  t.after(async () => {
    // Taken while it is still there: the first thing to look at when a test fails.
    if (!t.passed) await screenshot(`${title}-end`).catch(() => {});
    // A request that a test answers may still be on its way.
    await context.unrouteAll({ behavior: "ignoreErrors" });
    await context.close();
    await server.close();
    assert.deepEqual(problems, [], "the page reported problems");
  });
  await page.goto(server.url + address);
  return { page, context, server, problems, screenshot };
}
