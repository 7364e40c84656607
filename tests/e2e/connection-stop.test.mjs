// The robot stops when nobody is there any more: tabs closed, left, hidden or hung while it drives. LINK_ROUNDS=100 tries each
// of them as often.
import assert from "node:assert/strict";
import { test } from "node:test";
import { noSerial, openDesk, openHidable } from "./serial/desk.mjs";
import { Robot, lastStop, moves } from "./serial/robot.mjs";

const skip = noSerial() || false;
const ROUNDS = Number(process.env.LINK_ROUNDS ?? 5);
const LIMIT_MS = 250;

/** Never meets a wall. */
const TURN = { forward: 0, left: 1 };

/** Waits for what may still come, and says how long after `since`, in seconds, the robot was told to stop. */
async function stoppedAfter(robot, since) {
  await new Promise((later) => setTimeout(later, LIMIT_MS + 50));
  const heard = robot.heard();
  assert.ok(!moves(heard[0]), "the first command moved the robot");
  assert.ok(heard.some(moves), "the robot wasn't moving");
  assert.ok(robot.isAtRest(), "the robot moves");
  return (lastStop(heard).time - since) * 1000;
}

function report(t, taken) {
  const sorted = taken.toSorted((a, b) => a - b).map(Math.round);
  t.diagnostic(`${taken.length} of ${ROUNDS} stopped: median ${sorted[sorted.length >> 1]} ms, longest ${sorted.at(-1)} ms`);
  assert.ok(sorted.at(-1) <= LIMIT_MS, `stopped after ${sorted.at(-1)} ms`);
}

// Counted from when the browser tells the page: tests reach the browser by a detour, and a page that is left for another one
// goes on until that one answers.
const noteLeaving = (tab) =>
  tab.evaluate(() => {
    localStorage.removeItem("left");
    addEventListener("pagehide", (event) => localStorage.setItem("left", String((performance.timeOrigin + event.timeStamp) / 1000)), true);
  });
const leftAt = async (tab) => {
  const left = await tab.evaluate(() => localStorage.getItem("left"));
  assert.notEqual(left, null);
  return Number(left);
};

const WAYS = {
  "the tab is closed": async ({ tab, server }) => {
    const other = await tab.context().newPage();
    await other.goto(`${server.url}elsewhere.html`);
    await noteLeaving(tab);
    await tab.close();
    const at = await leftAt(other);
    await other.close();
    return at;
  },
  // Reloading counts as such; elsewhere and back again, whether or not the browser has kept the page.
  "the page is left": async ({ tab, server }, round) => {
    await noteLeaving(tab);
    if (round % 2) await tab.reload();
    else await tab.goto(`${server.url}elsewhere.html`);
    const at = await leftAt(tab);
    if (round % 2 === 0) await tab.goBack();
    return at;
  },
  "the page hangs": ({ tab }) =>
    tab.evaluate(() => {
      const at = Date.now();
      while (Date.now() - at < 500);
      return at / 1000;
    }),
};

for (const [way, go] of Object.entries(WAYS)) {
  test(`stops when ${way}`, { skip, timeout: 60_000 + 5000 * ROUNDS }, async (t) => {
    const robot = await Robot.start(t);
    const { desk: first, open } = await openDesk(t, { robot });
    let desk = first;
    const taken = [];
    for (let round = 0; round < ROUNDS; round++) {
      robot.forget();
      if (desk.tab.isClosed()) desk = await open();
      await desk.load();
      await desk.connect();
      await desk.arm();
      await desk.drive(TURN);
      taken.push(await stoppedAfter(robot, await go(desk, round)));
    }
    report(t, taken);
  });
}

test("stops when the tab is hidden, and stays so when it is shown again", { skip, timeout: 60_000 + 5000 * ROUNDS }, async (t) => {
  const robot = await Robot.start(t);
  const { openTab } = await openHidable(t, { robot });
  const tab = await openTab("desk.html");
  const other = await openTab("elsewhere.html");
  const until = (condition) =>
    tab.evaluate(`new Promise((done, fail) => {
      const late = setTimeout(() => fail(new Error("waited in vain for " + ${JSON.stringify(condition)})), 15000);
      const look = () => { try { if (${condition}) return clearTimeout(late), done(true); } catch {} setTimeout(look, 20); };
      look();
    })`);
  await tab.show();
  await until("connection && document.visibilityState === 'visible'");
  await tab.evaluate("navigator.serial.getPorts().then(([port]) => connection.open({ kind: 'serial', port }))");
  await tab.evaluate("document.addEventListener('visibilitychange', (event) => (window.hiddenAt = (performance.timeOrigin + event.timeStamp) / 1000), true)");
  const taken = [];
  for (let round = 0; round < ROUNDS; round++) {
    await until("seen.view.phase === 'connected'");
    robot.forget();
    await tab.evaluate("connection.request({ do: 'arm', full: false })");
    await until("seen.view.can.drive");
    await tab.evaluate("window.stick = setInterval(() => connection.request({ do: 'drive', forward: 0, left: 1 }), 50), 0");
    await until("seen.view.wheels[1] > 0");
    await other.show();
    await until("document.visibilityState === 'hidden'");
    const at = await tab.evaluate("window.hiddenAt");
    taken.push(await stoppedAfter(robot, at));
    // The stick is still held.
    await tab.show();
    await until("document.visibilityState === 'visible'");
    await new Promise((later) => setTimeout(later, 200));
    lastStop(robot.heard());
    assert.ok((await tab.evaluate("seen.view.mode")) === "Passive");
    await tab.evaluate("clearInterval(stick)");
  }
  report(t, taken);
});
