// The built folder as a web server delivers it: from any sub-path, each file once, all of one build, and nothing before it
// is needed.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { gunzipSync, gzipSync } from "node:zlib";
import { firstLoad } from "../../scripts/references.mjs";
import { openApp } from "./app.mjs";
import { DIST, openPage } from "./harness.mjs";
import { openRoom, png } from "./maps.mjs";

/** Files of the page requested so far, as paths in dist/. */
const transferred = ({ requests }) => new Set(requests.map((address) => path.join(".", new URL(address, "http://host").pathname.replace(/\/$/, "/index.html"))));

test("works from a sub-path and loads each module once", async (t) => {
  const { page, server } = await openPage(t, { mount: "/some/sub/path/", isNew: true });
  await page.waitForLoadState("networkidle");

  const addresses = await page.evaluate(() => performance.getEntriesByType("resource").map((entry) => entry.name));
  for (const part of ["page.js", "page_bg.wasm"]) {
    // A module is its whole address: two addresses would be two modules, each with a state of its own.
    const loaded = new Set(addresses.filter((address) => new URL(address).pathname.endsWith(part)));
    assert.equal(loaded.size, 1, `${part} has one address: ${[...loaded]}`);
  }

  const parts = server.requests.filter((address) => /\.(js|css|wasm)(\?|$)/.test(address) && !/\/sw\.js/.test(address));
  const versions = new Set(parts.map((address) => new URL(address, "http://host").searchParams.get("v")));
  assert.equal(versions.size, 1, `one version: ${parts}`);
  assert.match([...versions][0] ?? "", /^[0-9a-f]{12}$/);
});

test("opening needs no planner and none of the other tabs", async (t) => {
  const { page, app, server } = await openApp(t, { isNew: true });
  await app.numbersThat(({ coverage, distance }) => coverage > 0 && distance > 0);
  await page.waitForLoadState("networkidle");
  const opened = transferred(server);
  const lazy = [
    "workshop.js", "workshop_bg.wasm", "www/worker.js", "www/workers.js", "www/compare/tab.js", "www/compare/compare.css",
    "www/compare/pool.js", "floor_plan_bg.wasm", "www/floor-plan/tab.js", "www/map/tab.js", "www/dashboard.js", "www/joystick.js",
    "www/explore/placing.html", "www/explore/film.js", "www/explore/own-robot.js", "www/help.html", "www/planning.js",
    "www/tips.js", "www/swipe.js", "www/explore/layers.js", "www/explore/ending.js", "www/explore/clear.js",
    "www/explore/trade-off.js", "www/explore/trade-off.css", "www/explore/own-rooms.js", "www/explore/rooms.js", "www/explore/rooms.css", "www/explore/share.js", "learn_bg.wasm",
    "www/learn/enter.js", "www/learn/offer.js",
    "lessons/index.json",
  ];
  for (const file of lazy) {
    assert.ok(fs.existsSync(path.join(DIST, file)), `${file} has another name now`);
    assert.ok(!opened.has(file), `${file} was transferred`);
  }
  // What scripts/size.mjs weighs is what is transferred: nothing else, and nothing less but what this screen doesn't show.
  const weighed = new Set(firstLoad(path.join(DIST, "index.html")).map((file) => path.relative(DIST, file)));
  assert.deepEqual([...opened].filter((file) => !weighed.has(file)), []);
  assert.deepEqual([...weighed].filter((file) => !opened.has(file) && !/\.(svg|png|ico)$/.test(file)), []);
  const kilobytes = [...opened].reduce((sum, file) => sum + gzipSync(fs.readFileSync(path.join(DIST, file)), { level: 9 }).length / 1024, 0);
  t.diagnostic(`${kilobytes.toFixed(1)} KB in ${opened.size} files until the robot drives`);
  assert.equal((await app.metric("Planned in")).plan, "preloaded");

  // The first plan brings the workshop, once for all that follow.
  await app.choose("room", "empty");
  await app.choose("algorithm", "snake");
  assert.match((await app.metric("Planned in")).plan, /\d/);
  assert.equal(server.requests.filter((address) => address.includes("workshop_bg.wasm")).length, 1);
  assert.ok(!transferred(server).has("www/compare/tab.js"));
  await page.locator("#tab-compare").click();
  await page.locator("#panel-compare").waitFor();
  assert.ok(["www/compare/tab.js", "www/compare/compare.css"].every((file) => transferred(server).has(file)));
  assert.equal(server.requests.filter((address) => address.includes("workshop_bg.wasm")).length, 1);
});

test("a planner that can't be loaded is loaded at the next try", async (t) => {
  const { page, app } = await openApp(t, { isNew: true, allow: [/ERR_FAILED/, /ERR_CONNECTION/] });
  const module = /workshop_bg\.wasm/;
  await page.route(module, (route) => route.abort());
  assert.equal(await app.choose("room", "empty"), "failed");
  await app.says(/could not be loaded.*connection/i);
  await page.unroute(module);
  await app.press("Play");
  await app.until("playing");
  assert.equal(await app.message(), "");
});

test("the page goes on while a map of four million cells is read", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8" });
  const inside = openRoom(40, 30);
  const rows = Array.from({ length: 2048 }, (_, y) => (inside[y] ?? "").padEnd(2048, "#"));
  await page.evaluate(() => {
    window.framesWhileReading = 0;
    const look = () => {
      const busy = document.getElementById("floor-plan-busy");
      if (busy?.checkVisibility()) window.framesWhileReading += 1;
      requestAnimationFrame(look);
    };
    look();
  });
  await app.pick(png("large.png", rows));
  assert.equal(await app.message(), "");
  assert.equal(await app.room(), "large");
  const frames = await page.evaluate(() => window.framesWhileReading);
  t.diagnostic(`${frames} frames were drawn meanwhile`);
  assert.ok(frames > 3, `${frames} frames`);
});

test("About leads to the sources of the page", async (t) => {
  const { page } = await openPage(t);
  await page.getByRole("button", { name: "Help" }).click();
  const link = page.getByRole("link", { name: "Source code" });
  const address = await link.evaluate((node) => node.href);
  if (process.env.SOURCE_URL) return assert.equal(address, new URL(process.env.SOURCE_URL).href);
  const bytes = Buffer.from(await (await fetch(address)).arrayBuffer());
  const tar = gunzipSync(bytes);
  assert.ok(tar.includes("robovac-playground/Cargo.toml") && tar.includes("robovac-playground/www/main.js"));
});
