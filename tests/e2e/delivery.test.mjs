// The built folder as a web server delivers it: from any sub-path, each file once, all of one build.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.mjs";

test("works from a sub-path and loads the module once", async (t) => {
  const { page, server } = await openPage(t, { mount: "/some/sub/path/" });
  await page.waitForLoadState("networkidle");

  const addresses = await page.evaluate(() => performance.getEntriesByType("resource").map((entry) => entry.name));
  for (const part of ["robovac-playground.js", "robovac-playground_bg.wasm"]) {
    // A module is its whole address: two addresses would be two modules, each with a state of its own.
    const loaded = new Set(addresses.filter((address) => new URL(address).pathname.endsWith(part)));
    assert.equal(loaded.size, 1, `${part} has one address: ${[...loaded]}`);
  }

  const parts = server.requests.filter((address) => /\.(js|css|wasm)(\?|$)/.test(address) && !/\/sw\.js/.test(address));
  const versions = new Set(parts.map((address) => new URL(address, "http://host").searchParams.get("v")));
  assert.equal(versions.size, 1, `one version: ${parts}`);
  assert.match([...versions][0] ?? "", /^[0-9a-f]{12}$/);
});
