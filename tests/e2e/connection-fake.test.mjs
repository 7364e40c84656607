// What no pseudo terminal can do, on a stand-in for Web Serial in page and worker: errors of the line, control lines, two
// adapters, a port that never closes, a chooser that is dismissed. And bridges.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { DIST } from "./browser.mjs";
import { fakeFiles, startBus } from "./serial/bus.mjs";
import { openDesk } from "./serial/desk.mjs";
import { Robot, lastStop, moves } from "./serial/robot.mjs";

const skip = process.platform === "linux" ? false : "the emulator needs a pseudo terminal as Linux has them";
const FTDI = { usbVendorId: 0x0403, usbProductId: 0x6001 };
/** The micro USB socket of a Roomba 980. */
const ROOMBA = { usbVendorId: 0x27a6, usbProductId: 0x0002 };

async function openFake(t, { ports = [FTDI], robots = 1, personality = [], chooses = 0, ...options } = {}) {
  const all = [];
  for (let number = 0; number < robots; number++) all.push(await Robot.start(t, ...personality));
  const bus = await startBus(t, all, options);
  const { desk } = await openDesk(t, { extra: fakeFiles({ bus: bus.url, ports, chooses }) });
  return { desk, bus, robots: all, robot: all[0] };
}

test("goes on after breaks, framing and parity errors and overruns", { skip }, async (t) => {
  const { desk, bus } = await openFake(t);
  await desk.connect();
  for (const error of ["BreakError", "FramingError", "ParityError", "BufferOverrunError", "FramingError"]) bus.inject(0, error);
  const { transport, statistics } = await desk.until((v) => v.transport.errors.framing === 2);
  assert.deepEqual(transport.errors, { break: 1, framing: 2, parity: 1, overrun: 1 });
  assert.equal(transport.state, "open");
  await desk.until((v, frames) => v.statistics.frames > frames + 50, statistics.frames);
  assert.equal((await desk.view()).phase, "connected");
  assert.equal(bus.events[0].buffer, 16_384);
});

test("BRC is let go of at once, so that opening never leaves it low", { skip }, async (t) => {
  const { desk, bus } = await openFake(t);
  const { transport } = await desk.connect();
  assert.equal(transport.brc, "high");
  const [, signals] = bus.events;
  assert.equal(signals.requestToSend, false);
});

test("a silent robot is woken once, by a pulse too long to change its baud rate, and looked for at others", { skip }, async (t) => {
  const { desk, bus, robot } = await openFake(t, { through: () => [] });
  assert.ok(await desk.openSerial());
  const { diagnosis } = await desk.until((v) => v.phase === "waiting");
  assert.equal(diagnosis.finding, "silence");
  assert.notEqual(diagnosis.remedy, "");
  assert.deepEqual(bus.events.flatMap(({ baud }) => baud ?? []).slice(0, 3), [115_200, 19_200, 57_600]);
  const signals = bus.events.filter(({ requestToSend }) => requestToSend !== undefined);
  const low = signals.findIndex(({ requestToSend }) => requestToSend);
  assert.equal(signals.filter(({ requestToSend }) => requestToSend).length, 1);
  const pulse = signals[low + 1].time - signals[low].time;
  // Three of 50 to 500 ms each put it at 19200 baud (OI specification, "Baud code").
  assert.ok(pulse > 700 && pulse < 1500, `${pulse} ms`);
  assert.deepEqual(robot.heard().filter(moves), []);
});

test("a robot's own USB port is recognised, and neither woken nor asked at other rates", { skip }, async (t) => {
  let isAwake = false;
  const { desk, bus, robot } = await openFake(t, { ports: [ROOMBA], through: (bytes) => (isAwake ? bytes : []) });
  assert.ok(await desk.openSerial());
  const { transport, diagnosis } = await desk.until((v) => v.phase === "waiting");
  assert.deepEqual([transport.name, transport.is_own_usb, transport.can_baud, transport.brc], ["Roomba's own USB port (27a6:0002)", true, false, "none"]);
  assert.deepEqual([diagnosis.picture, diagnosis.caption.title], ["usb", "No answer over the robot's own USB port."]);
  isAwake = true;
  const { line } = await desk.until((v) => v.phase === "connected");
  assert.match(line.note, /never tried/);
  assert.deepEqual(bus.events.flatMap(({ baud }) => baud ?? []), [115_200]);
  assert.ok(bus.events.every(({ requestToSend }) => !requestToSend));
  assert.deepEqual(robot.heard().filter(moves), []);
});

test("of two adapters of the same make, the one is opened that was chosen", { skip }, async (t) => {
  const { desk, robots } = await openFake(t, { ports: [FTDI, FTDI], robots: 2, chooses: 1 });
  await desk.tab.getByRole("button", { name: "Choose a port" }).click();
  assert.equal(await desk.tab.evaluate(() => window.chosen), true);
  await desk.until((v) => v.phase === "connected");
  assert.deepEqual(robots[0].heard(), []);
  assert.ok(robots[1].heard().length > 0);
});

test("an adapter that fails while it drives: the link is lost, and what comes after it is a stop", { skip }, async (t) => {
  const { desk, bus, robot } = await openFake(t);
  await desk.connect();
  await desk.arm();
  await desk.drive();
  bus.drop(0);
  await desk.until((v) => v.transport.state === "lost");
  // It is still there, so it is opened again; the stick is still held.
  await desk.until((v) => v.transport.returns === 1 && v.phase === "connected");
  await desk.tab.waitForTimeout(300);
  lastStop(robot.heard());
});

test("a port that never closes is given up after a second", { skip }, async (t) => {
  const { desk } = await openFake(t, { ports: [{ ...FTDI, hangs: true }] });
  await desk.connect();
  const taken = await desk.tab.evaluate(async () => {
    const began = performance.now();
    await window.connection.close();
    return performance.now() - began;
  });
  assert.ok(taken < 1500, `closing took ${taken} ms`);
  assert.deepEqual(await desk.failures(), []);
  assert.equal((await desk.view()).transport.state, "closed");
});

test("bytes that were flipped on the way are refused and counted, and move nothing", { skip }, async (t) => {
  let count = 0;
  const flip = (bytes) => Buffer.from(bytes.map((byte) => (++count % 200 === 0 ? byte ^ 0x10 : byte)));
  const { desk, robot } = await openFake(t, { through: flip });
  await desk.connect();
  const { statistics, phase } = await desk.until((v) => v.statistics.bad_checksums > 20);
  assert.equal(phase, "connected");
  assert.ok(statistics.frames > statistics.bad_checksums);
  assert.deepEqual(robot.heard().filter(moves), []);
});

test("choosing nothing is no error, and a forbidden list is explained", { skip }, async (t) => {
  for (const [chooses, kinds] of [[undefined, []], ["denied", ["policy"]]]) {
    const { desk } = await openFake(t, { chooses: chooses ?? null, robots: 0 });
    if (chooses === undefined) await desk.tab.evaluate(() => (navigator.serial.requestPort = () => Promise.reject(new DOMException("No port selected by the user.", "NotFoundError"))));
    await desk.tab.getByRole("button", { name: "Choose a port" }).click();
    assert.equal(await desk.tab.evaluate(() => window.chosen), false);
    assert.deepEqual((await desk.failures()).map(({ kind }) => kind), kinds);
  }
});

test("an error in the program stops the robot and says so", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bus = await startBus(t, [robot]);
  const sabotage = `const view = Connection.prototype.view;
    Connection.prototype.view = function (...now) {
      const seen = view.apply(this, now);
      if (seen.distance_m > 0.05) throw new Error("sabotage");
      return seen;
    };`;
  const program = fs.readFileSync(path.join(DIST, "workshop.js"), "utf8");
  const extra = { ...fakeFiles({ bus: bus.url, ports: [FTDI], chooses: 0 }), "/workshop.js": `${program}\n${sabotage}` };
  const { desk } = await openDesk(t, { extra, allow: [/sabotage/] });
  await desk.connect();
  await desk.arm();
  await desk.drive();
  await desk.tab.waitForFunction(() => window.seen.failures.length > 0);
  const [failure] = await desk.failures();
  assert.equal(failure.kind, "broken");
  assert.match(failure.what, /sabotage.*stop command was sent/);
  await desk.tab.waitForTimeout(300);
  const heard = robot.heard();
  lastStop(heard);
  assert.equal(heard.at(-1).opcode, 128);
  // With a worker of its own, the next connection works.
  await desk.letGo();
  await desk.connect();
});

test("a bridge: connects, drives, and is tried again when it is lost", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bus = await startBus(t, [robot]);
  const { desk } = await openDesk(t, { allow: [/WebSocket connection/] });
  const open = (url) => desk.tab.evaluate((address) => window.connection.open({ kind: "socket", url: address }), url);
  assert.equal(await open("http://robot/"), false);
  assert.equal(await open("ws://127.0.0.1:9/"), false);
  assert.deepEqual((await desk.failures()).map(({ kind }) => kind), ["failed", "unreachable"]);

  assert.equal(await open(`${bus.url}/0`), true);
  const { transport } = await desk.until((v) => v.phase === "connected");
  assert.equal(transport.can_baud, false);
  await desk.arm();
  await desk.drive();
  bus.drop(0);
  await desk.until((v) => v.transport.state === "lost");
  await desk.until((v) => v.transport.returns === 1 && v.phase === "connected");
  await desk.tab.waitForTimeout(300);
  lastStop(robot.heard());
});

test("where there are no serial ports, it is said why and what works instead", async (t) => {
  const { desk, context, server } = await openDesk(t, { allow: [/blocked|insecure|Mixed Content/] });
  assert.deepEqual(await desk.tab.evaluate(() => window.support()), { serial: true, usb: false, socket: true, why: "", instead: "" });
  // The same page under other addresses, and in browsers that have no permission for one's own network.
  let isOlder = false;
  await context.route(/^https?:\/\/desk\.test\//, async (route) => {
    const { pathname, search } = new URL(route.request().url());
    const response = await route.fetch({ url: new URL(pathname, server.url).href });
    const policy = search === "?forbidden" ? { "permissions-policy": "serial=()" } : {};
    const body = isOlder && pathname.endsWith("/local-network.js") ? `${await response.text()};navigator.permissions.query = () => Promise.reject(new TypeError());` : undefined;
    await route.fulfill({ response, body, headers: { ...response.headers(), ...policy } });
  });
  const failuresAt = async (address, target) => {
    await desk.tab.goto(address);
    await desk.tab.waitForFunction(() => window.connection);
    const kinds = await desk.tab.evaluate(async (what) => ((await window.connection.open(what)), window.seen.failures.map(({ kind }) => kind)), target);
    return [kinds, await desk.tab.evaluate(() => window.support())];
  };
  let [kinds, { why, instead }] = await failuresAt("http://desk.test/desk.html", { kind: "serial" });
  assert.deepEqual(kinds, ["insecure"]);
  assert.match(why, /https:/);
  assert.match(instead, /virtual robot/);
  [kinds] = await failuresAt("https://desk.test/desk.html", { kind: "socket", url: "ws://192.168.1.50/" });
  assert.deepEqual(kinds, ["denied"]);
  isOlder = true;
  [kinds] = await failuresAt("https://desk.test/desk.html", { kind: "socket", url: "ws://192.168.1.50/" });
  assert.deepEqual(kinds, ["mixed"]);
  [kinds, { why }] = await failuresAt("https://desk.test/desk.html?forbidden", { kind: "serial" });
  assert.deepEqual(kinds, ["policy"]);
  assert.match(why, /permissions policy/);
  // Safari and other browsers without.
  await context.addInitScript(() => {
    delete Navigator.prototype.serial;
    delete Navigator.prototype.usb;
  });
  [kinds, { why, instead }] = await failuresAt("https://desk.test/desk.html", { kind: "serial" });
  assert.deepEqual(kinds, ["unsupported"]);
  assert.match(why, /This browser can't use serial ports/);
  assert.match(instead, /Chrome.*Firefox 151.*bridge.*virtual robot/);
});
