// Firefox's own end of WebDriver: the same commands as over HTTP, as JSON on a socket. Geckodriver, which Debian lacks, only
// translates between the two. https://firefox-source-docs.mozilla.org/testing/marionette/Protocol.html
import net from "node:net";

/** Connects to a Firefox that listens; `send(name, parameters)` then resolves to what the command returns. */
export async function connect(port) {
  const socket = net.connect(port, "127.0.0.1");
  const waiting = new Map();
  let sent = 0;
  let heard = Buffer.alloc(0);
  const give = ([, id, error, result]) => {
    const { resolve, reject } = waiting.get(id);
    waiting.delete(id);
    if (error) reject(new Error(`${error.error}: ${error.message}`));
    else resolve(result !== null && "value" in result ? result.value : result);
  };
  const greeted = new Promise((resolve, reject) => {
    socket.once("error", reject);
    socket.on("data", (data) => {
      heard = Buffer.concat([heard, data]);
      for (let colon; (colon = heard.indexOf(":")) >= 0; ) {
        const end = colon + 1 + Number(heard.subarray(0, colon));
        if (heard.length < end) return;
        const message = JSON.parse(heard.subarray(colon + 1, end).toString());
        heard = heard.subarray(end);
        if (Array.isArray(message)) give(message);
        else resolve();
      }
    });
  });
  socket.on("close", () => {
    for (const { reject } of waiting.values()) reject(new Error("Firefox is gone"));
  });
  await greeted;
  return (name, parameters = {}) =>
    new Promise((resolve, reject) => {
      waiting.set(++sent, { resolve, reject });
      const text = JSON.stringify([0, sent, name.includes(":") ? name : `WebDriver:${name}`, parameters]);
      socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
}
