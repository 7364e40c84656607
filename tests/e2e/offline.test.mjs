// Without a network: after one visit the whole page works, and a new version takes over when it is asked to.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { writeWorker } from "../../scripts/offline.mjs";
import { filesBelow } from "../../scripts/references.mjs";
import { App, openApp } from "./app.mjs";
import { serveFolder } from "./browser.mjs";
import { DIST } from "./harness.mjs";

const WITH_WORKER = { isNew: true, serviceWorkers: "allow" };

/** Uses the page, and waits until it is kept. */
async function kept(page) {
  await page.mouse.move(20, 20);
  await page.mouse.move(30, 30);
  await page.evaluate(async () => {
    const { serviceWorker } = navigator;
    await serviceWorker.ready;
    if (!serviceWorker.controller) await new Promise((done) => serviceWorker.addEventListener("controllerchange", done, { once: true }));
  });
}

const caches = (page) => page.evaluate(() => window.caches.keys());
/** Versions of all files that a page has asked for. */
const versions = (page) => page.evaluate(() => [...new Set(performance.getEntriesByType("resource").map(({ name }) => new URL(name).searchParams.get("v")).filter(Boolean))]);

test("after one visit everything works with the network cut: opening, every tab, a plan", async (t) => {
  // The browser looks for a new worker in vain.
  const { page, app, server } = await openApp(t, { ...WITH_WORKER, allow: [/sw\.js/, /fetching the script/] });
  await kept(page);
  await page.keyboard.press("?");
  await page.getByText("The page works offline").waitFor();
  await page.keyboard.press("Escape");
  await server.close();
  await page.reload();
  await app.until("playing");
  for (const tab of ["compare", "map", "floor-plan", "connection"]) {
    await page.locator(`#tab-${tab}`).click();
    await page.locator(`#panel-${tab} button:visible`).first().waitFor();
  }
  await page.locator("#tab-explore").click();
  await app.choose("room", "lshape");
  await app.choose("algorithm", "snake");
  assert.match((await app.metric("Planned in")).plan, /\d/);
  await page.locator("#save").click();
  await page.locator("#save-as[open]").waitFor();
});

test("can be installed: the manifest has all that browsers ask for", async (t) => {
  const { page, server } = await openApp(t, { isNew: true });
  await page.mouse.move(20, 20);
  const address = await page.locator("link[rel=manifest]").evaluate((link) => link.href);
  const manifest = await (await fetch(address)).json();
  assert.equal(new URL(manifest.start_url, address).href, server.url);
  assert.equal(new URL(manifest.scope, address).href, server.url);
  for (const { src, sizes, type } of manifest.icons) {
    const bytes = Buffer.from(await (await fetch(new URL(src, address))).arrayBuffer());
    if (type === "image/png") assert.equal(`${bytes.readUInt32BE(16)}x${bytes.readUInt32BE(20)}`, sizes, src);
  }
  assert.ok(manifest.icons.some(({ purpose }) => purpose === "maskable"));
});

// slow: 4 s, two builds of the page are fetched and checked.
test("a new version is announced, waits for the old one, never mixes with it, and leaves nothing of it", async (t) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-e2e-site-"));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  const [site, next] = [path.join(folder, "site"), path.join(folder, "next")];
  fs.symlinkSync(DIST, site);
  // The same page as another build.
  const old = /\?v=([0-9a-f]{12})/.exec(fs.readFileSync(path.join(DIST, "index.html"), "utf8"))[1];
  const fresh = old.replace(/./g, (digit) => (15 - parseInt(digit, 16)).toString(16));
  fs.cpSync(DIST, next, { recursive: true });
  for (const file of filesBelow(next).filter((name) => /\.(html|js|css)$/.test(name))) fs.writeFileSync(file, fs.readFileSync(file, "utf8").replaceAll(old, fresh));
  await writeWorker(next, fresh);

  const server = await serveFolder(site);
  t.after(() => server.close());
  const { page, app } = await openApp(t, WITH_WORKER);
  await page.goto(server.url);
  await app.settled();
  await kept(page);
  assert.equal((await caches(page)).length, 1);

  fs.rmSync(site);
  fs.symlinkSync(next, site);
  await page.evaluate(async () => (await navigator.serviceWorker.getRegistration()).update());
  const update = page.locator("#update");
  await update.waitFor();
  assert.equal((await caches(page)).length, 2);
  // What the old page loads from now on is old, although the server has it no more.
  await page.locator("#tab-compare").click();
  await page.locator("#panel-compare button:visible").first().waitFor();
  assert.deepEqual(await versions(page), [old]);

  // Another window of the old version would be left without its files.
  const other = await page.context().newPage();
  await other.goto(server.url);
  await new App(other).settled();
  assert.deepEqual(await versions(other), [old]);
  await page.bringToFront();
  await update.click();
  await app.says(/open in another tab or window/);
  await other.close();

  await Promise.all([page.waitForEvent("load"), update.click()]);
  await page.locator("body[data-boot=ready]").waitFor();
  assert.deepEqual(await versions(page), [fresh]);
  assert.equal((await caches(page)).length, 1);
  assert.equal(await update.count(), 0);
});
