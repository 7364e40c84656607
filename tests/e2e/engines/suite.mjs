// The checks as tests of one browser.
import assert from "node:assert/strict";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { ends } from "../ends.mjs";
import { openPage } from "../harness.mjs";
import { CHECKS } from "./checks.mjs";
import { serveWatched } from "./watched.mjs";

/**
 * Declares all checks, and those of this browser alone.
 * @param {string} name @param {() => Promise<import("./engine.mjs").Engine>} start @param {typeof CHECKS} own
 */
export function checkIn(name, start, own) {
  let started;
  ends.push(async () => (await started?.catch(() => undefined))?.close());

  /** Declares a test with the browser and an origin of its own, where nothing is kept from before. */
  const declare = (title, what) =>
    test(`${name}: ${title}`, async (t) => {
      const browser = await (started ??= start());
      const server = await serveWatched();
      t.after(async () => {
        // Waited for in vain after some failures.
        const patience = new Promise((resolve) => setTimeout(resolve, 5000).unref());
        if (!t.passed) await Promise.race([patience, browser.screenshot(t.name.replace(/\W+/g, "-")).catch(() => {})]);
        await server.close();
      });
      await what(t, browser, server);
    });

  declare("what goes wrong is noticed", async (_, browser, { url, problems }) => {
    await browser.open(url);
    // By a script of the page's own: what tests evaluate is not quite that.
    const script = `setTimeout(() => {
      console.error("logged by the page");
      throw new Error("thrown by the page");
    });
    Promise.reject(new Error("rejected by the page"));
    new Worker("planted-worker.js", { type: "module" });`;
    await browser.evaluate((text) => document.head.append(Object.assign(document.createElement("script"), { textContent: text })), script);
    const planted = ["logged by the page", "thrown by the page", "rejected by the page", "logged by a worker", "thrown by a worker"];
    const patience = AbortSignal.timeout(10_000);
    while (!planted.every((what) => problems().some((problem) => problem.includes(what)))) {
      assert.ok(!patience.aborted, `only these were: ${problems().join("\n")}`);
      await browser.evaluate(() => new Promise((later) => setTimeout(later, 20)));
    }
  });
  for (const [title, check] of Object.entries({ ...CHECKS, ...own })) {
    declare(title, async (t, browser, { url, problems }) => {
      const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-e2e-"));
      t.after(() => fs.rmSync(folder, { recursive: true }));
      const inChromium = async (address, what) => (await openPage(t, { address })).page.evaluate(`(${what})()`);
      await check({ page: browser, url, inChromium, folder, t });
      // What is on its way arrives before this does.
      await browser.evaluate(() => fetch("problem").then(() => undefined));
      assert.deepEqual(problems(), [], "the page reported problems");
    });
  }
}
