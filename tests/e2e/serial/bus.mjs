// The robots behind the ports of fake.js, and a bridge: WebSockets that lead to robots' terminals.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import tty from "node:tty";
import { DIST } from "../browser.mjs";
import { listen } from "./websocket.mjs";

const HERE = import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname);

/**
 * Leads connections to the address /0, /1, ... to the first robot, the second, ... for the test `t`. `through` may change or
 * drop what a robot sends.
 */
export async function startBus(t, robots, { through = (bytes) => bytes, port } = {}) {
  /** Control lines as they were set, and baud rates: `{ time, number, ... }`, time in ms. */
  const events = [];
  const sockets = new Map();
  const bus = await listen((socket, address) => {
    const url = new URL(address, "ws://bus");
    const number = Number(url.pathname.slice(1));
    const baud = Number(url.searchParams.get("baud") ?? 115_200);
    events.push({ time: performance.now(), number, baud, buffer: Number(url.searchParams.get("buffer")) });
    let terminal;
    try {
      terminal = openTerminal(robots[number].pty, baud);
    } catch {
      // A page may look for its robot when that is gone already, at the end of a test.
      return socket.close();
    }
    sockets.set(number, socket);
    terminal.on("data", (bytes) => {
      const rest = through(bytes);
      if (rest.length) socket.send(rest);
    });
    terminal.on("error", () => socket.close());
    socket.on("binary", (bytes) => terminal.write(bytes));
    socket.on("text", (text) => events.push({ time: performance.now(), number, ...JSON.parse(text) }));
    socket.on("close", () => terminal.destroy());
  }, port);
  t.after(() => bus.close());
  return {
    ...bus,
    events,
    /** Lets the adapter report a break and the like. */
    inject: (number, error) => sockets.get(number).send(error),
    drop: (number) => sockets.get(number).close(),
  };
}

export function setRate(pty, baud) {
  execFileSync("stty", ["-F", pty, "raw", "-echo", String(baud)]);
}

export function openTerminal(pty, baud) {
  setRate(pty, baud);
  const flags = fs.constants.O_RDWR | fs.constants.O_NOCTTY | fs.constants.O_NONBLOCK;
  const reading = new tty.ReadStream(fs.openSync(pty, flags));
  const writing = new tty.WriteStream(fs.openSync(pty, flags));
  reading.write = (bytes) => writing.write(bytes);
  reading.once("close", () => writing.destroy());
  writing.on("error", () => {});
  return reading;
}

/** Files that put a fake, fake.js or usb-fake.js, into the page and its workers: for `also` of `openDesk`. */
export function fakeFiles(config, fake = "fake.js") {
  const read = (file) => fs.readFileSync(file, "utf8");
  return {
    "/fake.js": `const FAKE = ${JSON.stringify(config)};\n${read(path.join(HERE, fake))}`,
    "/desk.html": read(path.join(HERE, "page.html")).replace('<script type="module">', '<script src="/fake.js"></script>$&'),
    // Each worker that opens ports.
    ...Object.fromEntries(["worker.js", "line-worker.js"].map((name) => [`/www/connection/${name}`, `import "/fake.js";\n${read(path.join(DIST, "www/connection", name))}`])),
  };
}
