// A robot on a real serial port: Chromium's Web Serial as it is, and the emulator at the other end of the line.
import assert from "node:assert/strict";
import { test } from "node:test";
import { noSerial, openDesk, udev } from "./serial/desk.mjs";
import { Robot, lastStop, moves, now, stops } from "./serial/robot.mjs";

const skip = noSerial() || false;

test("connects, streams, drives and says goodbye", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk } = await openDesk(t, { robot });
  const view = await desk.connect();
  assert.equal(view.transport.state, "open");
  assert.match(view.transport.name, /FTDI adapter \(0403:6001\)/);
  assert.ok(view.readings.voltage_v > 10);
  assert.equal(view.mode, "Passive");
  // Only a connection has been requested.
  assert.deepEqual(robot.heard().filter(moves), []);
  // A busy machine delivers some in a lump.
  const { statistics } = await desk.until((v) => v.statistics.frames > 100 && v.statistics.rate_hz > 30 && v.statistics.rate_hz < 75);
  assert.equal(statistics.bad_checksums, 0);

  await desk.arm();
  assert.deepEqual(robot.heard().filter(moves), [], "control was taken, and the robot was told to move");
  await desk.drive();
  await desk.until((v) => v.distance_m > 0.05);
  await desk.letGo();
  const at = now();
  await desk.until((v) => v.wheels[0] === 0);
  await desk.tab.waitForTimeout(300);
  const stopped = lastStop(robot.heard());
  t.diagnostic(`let go of the stick: stopped ${((stopped.time - at) * 1000).toFixed(0)} ms later`);

  await desk.tab.evaluate(() => window.connection.close());
  const { transport, phase } = await desk.view();
  assert.equal(transport.state, "closed");
  assert.equal(phase, "closed");
  // Passive, then Off: where it charges and sleeps.
  await robot.hears(173);
  assert.deepEqual(robot.heard().slice(-2).map(({ opcode }) => opcode), [128, 173]);
  assert.deepEqual(await desk.failures(), []);
});

test("unplugged while it drives, and plugged in again: nothing moves until the user says so", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk } = await openDesk(t, { robot });
  await desk.connect();
  await desk.arm();
  await desk.drive();
  await robot.unplug();
  await udev(t, "remove");
  const lost = await desk.until((v) => v.transport.state === "lost");
  assert.match(lost.transport.text, /unplugged/);
  assert.equal(lost.wheels[0], 0);

  // The robot drives on, as it can't be reached, and the stick is still held.
  assert.equal(robot.isAtRest(), false);
  robot.forget();
  await robot.plug();
  await udev(t, "add");
  const back = await desk.until((v) => v.transport.state === "open" && v.phase === "connected");
  assert.equal(back.transport.returns, 1);
  assert.equal(back.mode, "Passive");
  await desk.tab.waitForTimeout(500);
  const heard = robot.heard();
  // Zeros before it fill up a command that was cut.
  assert.ok(stops(heard.find(({ opcode }) => opcode !== 0)), "the first thing said was no stop");
  assert.deepEqual(heard.filter(moves), [], "a robot that was plugged in again was told to move");
  assert.ok(robot.isAtRest());

  await desk.letGo();
  await desk.arm();
  await desk.drive();
  assert.ok(robot.heard().some(moves));
});

test("a second tab is told that the robot is taken", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk, open } = await openDesk(t, { robot });
  await desk.connect();
  const second = await open();
  assert.equal(await second.openSerial(), false);
  const [failure] = await second.failures();
  assert.equal(failure.kind, "busy");
  assert.match(failure.what, /Another tab/);
  // The first one doesn't notice.
  assert.equal((await desk.view()).phase, "connected");
  await desk.tab.close();
  await second.connect();
});

test("a port that another program has can't be opened, and that is said", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk } = await openDesk(t, { robot });
  await robot.unplug();
  // Still listed, as the system has not noticed.
  assert.equal(await desk.openSerial(), false);
  const [failure] = await desk.failures();
  assert.equal(failure.kind, "busy");
  assert.match(failure.remedy, /serial monitor.*dialout/s);
});

test("a robot at 19200 baud is found", { skip }, async (t) => {
  const robot = await Robot.start(t, "--personality", "slow");
  const { desk } = await openDesk(t, { robot });
  const { statistics, transport } = await desk.connect();
  assert.equal(statistics.baud, 19_200);
  assert.equal(transport.baud, 19_200);
});

test("the robot hears the goodbye to its end", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const { desk } = await openDesk(t, { robot });
  for (let round = 0; round < 5; round++) {
    await desk.connect();
    robot.forget();
    await desk.tab.evaluate(() => window.connection.close());
    await robot.hears(173);
  }
});
