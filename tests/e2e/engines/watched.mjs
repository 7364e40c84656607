// The built page on a web server, with an eye on everything that goes wrong in it.
import fs from "node:fs";
import path from "node:path";
import { DIST, ROOT, serveFolder } from "../browser.mjs";

const REPORTER = fs.readFileSync(path.join(ROOT, "tests/e2e/engines/reporter.js"), "utf8");
/** A connection and nothing else. */
const desk = fs.readFileSync(path.join(ROOT, "tests/e2e/serial/page.html"), "utf8");
const read = (name) => fs.readFileSync(path.join(DIST, name), "utf8");

/** What is served instead of, or beside, what was built. */
function watched() {
  const workers = fs.readdirSync(path.join(DIST, "www"), { recursive: true }).filter((name) => /worker\.js$/.test(name));
  return {
    "/": read("index.html").replace("<head>", `<head><script>${REPORTER}</script>`),
    "/desk.html": desk.replace("<head>", `<head><script>${REPORTER}</script>`),
    "/problem": "",
    // What it would keep for use without a network isn't what was built.
    "/sw.js": "",
    "/planted-worker.js": `${REPORTER}\nconsole.error("logged by a worker"); throw new Error("thrown by a worker");`,
    ...Object.fromEntries(workers.map((name) => [`/www/${name}`, `${REPORTER}\n${read(`www/${name}`)}`])),
  };
}

/** Serves the page; `problems()` are those so far. */
export async function serveWatched() {
  const server = await serveFolder(DIST, { also: watched() });
  const problems = () => server.requests.filter((address) => address.startsWith("/problem?")).map((address) => decodeURIComponent(address.slice("/problem?".length)));
  return { ...server, problems };
}
