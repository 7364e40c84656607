// Whatever algorithm and room the menus offer works.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp, values } from "./app.mjs";

/** Cells of the largest room that all algorithms are tried in; in a hall some would take minutes. */
const SMALL = 2500;

test("every algorithm and every room can be chosen, and the robot sets off", async (t) => {
  const { page, app } = await openApp(t);
  const [rooms, all, behaviours] = [(await values(page, "room")).filter((room) => room !== "new-flat"), await values(page, "algorithm optgroup[label^=Path]"), await values(page, "algorithm optgroup[label^=Reactive]")];
  // Lanes have no cells to visit: lanes.test.mjs.
  const planners = all.filter((id) => id !== "lanes");
  assert.ok(rooms.length >= 10 && planners.length >= 2 && behaviours.length >= 1);
  await app.choose("speed", "16");
  const setsOff = async (menu, value, what) => {
    assert.ok(["playing", "finished"].includes(await app.choose(menu, value)), what);
    assert.equal(await app.message(), "", what);
  };
  // The first goes everywhere; native tests have the others in every room of their size.
  const [first, ...others] = planners;
  await app.choose("algorithm", first);
  /** Cells by room. */
  const cells = new Map();
  const visitsAll = async (what) => {
    const { plan } = await app.metric("Cells visited");
    const [visited, reachable] = plan.split(" of ");
    assert.equal(visited, reachable, what);
    await app.poll(() => app.numbers(), ({ coverage, distance }) => coverage > 0 && distance > 0);
    return Number(reachable.replace(/,/g, ""));
  };
  for (const room of rooms) {
    await setsOff("room", room, `${first} in ${room}`);
    cells.set(room, await visitsAll(`${first} in ${room}`));
  }
  // The others share the rooms.
  const small = rooms.filter((room) => cells.get(room) <= SMALL);
  assert.ok(small.length > 5, `${small.length} small rooms`);
  for (const [index, planner] of others.entries()) {
    // Before the algorithm is chosen: it sets to work at once.
    await app.choose("room", small[index % small.length]);
    await setsOff("algorithm", planner, planner);
    await visitsAll(planner);
  }
  for (const [index, behaviour] of behaviours.entries()) {
    await app.choose("room", rooms[index % rooms.length]);
    await setsOff("algorithm", behaviour, behaviour);
  }
});
