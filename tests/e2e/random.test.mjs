// Random actions at three sizes end without an error; `node tests/e2e/random.mjs` does 10,000 of them.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./harness.mjs";
import { QUIET, SIZES, actAtRandom } from "./random.mjs";

const EACH = 33;

for (const [index, size] of SIZES.entries()) {
  // slow: 3 s, 33 actions with a frame after each.
  test(`${EACH} random actions at ${size.viewport.width} × ${size.viewport.height}`, async (t) => {
    const { page, server } = await openPage(t, { ...size, init: QUIET });
    page.on("dialog", (dialog) => void dialog.dismiss());
    const problems = [];
    page.on("pageerror", (error) => problems.push(String(error)));
    page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
    const last = await actAtRandom(page, server.url, { count: EACH, seed: 7 + index, problems });
    assert.deepEqual(problems, [], `after\n${last.join("\n")}`);
  });
}
