// The driver's worker, except that its time passes as fast as it can, and that a script says what arrives on its line: for
// findings that take a real one many seconds. Tests put it in place of www/connection/worker.js.
import init, { Connection } from "/workshop.js";

const bytes = (text) => [...text].map((letter) => letter.charCodeAt(0));
const always = (data) => () => data;

/** What arrives every quarter of a second, by the name in the bridge's address; `sent` is what was sent to the robot since. */
const LINES = {
  silence: always([]),
  stream: always([19, 2, 35, 1, 199]),
  charging: always(bytes("bat:   min 0  sec 10  mV 5930  mA 302  tenths-deg-C 182  mAH 0  state 6  mode 8\r\n")),
  booting: always(bytes("Roomba by iRobot!\r\n")),
  bootloader: always([0xfe, 0xfe]),
  garbage: always([0x80, 0x1c, 0xe0, 0x9c, 0x03, 0xfc]),
  text: always(bytes("hello there\r\n")),
  // Its mode, but no stream.
  no_stream: (sent) => (sent.at(-2) === 142 && sent.at(-1) === 35 ? [1] : []),
};

const STEP_S = 0.05;
let connection;
/** Its own time, s. */
let now = 0;

function transport(isOwnUsb) {
  const errors = { break: 0, framing: 0, parity: 0, overrun: 0 };
  return { kind: "serial", state: "open", name: "", text: "", baud: 115200, can_baud: !isOwnUsb, is_own_usb: isOwnUsb, brc: "none", errors, returns: 0, is_watching: false };
}

/** Connects to the robot of an address such as ws://robot/silence?usb, until it waits; returns the view. */
function connect(url) {
  const { pathname, searchParams } = new URL(url);
  const line = transport(searchParams.has("usb"));
  const arrives = LINES[pathname.slice(1)];
  connection.opened(now, line);
  let sent = [];
  // A view takes longer than the rest.
  for (let step = 0; step % 20 !== 0 || connection.view(now, line).phase !== "waiting"; step++) {
    if (step > 2000) throw new Error(`${url} is not given up`);
    now += STEP_S;
    sent.push(...connection.take_tx());
    while (connection.take_line());
    if (step % 5 === 0) {
      connection.feed(now, Uint8Array.from(arrives(sent)));
      sent = [];
    }
    connection.tick(now);
  }
  if (searchParams.has("unplugged")) {
    Object.assign(line, { state: "lost", text: "The adapter was unplugged. Plug it in again." });
    connection.lost(now, line.text, false);
  }
  return connection.view(now, line);
}

let ready;
self.addEventListener("message", async ({ data: message }) => {
  if (message.type === "init") {
    ready = init({ module_or_path: message.module }).then(() => (connection = new Connection()));
    return;
  }
  await ready;
  if (message.id === undefined) return;
  if (message.type === "open") self.postMessage({ type: "view", view: { ...connect(message.target.url), virtual: null } });
  if (message.type === "close") {
    connection.request(now, { do: "disconnect" });
    self.postMessage({ type: "view", view: { ...Connection.closed(), virtual: null } });
  }
  self.postMessage({ type: "answer", id: message.id, value: true });
});
