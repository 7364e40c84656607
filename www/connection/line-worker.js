// @ts-check
// Holds the line to a robot and does nothing else: bytes both ways, and a stop as soon as the driver's worker falls silent. There
// is no WebAssembly here and nothing that takes long, so that a mistake or a hang elsewhere can't keep a stop from being sent.
import { accessBy } from "./access.js";
import { failure } from "./ports.js";
import { HALT, STOP, Watch } from "./safety.js";
import { SerialLine } from "./serial.js";
import { SocketLine } from "./socket.js";

/** How often it looks whether the driver is there, and says that it is there itself, ms. */
const TICK_MS = 10;
/** How many of these steps there are from view to view of the line. */
const VIEW_TICKS = 20;

/** @type {import("./types").Transport | undefined} */
let line;
/** @type {MessagePort} */
let driver;
/** Whether the robot may be in motion, by the driver's last word. */
let isActing = false;
let isHalted = false;
/** The page has stopped the robot, and the driver doesn't know yet: what it writes was decided before. */
let isLeft = false;
let ticks = 0;
const watch = new Watch();

/** @param {import("./types").FromLine} message @param {Transferable[]} [transfer] */
const say = (message, transfer = []) => driver.postMessage(message, transfer);
const view = () => (line ? { ...line.view } : undefined);

setInterval(() => {
  if (line?.view.state !== "open") return;
  ticks += 1;
  say({ type: "beat", view: ticks % VIEW_TICKS === 0 ? view() : undefined });
  if (!isActing) return;
  watch.tick();
  if (watch.isSilent && !isHalted) {
    isHalted = true;
    line.write(HALT);
  }
  if (!watch.isGone) return;
  isActing = false;
  line.write(STOP);
  // If it comes back, it has nothing to say any more.
  driver.onmessage = null;
  void line.close();
  self.postMessage({ type: "driver-gone" });
}, TICK_MS);

/** @param {import("./types").LineTarget} target */
async function open(target) {
  isLeft = false;
  await line?.close();
  /** @type {import("./types").TransportEvents} */
  const events = {
    onbytes: (bytes) => say({ type: "bytes", bytes }),
    onopened: () => say({ type: "opened", view: view() }),
    onhalted: (why) => say({ type: "halted", why }),
    onlost: (why, forGood) => say({ type: "lost", why, forGood, view: view() }),
  };
  line = target.kind === "socket" ? new SocketLine(target.url, events) : new SerialLine(accessBy(target.kind), target.address, events);
  await line.open();
}

/** @param {Extract<import("./types").ToLine, { id: number }>} message */
async function done(message) {
  if (message.type === "open") await open(message.target);
  else if (message.type === "baud") await line?.setBaud(message.baud);
  else if (message.type === "brc") await line?.setBrc(message.isLow);
  else await line?.close();
}

/** @param {import("./types").ToLine} message */
async function heard(message) {
  watch.heard();
  isHalted = false;
  if (message.type === "beat") isActing = message.isActing;
  else if (message.type === "left") isLeft = false;
  else if (message.type === "write") {
    if (isLeft) return;
    isActing ||= message.isActing;
    line?.write(message.bytes);
  } else if (message.type === "take") line?.take?.();
  else if (message.type === "stop") line?.stop?.();
  else {
    try {
      await done(message);
      say({ type: "done", id: message.id, view: view() });
    } catch (error) {
      const known = error && typeof error === "object" && "kind" in error;
      say({ type: "done", id: message.id, view: view(), failure: known ? /** @type {import("./types").Failure} */ (error) : failure("failed", String(error), "") });
    }
  }
}

self.addEventListener("message", ({ data }) => {
  if (data.type === "stop") {
    isLeft = true;
    line?.write(STOP);
  } else {
    driver = data.driver;
    driver.onmessage = ({ data: message }) => void heard(message);
  }
});

// Whatever goes wrong here, the robot stops first.
self.addEventListener("error", (event) => {
  event.preventDefault();
  line?.write(STOP);
  self.postMessage({ type: "line-broke", why: String(event.error ?? event.message) });
});
self.addEventListener("unhandledrejection", (event) => {
  line?.write(STOP);
  self.postMessage({ type: "line-broke", why: String(event.reason) });
});
