// The robot stops when its browser's window is closed, the browser is quit, its computer sleeps or is slow: in a browser with
// windows, by what its user does to them. LINK_ROUNDS=100 tries each as often, LOAD=2 with that many busy processes per core
// beside.
import assert from "node:assert/strict";
import { test } from "node:test";
import { noSerial, openWindow } from "./serial/desk.mjs";
import { underLoad } from "./serial/load.mjs";
import { Robot } from "./serial/robot.mjs";
import { TURN, report, stoppedAfter } from "./serial/ways.mjs";

const skip = noSerial() || false;
const ROUNDS = Number(process.env.LINK_ROUNDS ?? 2);
underLoad(Number(process.env.LOAD ?? 0));

/** What ends a browser with windows. Who has clicked on the page is asked, and says yes. */
const ENDS = {
  "its window is closed by the X": (desk) => desk.user("close"),
  "the browser is quit by its menu": (desk) => desk.user("keys", "Alt_L+f", "x"),
  "the tab is closed by its keys": (desk) => desk.user("keys", "Control_L+w"),
};

for (const [way, go] of Object.entries(ENDS)) {
  test(`stops when ${way}`, { skip, timeout: 60_000 + 15_000 * ROUNDS }, async (t) => {
    const robot = await Robot.start(t);
    const taken = [];
    for (let round = 0; round < ROUNDS; round++) {
      const desk = await openWindow(t, { robot });
      desk.tab.on("dialog", (dialog) => dialog.accept().catch(() => {}));
      // Browsers ask for those alone who did something on the page.
      if (round % 2 === 1) await desk.tab.click("body");
      robot.forget();
      await desk.connect();
      await desk.arm();
      await desk.drive(TURN);
      taken.push(await stoppedAfter(robot, await desk.left(() => go(desk))));
      await desk.end();
    }
    report(t, taken, ROUNDS);
  });
}

// slow: it sleeps for three seconds each time.
test("stops as soon as a computer that slept wakes up, and drives on only when told to", { skip, timeout: 60_000 + 20_000 * ROUNDS }, async (t) => {
  const robot = await Robot.start(t);
  const desk = await openWindow(t, { robot });
  const taken = [];
  for (let round = 0; round < ROUNDS; round++) {
    await desk.load();
    robot.forget();
    await desk.connect();
    await desk.arm();
    await desk.drive(TURN);
    desk.signal("SIGSTOP");
    await new Promise((later) => setTimeout(later, 3000));
    const woken = desk.signal("SIGCONT");
    taken.push(await stoppedAfter(robot, woken));
    assert.equal((await desk.view()).mode, "Passive");
    await desk.letGo();
  }
  report(t, taken, ROUNDS);
});

test("a page on a processor twenty times as slow stops the robot when it is closed", { skip, timeout: 60_000 + 20_000 * ROUNDS }, async (t) => {
  const robot = await Robot.start(t);
  const taken = [];
  for (let round = 0; round < ROUNDS; round++) {
    const desk = await openWindow(t, { robot });
    robot.forget();
    await desk.connect();
    const devtools = await desk.tab.context().newCDPSession(desk.tab);
    await desk.arm();
    await desk.drive(TURN);
    await devtools.send("Emulation.setCPUThrottlingRate", { rate: 20 });
    taken.push(await stoppedAfter(robot, await desk.left(() => desk.user("close"))));
    await desk.end();
  }
  report(t, taken, ROUNDS);
});
