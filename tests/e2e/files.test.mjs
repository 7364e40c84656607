// Maps in, by picker and by drop, and scenarios out and in again.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { anyFile, mapYaml, openRoom, pgm, png, textMap } from "./maps.mjs";

const ROOM = openRoom(40, 30);

for (const way of ["pick", "drop"]) {
  test(`takes every kind of map (${way})`, async (t) => {
    const { app } = await openApp(t, { address: "#room=empty" });
    const kinds = [
      { name: "image", files: [png("image.png", ROOM)], size: "2.0 × 1.5 m" },
      { name: "scan", files: [mapYaml("scan.yaml", "scan.pgm", { resolution: 0.1 }), pgm("scan.pgm", ROOM)], size: "4.0 × 3.0 m" },
      { name: "drawing", files: [textMap("drawing.txt", ROOM, { resolution: 0.2 })], size: "8.0 × 6.0 m" },
    ];
    for (const { name, files, size } of kinds) {
      await app[way](...files);
      assert.equal(await app.message(), "", name);
      assert.equal(await app.room(), name);
      assert.ok((await app.text("#room-note")).replaceAll("\u00a0", " ").includes(`${size},`), name);
      assert.equal(await app.state(), "playing");
      const { plan } = await app.metric("Cells visited");
      assert.equal(plan.split(" of ")[0], plan.split(" of ")[1], name);
    }
  });
}

test("a saved scenario brings everything back", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=lshape&planner=snake&robot=cell&cell=0.25&seed=5" });
  await app.tool("wall");
  await app.drag([0.4, 0.4], [0.6, 0.4]);
  const [area, steps] = [await app.reachableArea(), (await app.metric("Steps")).plan];
  const [download] = await app.save("scenario");
  assert.match(download.suggestedFilename(), /^l-shaped-room-changed\.json$/);
  const saved = anyFile("again.json", fs.readFileSync(await download.path()));

  await app.choose("room", "flat");
  await app.choose("algorithm", "boustrophedon");
  await app.choose("robot", "roomba600");
  await app.drop(saved);
  assert.equal(await app.message(), "");
  // It is the room that was drawn, not one more.
  await app.poll(() => app.room(), (name) => name === "L-shaped room (changed)");
  await app.linked("kept");
  assert.equal(await page.evaluate(() => JSON.parse(localStorage.getItem("own-rooms") ?? "[]").length), 1);
  assert.equal(await page.locator("#algorithm").inputValue(), "snake");
  assert.equal(await page.locator("#robot").inputValue(), "cell");
  assert.equal(await page.locator("#cell-size").inputValue(), "0.25");
  assert.equal(await page.locator("#seed").inputValue(), "5");
  assert.equal(await app.reachableArea(), area);
  assert.equal((await app.metric("Steps")).plan, steps);
  // The same file can be chosen twice, and undo leads back to the room before.
  await app.pick(saved);
  await app.press("Undo");
  await app.press("Undo");
  await app.settled();
  assert.equal(await app.room(), "Furnished flat");
});
