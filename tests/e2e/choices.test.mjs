// Whatever algorithm and room the menus offer works.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp, values } from "./app.mjs";

/** Cells of the largest room that algorithms which take their time are tried in; in a hall they would take minutes. */
const SMALL = 2500;

test("every algorithm and every room can be chosen, and the robot sets off", async (t) => {
  const { page, app } = await openApp(t);
  const [rooms, all, behaviours] = [await values(page, "room"), await values(page, "algorithm optgroup[label^=Path]"), await values(page, "algorithm optgroup[label^=Reactive]")];
  // Lanes have no cells to visit: lanes.test.mjs.
  const planners = all.filter((id) => id !== "lanes");
  assert.ok(rooms.length >= 10 && planners.length >= 2 && behaviours.length >= 1);
  await app.choose("speed", "256");
  /** By room, once a fast algorithm has been there. */
  const cells = new Map();
  const tried = { fast: 0, slow: 0 };
  for (const [index, planner] of planners.entries()) {
    // Before the algorithm is chosen: it sets to work at once.
    await app.choose("room", "thesis8");
    await app.choose("algorithm", planner);
    const pace = /slow in large halls/.test((await page.locator("#explainer .claims").textContent()) ?? "") ? "slow" : "fast";
    for (const [number, room] of rooms.entries()) {
      // The first goes everywhere, the others share the rooms; native tests have them in every room of their size.
      if (index > 0 && (number + index) % (pace === "slow" ? 8 : 16) !== 0) continue;
      if (pace === "slow" && !(cells.get(room) <= SMALL)) continue;
      tried[pace] += 1;
      const what = `${planner} in ${room}`;
      assert.ok(["playing", "finished"].includes(await app.choose("room", room)), what);
      assert.equal(await app.message(), "", what);
      const { plan } = await app.metric("Cells visited");
      const [visited, reachable] = plan.split(" of ");
      assert.equal(visited, reachable, what);
      cells.set(room, Number(reachable.replace(/,/g, "")));
      await app.poll(() => app.numbers(), ({ coverage, distance }) => coverage > 0 && distance > 0);
    }
  }
  for (const [index, behaviour] of behaviours.entries()) {
    for (const room of rooms.filter((_, number) => (number + index) % 16 === 0)) {
      await app.choose("room", room);
      assert.ok(["playing", "finished"].includes(await app.choose("algorithm", behaviour)), `${behaviour} in ${room}`);
      assert.equal(await app.message(), "", `${behaviour} in ${room}`);
    }
  }
  assert.ok(cells.size === rooms.length && tried.fast > 1.25 * rooms.length && tried.slow >= 5, JSON.stringify(tried));
});
