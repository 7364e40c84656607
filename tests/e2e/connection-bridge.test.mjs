// `robovac bridge` between page and robot: it stops the robot when page, browser, network or the bridge itself goes away.
// LINK_ROUNDS=100 tries what kills as often, LOAD=2 with that many busy processes per core beside.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import net from "node:net";
import { test } from "node:test";
import { chromium } from "playwright-core";
import { CHROMIUM_FLAGS, chromiumPath } from "./browser.mjs";
import { Bridge } from "./serial/bridge.mjs";
import { FloorPlanTab, openDesk } from "./serial/desk.mjs";
import { underLoad } from "./serial/load.mjs";
import { Robot, lastStop, moves, now } from "./serial/robot.mjs";
import { LIMIT_MS, hangInWorker, report } from "./serial/ways.mjs";

const skip = process.platform === "win32" ? "pseudo-terminals are needed" : false;
const ROUNDS = Number(process.env.LINK_ROUNDS ?? 2);
underLoad(Number(process.env.LOAD ?? 0));

/** Never meets a wall. */
const TURN = { forward: 0, left: 1 };

async function connect(desk, bridge) {
  assert.ok(await desk.tab.evaluate((url) => window.connection.open({ kind: "socket", url }), bridge.address), JSON.stringify(await desk.failures()));
  return desk.until((view) => view.phase === "connected");
}

async function ride(desk, bridge, robot) {
  robot.forget();
  await connect(desk, bridge);
  await desk.arm();
  // A busy machine's first commands can come too late for the bridge, which then wants control taken again.
  while (!(await drives(desk))) await desk.arm();
  await robot.drives();
}

/** Holds the stick; returns whether the robot drives, rather than having been halted for a late command. */
async function drives(desk) {
  await desk.hold(TURN);
  const { mode } = await desk.until((view) => view.wheels[1] > 0 || view.mode === "Passive");
  if (mode === "Passive") await desk.letGo();
  return mode !== "Passive";
}

/** Waits until the robot rests; returns how long after `since`, in s, it was commanded to stop, in ms. */
async function stoppedAfter(robot, since) {
  await robot.rests();
  const heard = robot.heard();
  assert.ok(!moves(heard[0]) && heard.some(moves), "it moved, but not first");
  return (lastStop(heard).time - since) * 1000;
}

/** A browser of its own, which a test can kill or freeze with all its processes. */
async function ownBrowser(t, server) {
  const host = await chromium.launchServer({ executablePath: process.env.PAGE_BROWSER || chromiumPath(), args: CHROMIUM_FLAGS });
  const group = host.process().pid;
  const signal = (what) => {
    const at = now();
    process.kill(-group, what);
    return at;
  };
  // Its other processes are named by a type; some systems start it by a script.
  const killFirst = () => {
    const all = execFileSync("pgrep", ["-g", group, "-a"], { encoding: "utf8" }).trim().split("\n");
    const first = all.filter((line) => /chrom/.test(line) && !/--type=| \/bin\/sh |crashpad/.test(line)).map((line) => Number.parseInt(line, 10));
    const at = now();
    for (const pid of first) process.kill(pid, "SIGKILL");
    return at;
  };
  const ended = new Promise((resolve) => host.process().once("exit", resolve));
  t.after(() => host.kill().catch(() => {}));
  const browser = await chromium.connect(host.wsEndpoint());
  const desk = new FloorPlanTab(await browser.newPage(), server);
  await desk.load();
  return { desk, signal, killFirst, ended };
}

/** The first pages are loaded beside: only the server is of interest. */
const serve = async (t) => (await openDesk(t, { allow: [/WebSocket/] })).server;

const DEATHS = {
  "the browser's first process is killed": ({ killFirst }) => killFirst(),
  "all processes of the browser are killed": ({ signal }) => signal("SIGKILL"),
  // As a computer that freezes, or a network that is cut: the connection stays open, and nothing comes.
  "the browser freezes": ({ signal }) => signal("SIGSTOP"),
};

for (const [death, kill] of Object.entries(DEATHS)) {
  test(`stops when ${death}`, { skip, timeout: 60_000 + 15_000 * ROUNDS }, async (t) => {
    const robot = await Robot.start(t);
    const bridge = await Bridge.start(t, robot);
    const server = await serve(t);
    const taken = [];
    for (let round = 0; round < ROUNDS; round++) {
      const browser = await ownBrowser(t, server);
      await ride(browser.desk, bridge, robot);
      taken.push(await stoppedAfter(robot, kill(browser)));
      if (death.includes("freezes")) browser.signal("SIGKILL");
      await browser.ended;
    }
    report(t, taken, ROUNDS);
  });
}

test("a browser that thaws drives no more, and can be given control again", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bridge = await Bridge.start(t, robot);
  const { desk, signal } = await ownBrowser(t, await serve(t));
  await ride(desk, bridge, robot);
  signal("SIGSTOP");
  // The wheels, and a second later all of it.
  await robot.hears(128);
  robot.forget();
  signal("SIGCONT");
  await desk.letGo();
  await desk.until((view) => view.transport.returns === 1 && view.phase === "connected");
  assert.ok(!robot.heard().some(moves), "it moved");
  await desk.arm();
  await desk.drive(TURN);
});

test("the bridge that is ended stops the robot; one that was killed does so as soon as it is started again", { skip }, async (t) => {
  for (const signal of ["SIGTERM", "SIGINT", "SIGKILL"]) {
    const robot = await Robot.start(t);
    const bridge = await Bridge.start(t, robot);
    const { desk } = await openDesk(t, { allow: [/WebSocket/] });
    await ride(desk, bridge, robot);
    const at = now();
    await bridge.end(signal);
    await desk.until((view) => view.transport.state === "lost");
    if (signal === "SIGKILL") {
      // Else its own stop would be the next.
      await desk.tab.evaluate(() => window.connection.close());
      robot.forget();
      assert.ok(!robot.isAtRest(), "nobody could stop it");
      const again = await Bridge.start(t, robot);
      await robot.rests();
      assert.ok(!robot.heard().some(moves));
      await again.end("SIGTERM");
    } else {
      assert.match((await desk.view()).transport.text, /bridge was ended/);
      assert.ok((await stoppedAfter(robot, at)) < LIMIT_MS);
    }
    await desk.tab.evaluate(() => window.connection.close());
  }
});

test("one page drives, the other watches, stops the robot, and drives when it is its turn", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bridge = await Bridge.start(t, robot);
  const { desk: driver, server } = await openDesk(t, { allow: [/WebSocket/] });
  // Another browser: tabs of one know of each other.
  const { desk: watcher } = await ownBrowser(t, server);
  await ride(driver, bridge, robot);
  await watcher.tab.evaluate((url) => window.connection.open({ kind: "socket", url }), bridge.address);
  const seen = await watcher.until((view) => view.phase === "connected" && view.transport.is_watching && view.moves_alone && view.mode === "Safe");
  assert.match(seen.transport.text, /watching, and can stop it/);
  assert.deepEqual([seen.doing.title, seen.clock, Object.values(seen.can).filter(Boolean)], ["Another client drives", "", [true]]);
  for (const request of [{ do: "arm", full: false }, { do: "raw", bytes: [137, 0, 0, 0, 0] }]) {
    assert.equal(await watcher.ask(request), false);
    assert.match((await watcher.failures()).at(-1).what, /Another client of the bridge drives/);
  }
  // A watcher that is left, or asked to leave, changes nothing; its Stop does.
  await watcher.tab.evaluate(() => window.connection.leave("You left the Robot tab."));
  assert.ok(!robot.isAtRest() && !robot.heard().some(({ opcode }) => opcode === 137));
  assert.ok(await watcher.ask({ do: "stop" }));
  await driver.until((view) => /Another client of the bridge stopped the robot/.test(view.notice?.text));
  await robot.rests();
  await watcher.until((view) => view.doing.title === "Watching" && /stop was sent to the bridge/.test(view.notice?.text));
  // The stick is still held, which moves nothing until the driver takes control again.
  lastStop(robot.heard());
  robot.forget();
  await driver.arm();
  await robot.drives();
  await driver.letGo();
  await robot.rests();
  robot.forget();
  await driver.tab.evaluate(() => window.connection.close());
  await watcher.until((view) => !view.transport.is_watching && view.phase === "connected" && view.can.arm);
  assert.ok(!robot.heard().some(moves), "it moved");
  await watcher.arm();
  await watcher.drive(TURN);
  await robot.drives();
});

test("the robot's cable is pulled out and put back: the bridge stops it, and nothing moves until the user says so", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bridge = await Bridge.start(t, robot);
  const { desk } = await openDesk(t, { allow: [/WebSocket/] });
  await ride(desk, bridge, robot);
  await robot.unplug();
  await desk.until((view) => view.transport.state === "lost" && /serial port is gone/.test(view.transport.text));
  // Nobody but the bridge can stop it now.
  await desk.tab.evaluate(() => window.connection.close());
  assert.ok(!robot.isAtRest(), "nobody could stop it");
  robot.forget();
  await robot.plug();
  await robot.rests();
  assert.ok(!moves(robot.heard()[0]), "the first is a stop");
  // Once more, with a page that comes back by itself; its stick is held all the time.
  await connect(desk, bridge);
  await desk.arm();
  await robot.drives();
  await robot.unplug();
  await desk.until((view) => view.transport.state === "lost");
  robot.forget();
  await robot.plug();
  await desk.until((view) => view.transport.returns > 0 && view.phase === "connected");
  await robot.rests();
  assert.ok(!robot.heard().some(moves), "it moved");
  await desk.arm();
  await robot.drives();
  await desk.letGo();
});

/** A network between page and bridge that delays everything by the same time. Returns its address for the page. */
async function slowNetwork(t, bridge, delayMs) {
  const { hostname, port } = new URL(bridge.address);
  const delayed = (from, to) => {
    from.on("data", (data) => setTimeout(() => to.destroyed || to.write(data), delayMs));
    from.on("close", () => setTimeout(() => to.destroy(), delayMs));
    from.on("error", () => {});
  };
  const server = net.createServer((near) => {
    const far = net.connect(Number(port), hostname);
    delayed(near, far);
    delayed(far, near);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.3", resolve));
  t.after(() => server.close());
  return { address: `ws://127.0.0.3:${server.address().port}/` };
}

// slow: connecting takes some delays.
test("a network that delivers everything late shows the sensors and never moves the robot", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const network = await slowNetwork(t, await Bridge.start(t, robot), 150);
  const { desk } = await openDesk(t, { allow: [/WebSocket/] });
  await connect(desk, network);
  robot.forget();
  await desk.arm();
  await desk.tab.evaluate((how) => (window.stick = setInterval(() => window.connection.request({ do: "drive", ...how }), 50)), TURN);
  await desk.until((view) => /network is too slow to drive over/.test(view.notice?.text) && view.mode === "Passive" && view.readings);
  assert.ok(!robot.heard().some(moves), "it moved");
  await desk.letGo();
});

// slow: the worker hangs for a while.
test("the line's worker hangs: the other one has the bridge stop the robot, over a connection that doesn't drive", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bridge = await Bridge.start(t, robot);
  const { desk } = await openDesk(t, { allow: [/WebSocket/] });
  await ride(desk, bridge, robot);
  const at = hangInWorker(desk, "line-worker.js");
  await desk.tab.waitForFunction(() => window.seen.failures.some(({ what }) => /A stop command was sent over a new connection/.test(what)));
  assert.ok((await stoppedAfter(robot, at)) < LIMIT_MS);
  // By the word, which goes through Safe; the bytes of a client that doesn't drive never arrive.
  await robot.hearsAfterMoving(131);
});

test("a slow robot is found through the bridge, which changes its baud rate", { skip }, async (t) => {
  const robot = await Robot.start(t, "--personality", "slow");
  const bridge = await Bridge.start(t, robot);
  const { desk } = await openDesk(t, { allow: [/WebSocket/] });
  const view = await connect(desk, bridge);
  assert.deepEqual([view.transport.baud, view.transport.can_baud], [19200, true]);
});

test("a stranger is refused, and told why: by its page's origin, or for want of the token", { skip }, async (t) => {
  const robot = await Robot.start(t);
  const bridge = await Bridge.start(t, robot, "--listen", "0.0.0.0:0");
  const { desk, server } = await openDesk(t, { allow: [/WebSocket/] });
  const open = (url) => desk.tab.evaluate((address) => window.connection.open({ kind: "socket", url: address }), url);
  const [, port, token] = /:(\d+)\/\?token=([0-9a-f]{16})$/.exec(bridge.address);
  assert.equal(await open(`ws://127.0.0.3:${port}/`), false);
  assert.equal(await open(`ws://127.0.0.3:${port}/?token=${token}0`), false);
  assert.deepEqual((await desk.failures()).map(({ what }) => /needs a token|token is wrong/.exec(what)?.[0]), ["needs a token", "token is wrong"]);
  assert.equal(await open(`ws://127.0.0.3:${port}/?token=${token}`), true);
  await desk.until((view) => view.phase === "connected");
  assert.ok(!(await desk.view()).transport.name.includes(token));
  await desk.tab.evaluate(() => window.connection.close());
  // The same page at another origin. Every name below localhost is this computer.
  await desk.tab.goto(`${server.url.replace("127.0.0.1", "other.localhost")}desk.html`);
  await desk.tab.waitForFunction(() => window.connection);
  assert.equal(await open(`ws://127.0.0.3:${port}/?token=${token}`), false);
  assert.match((await desk.failures())[0].what, /origin/);
});
