// Adapters that the page drives itself, over a stand-in for WebUSB and with emulated chips: none of this was a real one.
import assert from "node:assert/strict";
import { test } from "node:test";
import { fakeFiles } from "./serial/bus.mjs";
import { openDesk } from "./serial/desk.mjs";
import { Robot, moves, stops } from "./serial/robot.mjs";
import { startUsb } from "./serial/usb-bus.mjs";
import { CHIPS, Ch340, Cp210x, Ftdi, Pl2303, make } from "./serial/usb-chips.mjs";
import { TURN, WAYS, stoppedAfter } from "./serial/ways.mjs";

const skip = process.platform === "linux" ? false : "the emulator needs a pseudo terminal as Linux has them";
/** Twice as long as over Web Serial (docs/safety.md): the stand-in takes its time, too. */
const LIMIT_MS = 500;

async function openUsb(t, chip, ...personality) {
  const robot = await Robot.start(t, ...personality);
  const bus = await startUsb(t, [chip, robot]);
  const { desk, open } = await openDesk(t, { extra: fakeFiles({ bus: bus.url }, "usb-fake.js") });
  return { desk, open, bus, robot, adapter: bus.adapters[0] };
}

/** Fails to open it, and returns why. */
async function refusal(desk) {
  assert.equal(await desk.openSerial(), false);
  return (await desk.failures()).at(-1);
}

for (const [kind, Chip] of Object.entries(CHIPS)) {
  test(`${kind}: another program has it; wakes, drives, is unplugged, comes back, and stops when the tab is closed`, { skip }, async (t) => {
    const { desk, bus, robot, adapter } = await openUsb(t, new Chip(), "--personality", "asleep");
    adapter.isTaken = true;
    const taken = await refusal(desk);
    assert.equal(taken.kind, "busy");
    assert.match(taken.what, /another app, another tab or the system's own driver/);
    assert.match(taken.remedy, /Chrome.*140/);
    adapter.isTaken = false;

    // As users do it.
    await desk.tab.getByRole("button", { name: "Choose a port" }).click();
    const { transport, statistics } = await desk.until((v) => v.phase === "connected" && v.statistics.frames > 20);
    assert.match(transport.name, kind === "PL2303" ? /^Prolific adapter/ : new RegExp(`^${kind} adapter`));
    assert.deepEqual([transport.baud, transport.brc, statistics.bad_checksums], [115_200, "high", 0]);
    assert.ok(Math.abs(adapter.chip.baud / 115_200 - 1) < 0.005, `${adapter.chip.baud} baud`);
    assert.deepEqual(robot.heard().filter(moves), []);
    // BRC is wired to RTS. Three pulses of 50 to 500 ms each put a robot at 19200 baud (OI specification, "Baud code").
    const [first, low, high, ...more] = adapter.rts;
    assert.deepEqual([first.isOn, low.isOn, high.isOn, more], [false, true, false, []]);
    assert.ok(high.time - low.time > 700 && high.time - low.time < 1500, `${high.time - low.time} ms`);
    for (const error of "report" in adapter.chip ? ["break", "framing", "parity", "overrun"] : []) {
      adapter.report(error);
      await desk.until((v, what) => v.transport.errors[what] === 1, error);
    }

    await desk.arm();
    await desk.drive();
    bus.unplug(adapter);
    const lost = await desk.until((v) => v.transport.state === "lost");
    assert.match(lost.transport.text, /unplugged/);
    assert.equal(robot.isAtRest(), false);
    robot.forget();
    const returned = bus.plug(new Chip(), robot);
    const back = await desk.until((v) => v.transport.returns === 1 && v.phase === "connected");
    assert.equal(back.mode, "Passive");
    // The robot's log is a little behind: a command from before the cable was pulled may have come into it since.
    const opened = (performance.timeOrigin + returned.rts[0].time) / 1000;
    const heard = robot.heard().filter(({ time }) => time >= opened);
    // Zeros before it fill up a command that was cut.
    assert.ok(stops(heard.find(({ opcode }) => opcode !== 0)), `the first thing said was no stop: ${JSON.stringify(heard.slice(0, 5))}`);
    assert.deepEqual(heard.filter(moves), []);

    await desk.letGo();
    robot.forget();
    await desk.arm();
    await desk.drive(TURN);
    const after = await stoppedAfter(robot, await WAYS["the tab is closed"](desk));
    assert.ok(after < LIMIT_MS, `stopped after ${after} ms`);
  });
}

test("a robot at 19200 baud is found, and hears the goodbye to its end", { skip }, async (t) => {
  // A CP210x forgets what it hasn't sent when it is closed.
  const { desk, robot, adapter } = await openUsb(t, new Cp210x(), "--personality", "slow");
  const { statistics } = await desk.connect();
  assert.equal(statistics.baud, 19_200);
  assert.equal(adapter.chip.baud, 19_200);
  await desk.tab.evaluate(() => window.connection.close());
  await robot.hears(173);
  assert.deepEqual(robot.heard().slice(-2).map(({ opcode }) => opcode), [128, 173]);
  assert.equal(adapter.owner, null);
});

test("chips of versions that there is no driver for are refused with their names", { skip }, async (t) => {
  const refusing = { request: () => ({ status: "stall" }) };
  const versions = [
    [make(Ftdi, { bcdDevice: 0x200 }), /FT8U232AM/],
    [make(Cp210x, {}, refusing), /CP210x.*request 0x0, value 0x1/],
    [make(Ch340, {}, refusing), /CH340.*request 0x5f/],
    [make(Pl2303, { bcdUSB: 0x200, bcdDevice: 0x1200 }), /Prolific.*1200/],
  ];
  const { desk, bus } = await openUsb(t, new Ftdi());
  bus.unplug(bus.adapters[0]);
  for (const [chip, named] of versions) {
    const adapter = bus.plug(chip);
    const { kind, what } = await refusal(desk);
    assert.equal(kind, "unsupported");
    assert.match(what, named);
    assert.equal(adapter.owner, null, "it is still claimed");
    bus.unplug(adapter);
  }
});

test("a second tab is told that the robot is taken", { skip }, async (t) => {
  const { desk, open } = await openUsb(t, new Ftdi());
  await desk.connect();
  const second = await open();
  const { kind, what } = await refusal(second);
  assert.equal(kind, "busy");
  assert.match(what, /Another tab/);
  assert.equal((await desk.view()).phase, "connected");
});

const chips = Object.values(CHIPS);
const ways = {
  ...WAYS,
  "the page is hidden": ({ tab }) =>
    tab.evaluate(() => {
      Object.defineProperty(document, "visibilityState", { value: "hidden" });
      document.dispatchEvent(new Event("visibilitychange"));
      return (performance.timeOrigin + performance.now()) / 1000;
    }),
};
delete ways["the tab is closed"];
for (const [number, [way, go]] of Object.entries(ways).entries()) {
  test(`stops when ${way}`, { skip }, async (t) => {
    const { desk, robot } = await openUsb(t, new chips[number % chips.length]());
    await desk.connect();
    await desk.arm();
    await desk.drive(TURN);
    const after = await stoppedAfter(robot, await go(desk));
    assert.ok(after < LIMIT_MS, `stopped after ${after} ms`);
  });
}
