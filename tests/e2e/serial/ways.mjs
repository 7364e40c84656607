// Ways in which a page, or one of its workers, comes to its end while the robot drives; each says when that was.
import assert from "node:assert/strict";
import { lastStop, moves, now } from "./robot.mjs";

/** Never meets a wall. */
export const TURN = { forward: 0, left: 1 };

/** Waits for further commands, and returns how long after `since`, in seconds, the robot was commanded to stop. */
export async function stoppedAfter(robot, since) {
  await new Promise((later) => setTimeout(later, 400));
  // The robot itself is late on a busy machine; when it was told counts.
  await robot.rests();
  const heard = robot.heard();
  assert.ok(!moves(heard[0]), "the first command moved the robot");
  assert.ok(heard.some(moves), "the robot wasn't moving");
  assert.ok(robot.isAtRest(), "the robot moves");
  return (lastStop(heard).time - since) * 1000;
}

/** The longest that a robot may drive on, in ms. */
export const LIMIT_MS = 250;

/** Says how long, in ms, the robot took to be stopped in each of `rounds`, and demands that it never was too long. */
export function report(t, taken, rounds) {
  const sorted = taken.toSorted((a, b) => a - b).map(Math.round);
  const inTime = sorted.filter((ms) => ms <= LIMIT_MS).length;
  t.diagnostic(`${inTime} of ${rounds} stopped within ${LIMIT_MS} ms: median ${sorted[sorted.length >> 1]} ms, longest ${sorted.at(-1)} ms`);
  assert.ok(sorted.at(-1) <= LIMIT_MS, `stopped after ${sorted.at(-1)} ms`);
}

// Counted from when the browser first tells the page: tests reach the browser by a detour, and a page that is left for another
// one goes on until that one answers.
const noteLeaving = (tab) =>
  tab.evaluate(() => {
    localStorage.removeItem("left");
    const note = ({ timeStamp }) => localStorage.getItem("left") ?? localStorage.setItem("left", String((performance.timeOrigin + timeStamp) / 1000));
    for (const sign of ["beforeunload", "pagehide"]) addEventListener(sign, note, true);
  });
const leftAt = async (tab) => {
  const left = await tab.evaluate(() => localStorage.getItem("left"));
  assert.notEqual(left, null);
  return Number(left);
};

/** Does something with a page, and says when it was left; another page of the same origin reads that. */
const seenFromOutside = async ({ tab, server }, what) => {
  const other = await tab.context().newPage();
  await other.goto(`${server.url}elsewhere.html`);
  await tab.bringToFront();
  await noteLeaving(tab);
  await what(tab);
  const at = await leftAt(other);
  await other.close();
  return at;
};

/** Does something in one of the page's workers, by its file's name, without waiting for it; says when. */
const inWorker = ({ tab }, name, what) => {
  const worker = tab.workers().find((one) => new URL(one.url()).pathname.endsWith(`/${name}`));
  assert.ok(worker, `there is no ${name} among ${tab.workers().map((one) => one.url())}`);
  const at = now();
  worker.evaluate(what).catch(() => {});
  return at;
};
const hang = () => {
  const end = performance.now() + 3000;
  while (performance.now() < end);
};

/** One of the page's workers hangs for three seconds; says when that began. */
export const hangInWorker = (desk, name) => inWorker(desk, name, hang);

export const WAYS = {
  "the tab is closed": (desk) => seenFromOutside(desk, (tab) => tab.close()),
  "the user goes back": (desk) => seenFromOutside(desk, (tab) => tab.goBack()),
  // And back again, whether or not the browser has kept the page.
  "the page is left": async ({ tab, server }) => {
    await noteLeaving(tab);
    await tab.goto(`${server.url}elsewhere.html`);
    const at = await leftAt(tab);
    await tab.goBack();
    return at;
  },
  "the page is reloaded": async ({ tab }) => {
    await noteLeaving(tab);
    await tab.reload();
    return leftAt(tab);
  },
  // Longer than any page gets that is only slow.
  "the page hangs": ({ tab }) =>
    tab.evaluate(() => {
      const at = Date.now();
      while (Date.now() - at < 1500);
      return at / 1000;
    }),
  "the driver's worker ends": (desk) => inWorker(desk, "worker.js", () => self.close()),
  "the driver's worker hangs": (desk) => hangInWorker(desk, "worker.js"),
  "the line's worker ends": (desk) => inWorker(desk, "line-worker.js", () => self.close()),
};
