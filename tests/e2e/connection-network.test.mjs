// A page from the internet and a bridge in the house: what Chromium's Local Network Access allows, forbids and asks, and what
// the page says of it. The names lead to this computer, and Chromium is told to take the page for one from outside.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import https from "node:https";
import net from "node:net";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { launchBrowser } from "./browser.mjs";
import { Bridge } from "./serial/bridge.mjs";
import { FloorPlanTab, openDesk } from "./serial/desk.mjs";
import { Robot } from "./serial/robot.mjs";

const skip = process.platform === "linux" ? false : "the emulator needs a pseudo terminal as Linux has them";
const TURN = { forward: 0, left: 1 };

/** The desk over https, for the test `t`. Returns its port. */
async function serveSecurely(t) {
  const { server } = await openDesk(t);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-e2e-"));
  const [key, cert] = [path.join(folder, "key.pem"), path.join(folder, "cert.pem")];
  execFileSync("openssl", ["req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2", "-subj", "/CN=robots.example", "-keyout", key, "-out", cert], { stdio: "ignore" });
  const secure = https.createServer({ key: fs.readFileSync(key), cert: fs.readFileSync(cert) }, async (request, response) => {
    const answer = await fetch(new URL(request.url ?? "", server.url));
    response.writeHead(answer.status, { "content-type": answer.headers.get("content-type") ?? "" }).end(Buffer.from(await answer.arrayBuffer()));
  });
  fs.rmSync(folder, { recursive: true });
  await new Promise((resolve) => secure.listen(0, "127.0.0.1", () => resolve(undefined)));
  t.after(() => (secure.closeAllConnections(), secure.close()));
  return /** @type {net.AddressInfo} */ (secure.address()).port;
}

/** A port on which nobody listens. */
async function freePort() {
  const server = net.createServer();
  await new Promise((resolve) => server.listen(0, "127.0.0.2", () => resolve(undefined)));
  const { port } = /** @type {net.AddressInfo} */ (server.address());
  await new Promise((resolve) => server.close(resolve));
  return port;
}

const CASES = {
  granted: { setting: "granted", says: undefined },
  "granted, and nobody answers": { setting: "granted", says: /doesn't answer\.$/, remedy: /same network/, isGone: true },
  forbidden: { setting: "denied", says: /doesn't let this page reach devices in your network/, remedy: /Allow "Local network access"/ },
  "not answered": { setting: "prompt", says: /asks first whether this page may reach devices/, remedy: /choose Allow/ },
};

for (const [name, { setting, says, remedy, isGone }] of Object.entries(CASES)) {
  test(`a bridge in the house, from a page over https: permission ${name}`, { skip }, async (t) => {
    const port = await serveSecurely(t);
    const origin = `https://robots.example:${port}`;
    const robot = await Robot.start(t);
    const bridge = await Bridge.start(t, robot, "--origin", origin);
    const there = isGone ? await freePort() : Number(new URL(bridge.address).port);
    const browser = await launchBrowser({
      flags: ["--host-resolver-rules=MAP robots.example 127.0.0.1, MAP bridge.local 127.0.0.2", `--ip-address-space-overrides=127.0.0.1:${port}=public,127.0.0.2:${there}=local`],
    });
    t.after(() => browser.close());
    const context = await browser.newContext({ ignoreHTTPSErrors: true, serviceWorkers: "block" });
    const desk = new FloorPlanTab(await context.newPage(), { url: `${origin}/` });
    const devtools = await browser.newBrowserCDPSession();
    const { targetInfos } = await devtools.send("Target.getTargets");
    const { browserContextId } = targetInfos.find(({ type }) => type === "page") ?? {};
    // Playwright knows no word for "denied".
    await devtools.send("Browser.setPermission", { permission: { name: "local-network" }, setting, origin, browserContextId });
    await desk.load();
    const isOpen = await desk.tab.evaluate((url) => window.connection.open({ kind: "socket", url }), `ws://bridge.local:${there}/`);
    if (says) {
      assert.equal(isOpen, false);
      const [failure] = await desk.failures();
      assert.match(failure.what, says);
      assert.match(failure.remedy, remedy);
    } else {
      assert.ok(isOpen, JSON.stringify(await desk.failures()));
      await desk.until((view) => view.phase === "connected");
      await desk.arm();
      await desk.drive(TURN);
      await robot.drives();
    }
  });
}
