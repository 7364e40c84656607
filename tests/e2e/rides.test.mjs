// Every algorithm that the tab Robot offers drives the virtual Roomba. Other tabs: choices, compare and map.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openRobot } from "./connection.mjs";
import { values } from "./app.mjs";

/** Why a robot is stopped if the page was busy. */
const HELD_UP = /page stopped responding/;
/** How often one algorithm may be stopped by that. */
const MOST_STOPS = 3;

// slow: some forty algorithms take their turn, and a Roomba drives no faster than one on the floor.
test("every algorithm of the menu drives the virtual robot", async (t) => {
  // A small room is soon planned.
  const { page, app, robot } = await openRobot(t, { link: "room=thesis8&behaviour=bounce", allFrames: false });
  await robot.connect();
  await robot.arm();
  const offered = await values(page, "connection-algorithm");
  assert.ok(offered.length > 20, offered.join());
  // Explore lacks those that keep a map.
  assert.ok(offered.includes("learned"), offered.join());
  for (const algorithm of offered) {
    await page.locator("#connection-algorithm").selectOption(algorithm);
    const atStart = page.locator("#connection-to-start");
    // Once may be too few: a robot that is stopped rolls on for a moment, and may leave the start again.
    const isAtStart = () => atStart.evaluate((it) => it.hidden || (it.click(), false));
    const message = page.locator("#panel-connection .message");
    const said = async () => ((await message.isVisible()) ? message.innerText() : "");
    for (let stops = 0; ; stops += 1) {
      if (HELD_UP.test(await said())) {
        await message.getByRole("button").click();
        await robot.arm();
      }
      await app.poll(isAtStart, (is) => is, `the robot to be at the start for ${algorithm}`);
      const before = await robot.distance();
      await page.locator("#connection-go").click();
      await app.poll(async () => (await said()) !== "" || (await robot.distance()) > before, Boolean, `${algorithm} to drive`);
      // As it has to be on a machine that is too busy for a moment.
      if (!HELD_UP.test(await said()) || stops === MOST_STOPS) break;
    }
    assert.equal(await said(), "", algorithm);
    // In so small a room a ride may end by itself before that.
    await page.locator("#connection-end").click({ timeout: 3000 }).catch(() => {});
    await page.locator("#connection-end[aria-disabled=true], #connection-end:disabled").waitFor();
  }
});
