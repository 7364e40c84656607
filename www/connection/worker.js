// @ts-check
// A connection to a robot, separate from the page, which can be busy, hidden or hung: bytes, time, and the safety stop.
import init, { Connection, SessionMirror } from "../../workshop.js";
import { lineTo } from "./lines.js";
import { failure } from "./ports.js";
import { RemoteLine } from "./remote-line.js";
import { STOP, startBeats } from "./safety.js";
import { VirtualLine } from "./virtual.js";

/** How often time passes for the connection, ms, and how many such steps there are from view to view. */
const TICK_MS = 10;
const VIEW_TICKS = 5;

/** From when on a worker that didn't run is taken for asleep, ms. */
const SLEEP_MS = 1000;

/** @type {Connection} */
let connection;
/** @type {SessionMirror} */
let mirror;
/** The worker that holds real lines. @type {MessagePort} */
let holder;
/** @type {ReturnType<typeof lineTo> | undefined} */
let line;
/** The line is about to go on at another baud rate. */
let isChanging = false;
/** Something went wrong that should not; nothing is sent any more. */
let isBroken = false;
let ticks = 0;
/** Openings and closings, one after the other. */
let doing = Promise.resolve();

const now = () => performance.now() / 1000;
const beatenAt = startBeats();

/** @param {import("./types").FromConnection} message @param {Transferable[]} [transfer] */
const tell = (message, transfer = []) => self.postMessage(message, { transfer });

/** When this worker was last seen to run, by the time of day: its own clock may stand still while the computer sleeps, ms. */
let ranAt = Date.now();

/** A computer that slept, or a browser that stood still, didn't mind the robot. */
function mindSleep() {
  const slept = Date.now() - ranAt > SLEEP_MS;
  ranAt = Date.now();
  if (slept) connection.leave(now(), "The computer slept, or stood still.");
}

/** Calls the connection, then executes its requests. Any error stops the robot. @param {() => void} what */
function safely(what) {
  if (isBroken) return;
  try {
    mindSleep();
    what();
    pump();
    const readings = connection.take_readings();
    if (readings.length) tell({ type: "readings", readings }, [readings.buffer]);
  } catch (error) {
    broke(error);
  }
}

/** Sends what the connection has to say, at once. */
function pump() {
  // Unsent bytes must not be sent later: a line that returns can lead to another robot.
  if (line?.view.state !== "open") return connection.discard();
  while (!isChanging) {
    const wanted = connection.take_line();
    if (!wanted) {
      const bytes = connection.take_tx();
      if (!bytes.length) return;
      line.write(bytes, connection.is_acting());
    } else if (wanted === "stop") share("stop");
    else if ("brc" in wanted) line.setBrc(wanted.brc).catch(broke);
    else changeBaud(wanted.baud);
  }
}

/** Takes the turn to drive a robot that others see, too, or has it stopped. @param {"take" | "stop"} what */
function share(what) {
  if (line instanceof RemoteLine) line[what]();
}

/** @param {number} baud */
function changeBaud(baud) {
  isChanging = true;
  const changed = () => {
    isChanging = false;
    safely(() => {});
  };
  line?.setBaud(baud).then(changed, broke);
}

/** Stops the robot without the connection, and ends the connection. @param {unknown} error */
function broke(error) {
  if (isBroken) return;
  isBroken = true;
  line?.write(STOP);
  console.error(error);
  const said = error instanceof Error ? error.message : String(error);
  tell({ type: "failed", failure: failure("broken", `An error in this program ended the connection (${said}). A stop command was sent.`, "Check that the robot has stopped, then connect again.") });
  void line?.close();
}

self.addEventListener("error", (event) => {
  // Reported to the page here rather than by the browser.
  event.preventDefault();
  broke(event.error ?? event.message);
});
self.addEventListener("unhandledrejection", (event) => broke(event.reason));

/** The worker that holds the line no longer answers while the robot may be moving. @param {RemoteLine} lost */
async function rescue(lost) {
  if (isBroken) return;
  isBroken = true;
  tell({ type: "line-gone" });
  const isSent = await lost.rescue();
  const what = isSent ? "A stop command was sent over a new connection." : "A stop command could not be sent.";
  tell({ type: "failed", failure: failure("broken", `The worker that holds the line stopped responding. ${what}`, isSent ? "Check that the robot has stopped, then connect again." : "Lift the robot, or press its CLEAN button.") });
}

/** Does what takes time, in which the wheels aren't supervised. @template T @param {() => T} what @returns {T} */
function unsupervised(what) {
  safely(() => connection.pause(now()));
  const done = what();
  ranAt = Date.now();
  return done;
}

setInterval(() => {
  if (!line) return void (ranAt = Date.now());
  safely(() => {
    if (line instanceof VirtualLine) line.tick(now());
    connection.tick(now());
  });
  if (line instanceof RemoteLine && !line.tick(connection.is_acting())) void rescue(line);
  if (++ticks % VIEW_TICKS === 0) show();
}, TICK_MS);

function show() {
  if (isBroken || !line) return;
  try {
    const virtual = line instanceof VirtualLine ? line.look() : null;
    const trace = connection.take_trace();
    if (trace.length) tell({ type: "trace", trace }, [trace.buffer]);
    tell({ type: "view", view: { ...connection.view(now(), line.view), virtual } });
    const traffic = connection.take_traffic();
    if (traffic.length) tell({ type: "traffic", traffic });
  } catch (error) {
    broke(error);
  }
}

/** @param {import("./types").WorkerTarget} target */
async function open(target) {
  await close();
  if (isBroken) throw failure("broken", "An error in this program has ended its connections.", "Reload the page.");
  /** @type {import("./types").TransportEvents} */
  const events = {
    onbytes: (bytes) => safely(() => connection.feed(now(), bytes)),
    onopened: () => opened(),
    onhalted: (why) =>
      safely(() => {
        connection.leave(now(), why);
        // What was driving until now has been sent before.
        share("take");
      }),
    onlost: (why, forGood) => safely(() => connection.lost(now(), why, forGood)),
  };
  line = lineTo(target, mirror, holder, events);
  try {
    await line.open();
  } catch (error) {
    show();
    line = undefined;
    throw error;
  }
  opened();
}

function opened() {
  const view = line?.view;
  share("take");
  if (view) safely(() => connection.opened(now(), view));
}

async function close() {
  if (!line) return;
  safely(() => connection.request(now(), { do: "disconnect" }));
  const closing = line;
  await closing.close();
  show();
  line = undefined;
  if (closing instanceof VirtualLine) closing.free();
}

/** @param {Extract<import("./types").ToConnection, { id: number }>} message @returns {Promise<boolean | string>} */
async function answer(message) {
  if (message.type === "recording") {
    return unsupervised(() => connection.recording());
  }
  if (isBroken) return false;
  if (message.type === "facts") return connection.program_facts(mirror);
  if (message.type === "request" && message.request.do !== "disconnect") {
    attempt(() => connection.request(now(), message.request));
  } else if (message.type === "ride") {
    attempt(() => connection.ride(now(), mirror, message.corners, message.knots, message.cleans));
  } else if (message.type === "follow") {
    const { snapshot, algorithm } = message;
    if (mirror.is_behind(snapshot, algorithm)) {
      // Laying out a room isn't the page's silence.
      unsupervised(() => attempt(() => mirror.follow(snapshot, algorithm)));
      safely(() => connection.beat(now()));
    }
  } else {
    // A line that isn't open yet need not be waited for.
    if (message.type !== "open" && line?.view.state === "opening") void line.close();
    const next = doing.then(() => (message.type === "open" ? open(message.target) : close()));
    doing = next.catch(() => {});
    await next;
  }
  return !isBroken;
}

/** Passes on why it isn't done; that is no error of the program. @param {() => void} what */
function attempt(what) {
  /** @type {unknown} */
  let refused;
  safely(() => {
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

let markReady = () => {};
/** @type {Promise<void>} */
const ready = new Promise((resolve) => (markReady = resolve));

self.addEventListener("message", async (/** @type {MessageEvent<import("./types").ToConnection>} */ { data: message }) => {
  if (message.type === "init") {
    holder = message.holder;
    await init({ module_or_path: message.module });
    [connection, mirror] = [new Connection(), new SessionMirror()];
    return markReady();
  }
  await ready;
  if (message.type === "beat") connection.beat(beatenAt(now(), message.at));
  else if (message.type === "leave") safely(() => connection.leave(now(), message.why));
  else if (message.type === "answer") connection.answer(message.left, message.right);
  else if (message.type === "virtual") safely(() => line instanceof VirtualLine && line.touch(message.touch));
  else {
    let value = /** @type {boolean | string} */ (false);
    try {
      value = await answer(message);
    } catch (error) {
      if (error && typeof error === "object" && "kind" in error) tell({ type: "failed", failure: /** @type {import("./types").Failure} */ (error) });
      else broke(error);
    }
    tell({ type: "answer", id: message.id, value });
  }
});
