// navigator.serial as Chromium has it, for what no pseudo terminal can do: control lines, errors of the line, several
// adapters. Bytes go through a WebSocket for each port. For pages and workers; tests put `const FAKE = { bus, ports }` before.
// Names and texts of errors are Chromium's.
/* global FAKE */
{
  const lost = () => new DOMException("The device has been lost.", "NetworkError");
  const ERRORS = { BreakError: "Break received", FramingError: "Framing error", ParityError: "Parity error", BufferOverrunError: "Buffer overrun" };

  class FakePort extends EventTarget {
    #number;
    #socket = null;
    #readable = null;
    #writable = null;
    #feed = null;
    #isLost = false;
    /** What arrived and isn't read yet, bytes and errors in their order. */
    #queue = [];
    #wanted = null;

    constructor(number) {
      super();
      this.#number = number;
    }

    getInfo() {
      const { hangs, ...info } = FAKE.ports[this.#number];
      return info;
    }

    async open({ baudRate, bufferSize }) {
      if (this.#socket) throw new DOMException("Failed to execute 'open' on 'SerialPort': The port is already open.", "InvalidStateError");
      const socket = new WebSocket(`${FAKE.bus}/${this.#number}?baud=${baudRate}&buffer=${bufferSize}`);
      socket.binaryType = "arraybuffer";
      await new Promise((resolve, reject) => {
        socket.onopen = resolve;
        socket.onerror = () => reject(new DOMException("Failed to execute 'open' on 'SerialPort': Failed to open serial port.", "NetworkError"));
      });
      socket.onmessage = ({ data }) => this.#arrived(typeof data === "string" ? data : new Uint8Array(data));
      socket.onclose = () => this.#socket === socket && this.#arrived("lost");
      [this.#socket, this.#isLost, this.#queue] = [socket, false, []];
    }

    get readable() {
      if (!this.#socket || this.#isLost) return null;
      this.#readable ??= new ReadableStream(
        {
          start: (feed) => void (this.#feed = feed),
          pull: () => new Promise((pulled) => ((this.#wanted = pulled), this.#deliver())),
          cancel: () => void ([this.#readable, this.#wanted] = [null, null]),
        },
        { highWaterMark: 0 },
      );
      return this.#readable;
    }

    get writable() {
      if (!this.#socket || this.#isLost) return null;
      this.#writable ??= new WritableStream({
        write: (chunk) => {
          if (!ArrayBuffer.isView(chunk)) throw new TypeError("The provided value is not of type '(ArrayBuffer or ArrayBufferView)'.");
          if (this.#isLost) throw lost();
          this.#socket.send(chunk.slice());
        },
        close: () => void (this.#writable = null),
        abort: () => void (this.#writable = null),
      });
      return this.#writable;
    }

    async setSignals(signals) {
      if (!this.#socket) throw new DOMException("Failed to execute 'setSignals' on 'SerialPort': The port is closed.", "InvalidStateError");
      this.#socket.send(JSON.stringify(signals));
    }

    async close() {
      if (!this.#socket) throw new DOMException("Failed to execute 'close' on 'SerialPort': The port is already closed.", "InvalidStateError");
      if (this.#readable?.locked || this.#writable?.locked) throw new TypeError("Failed to execute 'close' on 'SerialPort': Cannot cancel a locked stream");
      if (FAKE.ports[this.#number].hangs) await new Promise(() => {});
      const socket = this.#socket;
      [this.#socket, this.#readable, this.#writable] = [null, null, null];
      await new Promise((closed) => ((socket.onclose = closed), socket.close()));
    }

    #arrived(what) {
      this.#queue.push(what);
      this.#deliver();
    }

    #deliver() {
      if (!this.#wanted || !this.#queue.length) return;
      const what = this.#queue.shift();
      const [pulled, feed] = [this.#wanted, this.#feed];
      this.#wanted = null;
      if (typeof what !== "string") feed.enqueue(what);
      else {
        this.#readable = null;
        this.#isLost = what === "lost";
        feed.error(this.#isLost ? lost() : new DOMException(ERRORS[what], what));
      }
      pulled();
    }
  }

  const ports = FAKE.ports.map((_, number) => new FakePort(number));
  class FakeSerial extends EventTarget {
    async getPorts() {
      return [...ports];
    }

    async requestPort() {
      const { chooses } = FAKE;
      if (chooses === "denied") throw new DOMException("Failed to execute 'requestPort' on 'Serial': Access to the feature \"serial\" is disallowed by permissions policy.", "SecurityError");
      if (chooses === undefined) throw new DOMException("Failed to execute 'requestPort' on 'Serial': No port selected by the user.", "NotFoundError");
      return ports[chooses];
    }
  }
  Object.defineProperty(navigator, "serial", { value: new FakeSerial(), configurable: true });
}
