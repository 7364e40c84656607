// Only what has changed is drawn, and nothing else has.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

for (const [name, address] of [["a plan", "#room=lshape&planner=boustrophedon&speed=64&slip=harsh&show=coverage,estimate"], ["a behaviour", "#room=lshape&behaviour=random_walk&speed=64"], ["a cat and dirt", "#room=living&behaviour=random_walk&speed=64"]]) {
  test(`after many frames of ${name} the picture is the one that a fresh drawing gives`, async (t) => {
    const { page, app } = await openApp(t, { address, deviceScaleFactor: 1.5 });
    await app.numbersThat(({ coverage }) => coverage > 6);
    await app.pause();
    const look = () =>
      page.evaluate(() => {
        const floor = document.getElementById("floor");
        const { data } = floor.getContext("2d").getImageData(0, 0, floor.width, floor.height);
        const before = window.looked;
        window.looked = data;
        return before ? data.reduce((sum, value, i) => sum + (Math.abs(value - before[i]) > 2 ? 1 : 0), 0) : -1;
      });
    await app.frames(3);
    await look();
    // Other colours, and back: everything is drawn again.
    for (const colorScheme of ["dark", "light"]) {
      await page.emulateMedia({ colorScheme });
      await app.frames(3);
    }
    assert.equal(await look(), 0, "values of pixels differ");
  });
}
