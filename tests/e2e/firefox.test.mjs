// What must work everywhere, in Firefox; and a robot on a serial port: Firefox's Web Serial as it is, its dialogue answered as a
// user would.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { ROOT } from "./browser.mjs";
import { firefoxPath, startFirefox } from "./engines/firefox.mjs";
import { checkIn } from "./engines/suite.mjs";
import { ends } from "./ends.mjs";
import { noSerial } from "./serial/desk.mjs";
import { Robot, lastStop, moves } from "./serial/robot.mjs";

const SERIAL = path.join(ROOT, "tests/e2e/serial");
/** Has the port's cable, and the library that makes it one for Firefox. */
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-e2e-"));
ends.push(async () => fs.rmSync(folder, { recursive: true }));
const cable = path.join(folder, "cable");

/** Firefox with a serial port, where there can be one. */
function start() {
  if (noSerial()) return startFirefox();
  const modem = path.join(folder, "modem.so");
  execFileSync("cc", ["-shared", "-fPIC", "-o", modem, path.join(SERIAL, "modem.c"), "-ldl"]);
  return startFirefox({
    executable: path.join(SERIAL, "browser"),
    env: { SERIAL_PTY: cable, SERIAL_ORIGIN: "", SERIAL_BROWSER: firefoxPath(), LD_PRELOAD: modem },
    // Its buttons would do nothing at first, against clicks by mistake.
    preferences: { "security.notification_enable_delay": 0 },
  });
}

/** Calls a function in the browser's own window instead of the page, until it returns something. */
async function inBrowser(page, what, ...args) {
  await page.send("Marionette:SetContext", { value: "chrome" });
  const value = await page.until(what, ...args);
  await page.send("Marionette:SetContext", { value: "content" });
  return value;
}

/** In the browser's window: chooses the first port that it lists; the names of all. */
function choosePort() {
  const { panel } = window.PopupNotifications;
  const choose = panel.querySelector("#webSerial-choosePort-notification .popup-notification-primary-button");
  if (panel.state !== "open" || !choose) return false;
  const menu = document.getElementById("webSerial-selectPort-menulist");
  const names = Array.from({ length: menu.itemCount }, (_, i) => menu.getItemAtIndex(i).label);
  choose.click();
  return names;
}

checkIn("Firefox", start, {
  "serial ports can be used, and if they are switched off, it is said where": async ({ page, url }) => {
    const supportIf = async (isEnabled) => {
      await inBrowser(page, (on) => (Services.prefs.setBoolPref("dom.webserial.enabled", on), true), isEnabled);
      await page.open("about:blank");
      await page.open(`${url}desk.html`);
      return page.until(() => window.support?.());
    };
    const { serial, why, instead } = await supportIf(false);
    assert.equal(serial, false);
    assert.match(why, /switched off in this Firefox/);
    assert.match(instead, /dom\.webserial\.enabled.*bridge.*virtual robot/);
    assert.deepEqual(await supportIf(true), { serial: true, usb: false, socket: true, why: "", instead: "" });
  },

  "a port is chosen, and its robot connects, drives and stops": async ({ page, url, t }) => {
    if (noSerial()) return t.skip(noSerial());
    const robot = await Robot.start(t);
    fs.symlinkSync(robot.pty, cable);
    await page.open(`${url}desk.html`);
    await page.until(() => window.connection);
    await page.click("#choose");
    assert.deepEqual(await inBrowser(page, choosePort), ["Test_cable"]);
    assert.equal(await page.evaluate(() => window.chosen), true, JSON.stringify(await page.evaluate(() => window.seen.failures)));
    const { transport } = await page.until(() => window.seen.view?.phase === "connected" && window.seen.view);
    assert.equal(transport.name, "FTDI adapter (0403:6001)");
    assert.equal(transport.brc, "high", "BRC is let go of");
    assert.deepEqual(robot.heard().filter(moves), [], "only a connection has been requested");

    assert.ok(await page.evaluate(() => window.connection.request({ do: "arm", full: false })));
    await page.until(() => window.seen.view.mode === "Safe" && window.seen.view.can.drive);
    await page.evaluate(() => void (window.stick = setInterval(() => window.connection.request({ do: "drive", forward: 1, left: 0 }), 50)));
    await page.until(() => window.seen.view.distance_m > 0.05);
    await page.evaluate(() => clearInterval(window.stick));
    await page.until(() => window.seen.view.wheels[0] === 0);
    await robot.rests();
    lastStop(robot.heard());
    await page.evaluate(() => window.connection.close());
    await robot.hears(173);
    assert.deepEqual(await page.evaluate(() => window.seen.failures), []);
  },
});
