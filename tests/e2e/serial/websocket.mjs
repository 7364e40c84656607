// A WebSocket server (RFC 6455), as much of it as tests need: what a bridge to a robot's serial line is.
import { createHash } from "node:crypto";
import { EventEmitter } from "node:events";
import http from "node:http";

const KEY = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
const [TEXT, BINARY, CLOSE, PING, PONG] = [1, 2, 8, 9, 10];

/** Listens on a free port, or on `port`; `connected(socket, path)` is called for every connection. */
export async function listen(connected, port = 0) {
  const sockets = new Set();
  const server = http.createServer((_, response) => response.writeHead(426).end());
  server.on("upgrade", (request, tcp, head) => {
    const accept = createHash("sha1").update(request.headers["sec-websocket-key"] + KEY).digest("base64");
    tcp.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${accept}\r\n\r\n`);
    tcp.setNoDelay(true);
    sockets.add(tcp);
    tcp.once("close", () => sockets.delete(tcp));
    connected(new Socket(tcp, head), request.url);
  });
  await new Promise((resolve) => server.listen(port, "127.0.0.1", resolve));
  return {
    port: server.address().port,
    url: `ws://127.0.0.1:${server.address().port}`,
    close: () => {
      for (const tcp of sockets) tcp.destroy();
      return new Promise((resolve) => server.close(resolve));
    },
  };
}

/** Emits "binary" with bytes, "text" with a string, and "close". */
class Socket extends EventEmitter {
  #tcp;
  #heard;

  constructor(tcp, head) {
    super();
    this.#tcp = tcp;
    this.#heard = head;
    tcp.on("data", (data) => {
      this.#heard = Buffer.concat([this.#heard, data]);
      while (this.#frame());
    });
    tcp.on("error", () => {});
    tcp.once("close", () => this.emit("close"));
  }

  /** Takes a frame; says whether there was a whole one. Tests send none in parts. */
  #frame() {
    const heard = this.#heard;
    if (heard.length < 2) return false;
    const short = heard[1] & 127;
    const start = { 126: 4, 127: 10 }[short] ?? 2;
    if (heard.length < start + 4) return false;
    const length = short === 126 ? heard.readUInt16BE(2) : short === 127 ? Number(heard.readBigUInt64BE(2)) : short;
    const end = start + 4 + length;
    if (heard.length < end) return false;
    const mask = heard.subarray(start, start + 4);
    const data = Buffer.from(heard.subarray(start + 4, end).map((byte, index) => byte ^ mask[index & 3]));
    this.#heard = heard.subarray(end);
    const kind = heard[0] & 15;
    if (kind === BINARY) this.emit("binary", data);
    else if (kind === TEXT) this.emit("text", data.toString());
    else if (kind === PING) this.#send(PONG, data);
    else if (kind === CLOSE) {
      this.#send(CLOSE, data);
      this.#tcp.end();
    }
    return true;
  }

  #send(kind, data) {
    if (this.#tcp.destroyed) return;
    const head = data.length < 126 ? Buffer.from([128 | kind, data.length]) : Buffer.from([128 | kind, 126, data.length >> 8, data.length & 255]);
    this.#tcp.write(Buffer.concat([head, data]));
  }

  /** Sends bytes, or a string as text; at most 64 KiB. */
  send(data) {
    this.#send(typeof data === "string" ? TEXT : BINARY, Buffer.from(data));
  }

  close() {
    this.#tcp.destroy();
  }
}
