// @ts-check
// The driver's connection and its line: passes bytes and time on, and stops the robot whatever goes wrong.
import { LineRequests } from "./line-requests.js";
import { lineTo } from "./lines.js";
import { failure } from "./ports.js";
import { RemoteLine } from "./remote-line.js";
import { STOP, SleepWatch } from "./safety.js";
import { VirtualLine } from "./virtual.js";

/** Number of ticks from view to view. */
const VIEW_TICKS = 5;

/** The worker's clock, s. */
export const now = () => performance.now() / 1000;

export class LiveConnection {
  #connection;
  #mirror;
  #holder;
  #tell;
  #requests;
  /** @type {import("./types").Transport | undefined} */
  #line;
  #isBroken = false;
  #ticks = 0;
  #sleep = new SleepWatch();

  /**
   * @param {import("../../workshop.js").Connection} connection
   * @param {import("../../workshop.js").SessionMirror} mirror the room of a virtual robot
   * @param {MessagePort} holder the worker that holds real lines
   * @param {(message: import("./types").FromConnection, transfer?: Transferable[]) => void} tell
   */
  constructor(connection, mirror, holder, tell) {
    this.#connection = connection;
    this.#mirror = mirror;
    this.#holder = holder;
    this.#tell = tell;
    this.#requests = new LineRequests(connection, (error) => this.broke(error), () => this.safely(() => {}));
  }

  /** An error of the program ended it; nothing is sent any more. */
  get isBroken() {
    return this.#isBroken;
  }

  /** Calls the connection, then executes its requests. Any error stops the robot. @param {() => void} what */
  safely(what) {
    if (this.#isBroken) return;
    try {
      if (this.#sleep.hasSlept()) this.#connection.leave(now(), "The computer slept or froze.");
      what();
      this.#requests.pass(this.#line);
      const readings = this.#connection.take_readings();
      if (readings.length) this.#tell({ type: "readings", readings }, [readings.buffer]);
    } catch (error) {
      this.broke(error);
    }
  }

  /** The page is about to go, and has had the line's worker stop the robot. @param {string} why */
  leave(why) {
    this.#line?.left?.();
    this.safely(() => this.#connection.leave(now(), why));
  }

  /** Does what takes time, in which the wheels aren't supervised. @template T @param {() => T} what @returns {T} */
  unsupervised(what) {
    this.safely(() => this.#connection.pause(now()));
    const done = what();
    this.#sleep.awake();
    return done;
  }

  /** Lets time pass. */
  tick() {
    const line = this.#line;
    if (!line) return this.#sleep.awake();
    this.safely(() => {
      if (line instanceof VirtualLine) line.tick(now());
      this.#connection.know_truth(line instanceof VirtualLine ? line.pose() : new Float64Array());
      this.#connection.tick(now());
    });
    if (line instanceof RemoteLine && !line.tick(this.#connection.is_acting())) void this.#rescue(line);
    if (++this.#ticks % VIEW_TICKS === 0) this.#show();
  }

  /** @param {import("./types").WorkerTarget} target */
  async open(target) {
    await this.close();
    if (this.#isBroken) throw failure("broken", "An error in this program has ended its connections.", "Reload the page.");
    this.#line = lineTo(target, this.#mirror, this.#holder, {
      onbytes: (bytes) => this.safely(() => this.#connection.feed(now(), bytes)),
      onopened: () => this.#opened(),
      onhalted: (why) =>
        this.safely(() => {
          this.#connection.leave(now(), why);
          // What was driving until now has been sent before.
          this.#line?.take?.();
        }),
      onlost: (why, forGood) => this.safely(() => this.#connection.lost(now(), why, forGood)),
    });
    try {
      await this.#line.open();
    } catch (error) {
      this.#show();
      this.#line = undefined;
      throw error;
    }
    this.#opened();
  }

  /** Stops waiting for a line that isn't open yet. */
  giveUp() {
    if (this.#line?.view.state === "opening") void this.#line.close();
  }

  async close() {
    const line = this.#line;
    if (!line) return;
    this.safely(() => this.#connection.request(now(), { do: "disconnect" }));
    await line.close();
    this.#show();
    this.#line = undefined;
    if (line instanceof VirtualLine) line.free();
  }

  /** @param {import("./types").Touch} touch */
  touch(touch) {
    this.safely(() => {
      if (!(this.#line instanceof VirtualLine)) return;
      this.#line.touch(touch);
      if (touch.do === "put_at_start") this.#connection.put_at(now(), touch.x, touch.y, touch.heading);
      else if (touch.do !== "press") this.#connection.moved_by_hand();
    });
  }

  /** Stops the robot without the connection, and ends the connection. @param {unknown} error */
  broke(error) {
    if (this.#isBroken) return;
    this.#line?.write(STOP);
    console.error(error);
    this.#end(`An error in this program ended the connection (${error instanceof Error ? error.message : error}). A stop command was sent.`, "Check that the robot has stopped, then connect again.");
    void this.#line?.close();
  }

  /** @param {string} what @param {string} remedy */
  #end(what, remedy) {
    this.#isBroken = true;
    this.#tell({ type: "failed", failure: failure("broken", what, remedy) });
  }

  /** The worker that holds the line no longer answers while the robot may be moving. @param {RemoteLine} lost */
  async #rescue(lost) {
    if (this.#isBroken) return;
    this.#isBroken = true;
    this.#tell({ type: "line-gone" });
    const isSent = await lost.rescue();
    const what = isSent ? "A stop command was sent over a new connection." : "A stop command could not be sent.";
    this.#end(`The worker that holds the line stopped responding. ${what}`, isSent ? "Check that the robot has stopped, then connect again." : "Lift the robot, or press its CLEAN button.");
  }

  #opened() {
    const line = this.#line;
    line?.take?.();
    if (line) this.safely(() => this.#connection.opened(now(), line.view));
  }

  #show() {
    const [connection, line] = [this.#connection, this.#line];
    if (this.#isBroken || !line) return;
    try {
      const virtual = line instanceof VirtualLine ? line.look() : null;
      const trace = connection.take_trace();
      if (trace.length) this.#tell({ type: "trace", trace }, [trace.buffer]);
      this.#tell({ type: "view", view: { ...connection.view(now(), line.view), virtual } });
      const traffic = connection.take_traffic();
      if (traffic.length) this.#tell({ type: "traffic", traffic });
    } catch (error) {
      this.broke(error);
    }
  }
}
