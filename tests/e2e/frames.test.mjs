// Only what has changed is drawn, and nothing else has.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

for (const [name, address] of [["a plan", "#room=lshape&planner=boustrophedon&speed=64&slip=harsh&show=coverage,estimate"], ["a behaviour", "#room=lshape&behaviour=random_walk&speed=64"], ["a cat and dirt", "#room=living&behaviour=random_walk&speed=64"]]) {
  test(`after many frames of ${name} the picture is the one that a fresh drawing gives`, async (t) => {
    const { page, app } = await openApp(t, { address, deviceScaleFactor: 1.5 });
    await app.numbersThat(({ coverage }) => coverage > 6);
    await app.pause();
    await app.frames(3);
    /** How many values of pixels differ from those of the first look. */
    const differing = () =>
      page.evaluate(() => {
        const floor = document.getElementById("floor");
        const { data } = floor.getContext("2d").getImageData(0, 0, floor.width, floor.height);
        window.first ??= data;
        return data.reduce((sum, value, i) => sum + (Math.abs(value - window.first[i]) > 2 ? 1 : 0), 0);
      });
    assert.equal(await differing(), 0);
    // Other colours, and back: everything is drawn again.
    await page.emulateMedia({ colorScheme: "dark" });
    await app.poll(differing, (count) => count > 10_000, "other colours");
    await page.emulateMedia({ colorScheme: "light" });
    await app.poll(differing, (count) => count === 0, "the same picture, by values of pixels that differ");
  });
}
