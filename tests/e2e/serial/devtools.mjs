// A browser by its DevTools protocol alone, over a pipe. Playwright keeps every page it knows "visible"; here, a page is
// hidden when another tab is shown, as for users.
import { spawn } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";

/** Starts `executable`. */
export async function launch(executable, { flags = [], env = {} } = {}) {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-profile-"));
  const own = ["--headless=new", "--remote-debugging-pipe", `--user-data-dir=${profile}`, "--no-startup-window"];
  const child = spawn(executable, [...own, ...flags], { env: { ...process.env, ...env }, stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const [, , , input, output] = child.stdio;
  const waiting = new Map();
  let sent = 0;
  let heard = "";
  output.setEncoding("utf8").on("data", (data) => {
    const messages = (heard + data).split("\0");
    heard = messages.pop();
    for (const { id, result, error } of messages.map((text) => JSON.parse(text))) {
      const { resolve, reject } = waiting.get(id) ?? {};
      if (error) reject?.(new Error(error.message));
      else resolve?.(result);
      waiting.delete(id);
    }
  });
  const send = (method, params = {}, sessionId = undefined) =>
    new Promise((resolve, reject) => {
      waiting.set(++sent, { resolve, reject });
      input.write(`${JSON.stringify({ id: sent, method, params, sessionId })}\0`);
    });
  const close = async () => {
    const ended = new Promise((resolve) => child.once("exit", resolve));
    await send("Browser.close");
    await ended;
    fs.rmSync(profile, { recursive: true, force: true });
  };
  return { openTab: (url) => openTab(send, url), close, pid: child.pid };
}

/** Opens a tab beside the others, and shows it. */
async function openTab(send, url) {
  const { targetId } = await send("Target.createTarget", { url });
  const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
  const evaluate = async (expression) => {
    const { result, exceptionDetails } = await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true }, sessionId);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  // The empty page that a tab begins with is not the one.
  while ((await evaluate("location.href + document.readyState").catch(() => "")) !== `${url}complete`) await new Promise((later) => setTimeout(later, 20));
  return {
    /** What an expression, or a promise of it, comes to. */
    evaluate,
    show: () => send("Target.activateTarget", { targetId }),
    close: () => send("Target.closeTarget", { targetId }),
  };
}
