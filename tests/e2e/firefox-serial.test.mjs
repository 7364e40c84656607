// A robot on a serial port in Firefox: its Web Serial as it is, and its own dialogue, answered as a user would.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { DIST, ROOT, serveFolder } from "./browser.mjs";
import { firefoxPath, startFirefox } from "./engines/firefox.mjs";
import { noSerial, page } from "./serial/desk.mjs";
import { Robot, lastStop, moves } from "./serial/robot.mjs";

const SERIAL = path.join(ROOT, "tests/e2e/serial");

/** Chooses the only port that Firefox lists; says what it is called there. */
async function choosePort(firefox) {
  await firefox.send("Marionette:SetContext", { value: "chrome" });
  const names = await firefox.until(() => {
    const { panel } = window.PopupNotifications;
    const choose = panel.querySelector("#webSerial-choosePort-notification .popup-notification-primary-button");
    if (panel.state !== "open" || !choose) return false;
    const menu = document.getElementById("webSerial-selectPort-menulist");
    const listed = Array.from({ length: menu.itemCount }, (_, i) => menu.getItemAtIndex(i).label);
    choose.click();
    return listed;
  });
  await firefox.send("Marionette:SetContext", { value: "content" });
  return names;
}

test("Firefox: a port is chosen, and its robot connects, drives and stops", { skip: noSerial() || false }, async (t) => {
  const robot = await Robot.start(t);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-e2e-"));
  const modem = path.join(folder, "modem.so");
  execFileSync("cc", ["-shared", "-fPIC", "-o", modem, path.join(SERIAL, "modem.c"), "-ldl"]);
  const server = await serveFolder(DIST, { also: { "/desk.html": page("page.html") } });
  const firefox = await startFirefox({
    executable: path.join(SERIAL, "browser"),
    env: { SERIAL_PTY: robot.pty, SERIAL_ORIGIN: "", SERIAL_BROWSER: firefoxPath(), LD_PRELOAD: modem },
    // Its buttons would do nothing at first, against clicks by mistake.
    preferences: { "security.notification_enable_delay": 0 },
  });
  t.after(async () => {
    await firefox.close();
    await server.close();
    fs.rmSync(folder, { recursive: true });
  });
  await firefox.open(`${server.url}desk.html`);
  await firefox.until(() => window.connection);
  await firefox.click("#choose");
  assert.deepEqual(await choosePort(firefox), ["Test_cable"]);
  assert.equal(await firefox.evaluate(() => window.chosen), true, JSON.stringify(await firefox.evaluate(() => window.seen.failures)));
  const { transport } = await firefox.until(() => window.seen.view?.phase === "connected" && window.seen.view);
  assert.equal(transport.name, "FTDI adapter (0403:6001)");
  assert.equal(transport.brc, "high", "BRC is let go of");
  assert.deepEqual(robot.heard().filter(moves), [], "only a connection has been requested");

  assert.ok(await firefox.evaluate(() => window.connection.request({ do: "arm", full: false })));
  await firefox.until(() => window.seen.view.mode === "Safe" && window.seen.view.can.drive);
  await firefox.evaluate(() => (window.stick = setInterval(() => window.connection.request({ do: "drive", forward: 1, left: 0 }), 50)) && undefined);
  await firefox.until(() => window.seen.view.distance_m > 0.05);
  await firefox.evaluate(() => clearInterval(window.stick));
  await firefox.until(() => window.seen.view.wheels[0] === 0);
  await robot.rests();
  assert.ok(robot.heard().some(moves));
  lastStop(robot.heard());
  await firefox.evaluate(() => window.connection.close());
  await robot.hears(173);
  assert.deepEqual(await firefox.evaluate(() => window.seen.failures), []);
});
