// A web server for the built page, and Chromium. For programs that are not tests too, such as scripts/bench.mjs.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import http from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

export const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
export const DIST = path.join(ROOT, "dist");

const CONTENT_TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

export const CHROMIUM_FLAGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--disable-dev-shm-usage",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/**
 * Serves `folder` below `mount` (such as "/some/sub/path/") on a free port; anything outside of `mount` is not found, so a
 * page that assumes to live at the root fails.
 * `requests` lists the addresses asked for, in order, with their query. `also` has files that are served besides, or instead:
 * text by its address, without query.
 */
export async function serveFolder(folder, { mount = "/", headers = {}, also = {} } = {}) {
  const requests = [];
  const server = http.createServer((request, response) => {
    // Browsers ask for this on their own account.
    if (request.url === "/favicon.ico") {
      response.writeHead(204).end();
      return;
    }
    requests.push(request.url);
    const address = decodeURIComponent(new URL(request.url, "http://host").pathname);
    const file = path.join(folder, address.slice(mount.length).replace(/(^|\/)$/, "$1index.html"));
    const type = CONTENT_TYPES[path.extname(file)] ?? "application/octet-stream";
    if (Object.hasOwn(also, address)) {
      response.writeHead(200, { "content-type": type, "cache-control": "no-cache", ...headers }).end(also[address]);
      return;
    }
    const inside = address.startsWith(mount) && file.startsWith(folder + path.sep);
    if (!inside || !fs.statSync(file, { throwIfNoEntry: false })?.isFile()) {
      response.writeHead(404, { "content-type": "text/plain" }).end("not found");
      return;
    }
    response.writeHead(200, { "content-type": type, "cache-control": "no-cache", ...headers });
    fs.createReadStream(file).pipe(response);
  });
  // It never closes a connection that a browser is about to use again.
  server.keepAliveTimeout = 0;
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}${mount}`,
    requests,
    close: () => new Promise((resolve) => {
      server.close(resolve);
      server.closeAllConnections();
    }),
  };
}

export function chromiumPath() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  const names = "chromium chromium-browser google-chrome google-chrome-stable";
  return execFileSync("sh", ["-c", `for name in ${names}; do command -v $name && exit; done; exit 1`], { encoding: "utf8" }).trim();
}

/** $PAGE_BROWSER is quicker than $CHROMIUM, if set, but can't do all that a browser with windows can. */
export function launchBrowser({ flags = [], ...options } = {}) {
  return chromium.launch({ executablePath: process.env.PAGE_BROWSER || chromiumPath(), args: [...CHROMIUM_FLAGS, ...flags], ...options });
}

/** Registers no service worker. Playwright's own way throws in the frame of users' programs. */
export const withoutServiceWorkers = (context) =>
  context.addInitScript(() => {
    try {
      navigator.serviceWorker.register = async () => undefined;
    } catch {
      // A frame without an origin has none.
    }
  });

/**
 * What moves by itself is drawn 16 times a second at most: painting is what most tests cost, and none looks at more. What follows
 * an input comes at once.
 */
export const withFewFrames = (context) =>
  context.addInitScript(() => {
    const atNextFrame = self.requestAnimationFrame.bind(self);
    let waiting = new Map();
    let last = 0;
    let prompt = 30;
    /** One frame is due at a time: soon, or after the timer. */
    let isDue = false;
    let timer = 0;
    function callAll(now) {
      isDue = false;
      const due = waiting;
      waiting = new Map();
      for (const call of due.values()) call(now);
    }
    function soon() {
      clearTimeout(timer);
      timer = 0;
      if (!isDue) atNextFrame(callAll);
      isDue = true;
    }
    for (const input of ["pointerdown", "pointermove", "click", "wheel", "keydown", "keyup", "change", "hashchange", "popstate"]) {
      addEventListener(input, () => void ((prompt = 6), soon()), { capture: true, passive: true });
    }
    self.requestAnimationFrame = (call) => {
      if (!isDue && timer === 0) {
        if (prompt-- > 0) soon();
        else timer = setTimeout(soon, 60);
      }
      waiting.set((last += 1), call);
      return last;
    };
    self.cancelAnimationFrame = (id) => void waiting.delete(id);
  });
