// WebKit, the engine of Safari, as its GTK port on a screen that nobody sees.
import { spawn } from "node:child_process";
import { once } from "node:events";
import fs from "node:fs";
import net from "node:net";
import os from "node:os";
import path from "node:path";
import { Engine, findProgram } from "./engine.mjs";
import { startScreen } from "./screen.mjs";
import { connect } from "./webdriver.mjs";

async function freePort() {
  const server = net.createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  server.close();
  await once(server, "close");
  return port;
}

/** Waits until the driver answers. */
async function answered(driver, child) {
  let failure;
  child.once("error", (error) => (failure = error));
  child.once("exit", (code, signal) => (failure ??= new Error(`WebKitWebDriver ended (${code ?? signal})`)));
  while (!(await fetch(`${driver}/status`).then(({ ok }) => ok, () => false))) {
    if (failure) throw failure;
    await new Promise((later) => setTimeout(later, 20));
  }
}

/** Starts the small browser that WebKit's own tests use. Needs Debian's webkit2gtk-driver and xvfb. */
export async function startWebKit() {
  const home = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-webkit-"));
  const screen = await startScreen();
  const port = await freePort();
  // Without a graphics card, painting in memory takes half the time. Screenshots of what a worker paints never come then.
  const env = { ...process.env, WEBKIT_DISABLE_DMABUF_RENDERER: "1", HOME: home, XDG_RUNTIME_DIR: home, DISPLAY: screen.display, GDK_BACKEND: "x11", NO_AT_BRIDGE: "1", DBUS_SESSION_BUS_ADDRESS: "disabled:" };
  const child = spawn(findProgram("WebKitWebDriver"), [`--port=${port}`, "--host=127.0.0.1"], { env, stdio: "ignore" });
  process.once("exit", () => child.kill());
  const driver = `http://127.0.0.1:${port}`;
  await answered(driver, child);
  const send = await connect(driver, {});
  return new Engine(send, async () => {
    await send("DeleteSession");
    const ended = once(child, "exit");
    child.kill();
    await ended;
    screen.end();
    fs.rmSync(home, { recursive: true, force: true });
  });
}
