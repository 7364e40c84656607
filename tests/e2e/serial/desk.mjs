// A page with nothing but a connection on it, in a Chromium that has a serial port: what tests of the robot's line share.
import assert from "node:assert/strict";
import { execFile, execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { promisify } from "node:util";
import { chromium } from "playwright-core";
import { CHROMIUM_FLAGS, DIST, ROOT, chromiumPath, serveFolder } from "../browser.mjs";
import { ends } from "../ends.mjs";
import { startScreen } from "../engines/screen.mjs";
import { launch } from "./devtools.mjs";
import { now } from "./robot.mjs";

const HERE = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);
const page = (name) => fs.readFileSync(path.join(HERE, name), "utf8");

/** Why there can be no real serial port here; "" if there can. */
export function noSerial() {
  if (process.platform !== "linux") return "a serial port of our own needs Linux";
  if (!fs.existsSync("/sys/class/tty/ttyS0/dev")) return "this machine has no /dev/ttyS0 that could be replaced";
  const rootless = process.getuid() === 0 ? [] : ["--map-root-user"];
  const tried = spawnSync("unshare", ["--mount", "--propagation", "private", ...rootless, "sh", "-c", "mount -t tmpfs tmpfs /run"], { encoding: "utf8" });
  return tried.status === 0 ? "" : `mount namespaces aren't permitted here (${(tried.stderr ?? String(tried.error)).trim()})`;
}

// One server and one browser for a test file, as starting them takes longer than most tests; tests stay apart by contexts.
const running = [];
let served;
ends.push(async () => {
  for (const end of running.reverse()) await end();
});

/** The built page with what tests put beside it; `also` may change. */
async function serve() {
  const also = {};
  const server = await serveFolder(DIST, { also });
  running.push(server.close);
  return { server, also };
}

/** Chromium with a serial port: where its cable leads to, and what starts it. */
async function wired() {
  const { server } = await (served ??= serve());
  const cable = path.join(os.tmpdir(), `robovac-e2e-${process.pid}-cable`);
  running.push(() => fs.rmSync(cable, { force: true }));
  return { cable, executable: path.join(HERE, "browser"), env: { ...process.env, SERIAL_PTY: cable, SERIAL_ORIGIN: new URL(server.url).origin, SERIAL_BROWSER: chromiumPath() } };
}

let wire;
let display;
let withPort;
let withoutPort;
async function start({ cable, executable, env } = { executable: chromiumPath() }) {
  const browser = await chromium.launch({ executablePath: executable, args: CHROMIUM_FLAGS, env });
  running.push(() => browser.close());
  return { browser, cable };
}

function plugIn(cable, robot) {
  fs.rmSync(cable, { force: true });
  fs.symlinkSync(robot.pty, cable);
}

/**
 * Opens the desk for the test `t` in a Chromium whose only serial port leads to `robot`, or in one without if there is none.
 * `extra` has files for this test, as `also` of `serveFolder`. The test fails if by its end the page has logged an error or
 * thrown one, unless a pattern in `allow` matches it.
 */
export async function openDesk(t, { robot, allow = [], extra = {} } = {}) {
  const { server, also } = await (served ??= serve());
  for (const address of Object.keys(also)) delete also[address];
  Object.assign(also, { "/desk.html": page("page.html"), "/elsewhere.html": "<!doctype html><title>Elsewhere</title>" }, extra);
  const { browser, cable } = await (robot ? (withPort ??= wired().then(start)) : (withoutPort ??= start()));
  if (robot) plugIn(cable, robot);
  // Nothing is fetched beside what is measured.
  const context = await browser.newContext({ serviceWorkers: "block" });
  const problems = [];
  const note = (message) => allow.some((pattern) => pattern.test(message)) || problems.push(message);
  context.on("console", (message) => message.type() === "error" && note(`console: ${message.text()}`));
  context.on("weberror", (error) => note(`uncaught: ${error.error().stack || String(error.error())}`));
  t.after(async () => {
    // A request that a test answers may still be on its way.
    await context.unrouteAll({ behavior: "ignoreErrors" });
    await context.close();
    assert.deepEqual(problems, [], "the page reported problems");
  });
  const open = async () => {
    const desk = new FloorPlanTab(await context.newPage(), server);
    await desk.load();
    return desk;
  };
  return { desk: await open(), open, context, server };
}

/** The same in a browser whose tabs can be hidden. */
export async function openHidable(t, { robot }) {
  const { server, also } = await (served ??= serve());
  Object.assign(also, { "/desk.html": page("page.html"), "/elsewhere.html": "<!doctype html><title>Elsewhere</title>" });
  const { cable, executable, env } = await wired();
  plugIn(cable, robot);
  const browser = await launch(executable, { flags: CHROMIUM_FLAGS, env });
  t.after(() => browser.close());
  return { openTab: (address) => browser.openTab(server.url + address) };
}

/** Opens the desk in the only window of a browser of its own, on a screen that nobody sees: for what users do to windows. */
export async function openWindow(t, { robot }) {
  const { server, also } = await (served ??= serve());
  Object.assign(also, { "/desk.html": page("page.html") });
  const [{ cable, executable, env }, screen] = await Promise.all([(wire ??= wired()), (display ??= startScreen())]);
  if (!running.includes(screen.end)) running.push(screen.end);
  plugIn(cable, robot);
  const host = await chromium.launchServer({ executablePath: executable, args: CHROMIUM_FLAGS, headless: false, env: { ...env, DISPLAY: screen.display } });
  const group = host.process().pid;
  t.after(() => host.kill().catch(() => {}));
  const browser = await chromium.connect(host.wsEndpoint());
  const desk = new FloorPlanTab(await (await browser.newContext({ serviceWorkers: "block" })).newPage(), server);
  await desk.load();
  return Object.assign(desk, {
    /** Does to the window what its user does, as window.py says. */
    user: (...what) => execFileSync(path.join(ROOT, "target/drivers/bin/python"), [path.join(HERE, "window.py"), ...what], { env: { ...process.env, DISPLAY: screen.display } }),
    /** Does what ends the page, and returns when the browser first told the page, which tells the server: nobody else is left. */
    left: async (what) => {
      await desk.tab.evaluate(() => {
        const note = ({ timeStamp }) => navigator.sendBeacon(`left?at=${(performance.timeOrigin + timeStamp) / 1000}`);
        for (const sign of ["beforeunload", "pagehide"]) addEventListener(sign, note, { capture: true, once: true });
      });
      server.requests.length = 0;
      what();
      for (;;) {
        const told = server.requests.find((address) => address.includes("left?at="));
        if (told) return Number(told.split("=")[1]);
        await new Promise((later) => setTimeout(later, 10));
      }
    },
    /** Sends a signal to all processes of the browser; returns when. */
    signal: (what) => {
      const at = now();
      process.kill(-group, what);
      return at;
    },
    end: () => host.kill(),
  });
}

/**
 * Notifies Chromium, as udev would, that the adapter was plugged in ("add") or out ("remove"). That takes root and
 * Python; without, the page has to find out by itself, as on systems without udev.
 */
export async function udev(t, action) {
  try {
    await promisify(execFile)(path.join(HERE, "udev-event.py"), [action, "ttyS0"]);
  } catch (error) {
    t.diagnostic(`nobody tells Chromium of the cable: ${error.message.split("\n").slice(0, 2).join(" ")}`);
  }
}

/** Actions and observations of a person at the desk. */
export class FloorPlanTab {
  constructor(tab, server) {
    this.tab = tab;
    this.server = server;
    tab.setDefaultTimeout(30_000);
  }

  async load() {
    await this.tab.goto(`${this.server.url}desk.html`);
    await this.tab.waitForFunction(() => window.connection);
  }

  /** Opens the port, or USB device, that the page was granted. */
  async openSerial() {
    return this.tab.evaluate(async () => {
      const byUsb = window.support().usb;
      const [port] = await (byUsb ? navigator.usb.getDevices() : navigator.serial.getPorts());
      return window.connection.open({ kind: byUsb ? "usb" : "serial", port });
    });
  }

  view() {
    return this.tab.evaluate(() => window.seen.view);
  }

  failures() {
    return this.tab.evaluate(() => window.seen.failures);
  }

  ask(request) {
    return this.tab.evaluate((what) => window.connection.request(what), request);
  }

  /** Waits until the view fits; returns it. */
  async until(fits, ...given) {
    const source = `(view) => (${fits})(view, ...${JSON.stringify(given)})`;
    try {
      const found = await this.tab.waitForFunction((text) => window.seen.view && eval(text)(window.seen.view) && window.seen.view, source, { polling: 20 });
      return await found.jsonValue();
    } catch (error) {
      throw new Error(`waited in vain for ${fits}: ${JSON.stringify({ ...(await this.view()), readings: null })}`, { cause: error });
    }
  }

  async connect() {
    assert.ok(await this.openSerial(), JSON.stringify(await this.failures()));
    return this.until((view) => view.phase === "connected");
  }

  async arm() {
    assert.ok(await this.ask({ do: "arm", full: false }));
    return this.until((view) => view.mode === "Safe" && view.can.drive);
  }

  /** Holds the stick from now on, forward or to the left, until the robot drives. */
  async drive(stick = { forward: 1, left: 0 }) {
    await this.hold(stick);
    return this.until((view) => view.wheels[1] > 0);
  }

  hold(stick) {
    return this.tab.evaluate((how) => {
      window.stick = setInterval(() => window.connection.request({ do: "drive", ...how }), 50);
    }, stick);
  }

  letGo() {
    return this.tab.evaluate(() => clearInterval(window.stick));
  }
}
