// USB adapters in front of robots: the devices behind usb-fake.js. A page and each of its workers has a connection; what it
// has claimed is free again when it closes, as when the browser ends a worker.
import { openTerminal, setRate } from "./bus.mjs";
import { listen } from "./websocket.mjs";

/** Rates that a terminal can have. */
const RATES = [300, 600, 1200, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200];
const GONE = ["NotFoundError", "The device was disconnected."];

let keys = 0;

class Adapter {
  #terminal;
  #rate = 0;
  #queue = [];
  #waiting = [];
  /** When all is sent, ms. */
  #sentAt = 0;
  owner = null;
  /** What RTS was switched to, and when, in ms. @type {{ isOn: boolean, time: number }[]} */
  rts = [];
  key = ++keys;
  /** Another program has it. */
  isTaken = false;

  constructor(chip, robot) {
    Object.assign(this, { chip, robot });
    // Chips of FTDI answer even when they have nothing to say.
    this.timer = chip.latency && setInterval(() => this.#deliver(true), 16);
  }

  /** Brings the terminal to the chip's settings. */
  settle() {
    const { chip, robot } = this;
    if (chip.rts !== null && chip.rts !== this.rts.at(-1)?.isOn) {
      this.rts.push({ isOn: chip.rts, time: performance.now() });
      robot?.order(`brc ${chip.rts ? "low" : "high"}`);
    }
    if (!chip.isReady || !robot) return;
    const rate = RATES.find((one) => Math.abs(one / chip.baud - 1) < 0.03);
    if (!rate || rate === this.#rate) return;
    this.#rate = rate;
    if (this.#terminal) return setRate(robot.pty, rate);
    this.#terminal = openTerminal(robot.pty, rate);
    this.#terminal.on("error", () => {});
    this.#terminal.on("data", (bytes) => {
      if (!chip.isReady || !this.owner) return;
      this.#queue.push(...bytes);
      this.#deliver();
    });
  }

  #deliver(isIdle = false) {
    for (const one of this.#waiting.filter(({ type }) => type === "bulk")) {
      if (!this.#queue.length && !isIdle) return;
      const data = this.chip.pack(this.#queue, one.length);
      if (!data.length) return;
      this.#answer(one, { status: "ok", data });
      if (isIdle) return;
    }
  }

  #answer(one, answer) {
    this.#waiting = this.#waiting.filter((other) => other !== one);
    one.tell(answer);
  }

  /** A request for data: answered when there is some. */
  fetch(tell, { endpoint, length }) {
    const [, type] = this.chip.descriptor.endpoints.find(([address]) => address === (endpoint | 128)) ?? [];
    this.#waiting.push({ tell, length, type });
    this.#deliver();
  }

  /** The chip takes its time to send; what it hasn't sent when it is switched off is lost. */
  send(bytes) {
    const { chip } = this;
    const now = performance.now();
    this.#sentAt = Math.max(this.#sentAt, now) + (10_000 * bytes.length) / chip.baud;
    setTimeout(() => chip.isReady && this.#terminal?.write(Buffer.from(bytes)), this.#sentAt - now);
  }

  /** The chip reports an error of the line; FTDI's do with the next bytes. */
  report(error) {
    const packet = this.chip.report(error);
    const one = packet && this.#waiting.find(({ type }) => type === "interrupt");
    if (one) this.#answer(one, { status: "ok", data: packet });
  }

  release(error = ["AbortError", "The transfer was cancelled."]) {
    this.owner = null;
    this.#queue = [];
    for (const one of [...this.#waiting]) this.#answer(one, { error });
  }

  end() {
    clearInterval(this.timer);
    this.release(GONE);
    this.#terminal?.destroy();
  }
}

/** Starts it for the test `t`, with a chip and a robot for each adapter. */
export async function startUsb(t, ...pairs) {
  const plugged = new Set(pairs.map(([chip, robot]) => new Adapter(chip, robot)));
  const sockets = new Set();
  const tellAll = (event) => sockets.forEach((socket) => socket.send(JSON.stringify({ event })));

  function answer(socket, request, tell) {
    if (request.do === "list") return tell({ list: [...plugged].map(({ key, chip }) => ({ key, ...chip.info })) });
    const adapter = [...plugged].find(({ key }) => key === request.key);
    if (!adapter) return tell({ error: GONE });
    const isOwner = adapter.owner === socket;
    if (request.do === "open") return tell({});
    if (request.do === "close") {
      if (isOwner) adapter.release();
      return tell({});
    }
    if (request.do === "claim") {
      if (adapter.isTaken || (adapter.owner && !isOwner)) return tell({ error: ["NetworkError", "Failed to execute 'claimInterface' on 'USBDevice': Unable to claim interface."] });
      adapter.owner = socket;
      return tell({});
    }
    if (!isOwner) return tell({ error: ["NotFoundError", "The specified interface or endpoint has not been claimed."] });
    if (request.do === "in") return adapter.fetch(tell, request);
    if (request.do === "out") adapter.send(request.data);
    if (request.do === "out") return tell({ status: "ok" });
    const result = adapter.chip.control(request.type, request.request, request.value, request.index, request.data);
    adapter.settle();
    return tell(result.data ? { ...result, data: result.data.slice(0, request.length) } : result);
  }

  const bus = await listen((socket) => {
    sockets.add(socket);
    socket.on("text", (text) => {
      const request = JSON.parse(text);
      answer(socket, request, (reply) => socket.send(JSON.stringify({ id: request.id, ...reply })));
    });
    socket.on("close", () => {
      sockets.delete(socket);
      for (const adapter of plugged) if (adapter.owner === socket) adapter.release();
    });
  });
  t.after(async () => {
    plugged.forEach((adapter) => adapter.end());
    await bus.close();
  });
  return {
    ...bus,
    adapters: [...plugged],
    unplug(adapter) {
      plugged.delete(adapter);
      adapter.end();
      tellAll("disconnect");
    },
    /** Plugs in a chip, which is another device by then. */
    plug(chip, robot) {
      const adapter = new Adapter(chip, robot);
      plugged.add(adapter);
      tellAll("connect");
      return adapter;
    },
  };
}
