// The robot stops when the page goes away: tabs closed, left, hidden or hung while it drives, or one of the connection's
// workers. LINK_ROUNDS=100 tries each of them as often, LOAD=2 with that many busy processes per core beside.
import assert from "node:assert/strict";
import { test } from "node:test";
import { noSerial, openDesk, openHidable } from "./serial/desk.mjs";
import { underLoad } from "./serial/load.mjs";
import { Robot, lastStop, stops } from "./serial/robot.mjs";
import { TURN, WAYS, report, stoppedAfter } from "./serial/ways.mjs";

const skip = noSerial() || false;
const ROUNDS = Number(process.env.LINK_ROUNDS ?? 3);
underLoad(Number(process.env.LOAD ?? 0));

for (const [way, go] of Object.entries(WAYS)) {
  test(`stops when ${way}`, { skip, timeout: 60_000 + 10_000 * ROUNDS }, async (t) => {
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
    report(t, taken, ROUNDS);
  });
}

test("who leaves while the robot drives is asked, and it stands by then", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk } = await openDesk(t, { robot });
  await desk.connect();
  const asked = [];
  desk.tab.on("dialog", async (dialog) => {
    // Its stop was sent before; its wheels may still be slowing down.
    asked.push([dialog.type(), stops(lastStop(robot.heard()))]);
    await robot.rests();
    await dialog.dismiss();
  });
  // Nothing is at stake yet.
  await desk.tab.click("body");
  await desk.load();
  assert.deepEqual(asked, []);
  await desk.connect();
  await desk.arm();
  await desk.tab.click("body");
  await desk.drive(TURN);
  await desk.tab.reload({ timeout: 2000 }).catch(() => {});
  assert.deepEqual(asked, [["beforeunload", true]]);
  // The page is still there, and may take control again.
  await desk.letGo();
  await desk.until((view) => view.mode === "Passive");
  assert.match((await desk.view()).notice.text, /about to leave/);
  await desk.arm();
  await desk.ask({ do: "disarm" });
  await desk.until((view) => view.mode === "Passive");
});

test("what a busy driver had decided before the page stopped the robot never reaches it", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk } = await openDesk(t, { robot });
  const opened = await desk.tab.evaluate(async () => {
    const { accessBy } = await import("/www/connection/access.js");
    const access = accessBy("serial");
    const holder = new Worker("/www/connection/line-worker.js", { type: "module" });
    const { port1: driver, port2 } = new MessageChannel();
    holder.postMessage({ type: "init", driver: port2 }, [port2]);
    Object.assign(window, { holder, driver, write: (...bytes) => driver.postMessage({ type: "write", bytes: Uint8Array.from(bytes), isActing: true }) });
    driver.postMessage({ type: "open", id: 1, target: { kind: "serial", address: { ids: (await access.list()).map(access.id), index: 0 } } });
    return new Promise((done) => (driver.onmessage = ({ data }) => data.id === 1 && done(data.failure ?? "opened")));
  });
  assert.equal(opened, "opened");
  // Start, Safe, Drive Direct.
  await desk.tab.evaluate(() => window.write(128, 131, 145, 0, 100, 0, 100));
  await robot.drives();
  await desk.tab.evaluate(() => window.holder.postMessage({ type: "stop" }));
  await robot.hears(128);
  await desk.tab.evaluate(() => {
    window.write(131, 145, 0, 100, 0, 100);
    // It has read of the stop: what it writes now is said to the robot, such as a song.
    window.driver.postMessage({ type: "left" });
    window.write(141, 0);
  });
  await robot.hears(141);
  assert.deepEqual(robot.heard().slice(-2).map(({ opcode }) => opcode), [128, 141]);
  await desk.tab.evaluate(() => window.holder.terminate());
});

test("stops when the tab is hidden, and stays so when it is shown again", { skip, timeout: 60_000 + 10_000 * ROUNDS }, async (t) => {
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
  report(t, taken, ROUNDS);
});
