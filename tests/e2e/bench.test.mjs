// The benchmark page, which scripts/bench.mjs opens and people may.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.mjs";

test("benchmark fills its table and hands its results over", async (t) => {
  const { page } = await openPage(t, { address: "www/bench.html?once&runs=2", mount: "/some/sub/path/" });
  await page.waitForFunction(() => "benchResult" in window);
  const results = await page.evaluate(() => window.benchResult);
  assert.ok(results.length >= 3, JSON.stringify(results));
  for (const { name, ms } of results) assert.ok(name !== "" && ms > 0, `${name}: ${ms} ms`);
  const simulator = results.find(({ name }) => name.startsWith("simulate"));
  assert.ok(simulator.times_real_time > 1, `${simulator.times_real_time} times real time`);
  await page.getByText("Done.").waitFor();
  assert.deepEqual(await page.locator("#results th").allTextContents(), results.map(({ name }) => name));
});
