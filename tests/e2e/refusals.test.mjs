// Files and links that can't be taken: the message names the cause, and nothing else changes.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { anyFile, mapYaml, openRoom, pgm, png, pngOfSize, textMap } from "./maps.mjs";

const ROOM = openRoom(20, 20);

test("maps that can't be taken are refused with the reason, and the room stays", async (t) => {
  const { app } = await openApp(t, { address: "#room=thesis8" });
  await app.pause();
  const [room, area, numbers] = [await app.room(), await app.reachableArea(), await app.numbers()];
  const whole = png("cut.png", ROOM);
  const cases = [
    [[anyFile("nothing.png", "")], /"nothing\.png" is empty/],
    [[anyFile("cut.png", whole.bytes.subarray(0, whole.bytes.length - 30))], /"cut\.png" is (cut off|damaged)/],
    [[anyFile("letter.txt", "Dear reader,\nthis is no map.\n")], /"letter\.txt" is text of an unknown format/],
    [[anyFile("photo.jpg", "\xff\xd8\xff\xe0")], /"photo\.jpg" is/],
    [[pngOfSize("huge.png", 12000, 9000)], /"huge\.png" has 12000 x 9000 pixels, .* scale it down to 6000 x 4500/],
    [[textMap("solid.txt", ["###", "###"])], /"solid\.txt" has no free cell/],
    [[textMap("odd.txt", ["....", "..x."])], /"odd\.txt", line 3, column 3: 'x'/],
    [[mapYaml("map.yaml", "map.pgm"), pgm("other.pgm", ROOM)], /names the image "map\.pgm", but "other\.pgm" was given/],
    [[mapYaml("map.yaml", "map.pgm")], /its cells are in "map\.pgm"; choose both/],
    [[mapYaml("flat.yaml", "flat.pgm", { resolution: 0 }), pgm("flat.pgm", ROOM)], /"flat\.yaml".*resolution can't be "0(\.0)?"/],
    [[anyFile("other.json", "{}")], /"other\.json" is JSON but not a scenario/],
    [[textMap("one.txt", ROOM), textMap("two.txt", ROOM)], /"one\.txt" and "two\.txt" are two maps/],
  ];
  for (const [files, reason] of cases) {
    await app.drop(...files);
    await app.says(reason);
    assert.deepEqual([await app.room(), await app.reachableArea(), await app.numbers()], [room, area, numbers], `${reason}`);
  }
  await app.press("Dismiss");
  assert.equal(await app.message(), "");
});

test("a link that can't be followed says why", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=nowhere" });
  await app.says(/no room "nowhere".*there are: flat/);
  assert.equal(await app.state(), "playing", "and something else is shown meanwhile");
  await page.evaluate(() => (location.hash = "room=thesis8&cell=9"));
  await app.says(/cell size can't be "9"/);
  assert.equal(await app.room(), "Furnished flat");
  await page.evaluate(() => (location.hash = "room=thesis8&p.nothing=9"));
  await app.says(/nothing/);
});
