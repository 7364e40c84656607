// @ts-check
// Drives a robot, separate from the page, which can be busy, hidden or hung: what the page asks for, and time.
import init, { Connection, SessionMirror } from "../../workshop.js";
import { LiveConnection, now } from "./live-connection.js";
import { failure } from "./ports.js";
import { startBeats } from "./safety.js";

/** How often time passes for the connection, ms. */
const TICK_MS = 10;

/** @type {Connection} */
let connection;
/** @type {SessionMirror} */
let mirror;
/** @type {LiveConnection | undefined} */
let live;
/** Openings and closings, one after the other. */
let doing = Promise.resolve();

const beatenAt = startBeats();

/** @param {import("./types").FromConnection} message @param {Transferable[]} [transfer] */
const tell = (message, transfer = []) => self.postMessage(message, { transfer });

/** Stops the robot, and says so. @param {unknown} error */
function broke(error) {
  if (live) live.broke(error);
  else tell({ type: "failed", failure: failure("broken", `The connection's worker could not start (${error}).`, "Reload the page.") });
}

self.addEventListener("error", (event) => {
  // Reported to the page here rather than by the browser.
  event.preventDefault();
  broke(event.error ?? event.message);
});
self.addEventListener("unhandledrejection", (event) => broke(event.reason));

setInterval(() => live?.tick(), TICK_MS);

/** Passes on why the connection refuses; that is no error of the program. @param {LiveConnection} live @param {() => void} what */
function attempt(live, what) {
  /** @type {unknown} */
  let refused;
  live.safely(() => {
    try {
      what();
    } catch (error) {
      // A sentence is a refusal; anything else went wrong.
      if (typeof error !== "string") throw error;
      refused = failure("refused", error, "");
    }
  });
  if (refused) throw refused;
}

/** @param {LiveConnection} live @param {Extract<import("./types").ToConnection, { id: number }>} message @returns {Promise<boolean | string>} */
async function answer(live, message) {
  if (message.type === "recording") {
    return live.unsupervised(() => connection.recording());
  }
  if (live.isBroken) return false;
  if (message.type === "facts") return connection.program_facts(mirror);
  if (message.type === "request" && message.request.do !== "disconnect") {
    attempt(live, () => connection.request(now(), message.request));
  } else if (message.type === "ride") {
    attempt(live, () => connection.ride(now(), mirror, message.corners, message.knots, message.cleans));
  } else if (message.type === "follow") {
    const { snapshot, algorithm } = message;
    if (mirror.is_behind(snapshot, algorithm)) {
      // Laying out a room isn't the page's silence.
      live.unsupervised(() => attempt(live, () => mirror.follow(snapshot, algorithm)));
      live.safely(() => connection.beat(now()));
    }
  } else {
    if (message.type !== "open") live.giveUp();
    const next = doing.then(() => (message.type === "open" ? live.open(message.target) : live.close()));
    doing = next.catch(() => {});
    await next;
  }
  return !live.isBroken;
}

let markReady = (/** @type {LiveConnection} */ _live) => {};
/** @type {Promise<LiveConnection>} */
const ready = new Promise((resolve) => (markReady = resolve));

self.addEventListener("message", async (/** @type {MessageEvent<import("./types").ToConnection>} */ { data: message }) => {
  if (message.type === "init") {
    await init({ module_or_path: message.module });
    [connection, mirror] = [new Connection(), new SessionMirror()];
    live = new LiveConnection(connection, mirror, message.holder, tell);
    return markReady(live);
  }
  const driver = await ready;
  if (message.type === "beat") connection.beat(beatenAt(now(), message.at));
  else if (message.type === "leave") driver.leave(message.why);
  else if (message.type === "answer") connection.answer(message.left, message.right);
  else if (message.type === "virtual") driver.touch(message.touch);
  else {
    let value = /** @type {boolean | string} */ (false);
    try {
      value = await answer(driver, message);
    } catch (error) {
      if (error && typeof error === "object" && "kind" in error) tell({ type: "failed", failure: /** @type {import("./types").Failure} */ (error) });
      else broke(error);
    }
    tell({ type: "answer", id: message.id, value });
  }
});
