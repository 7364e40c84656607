// Programs of strangers: whatever they do, they reach nothing, and the page goes on. HOSTILE=1000 runs a thousand of them.
import assert from "node:assert/strict";
import http from "node:http";
import { test } from "node:test";
import { openPage } from "./harness.mjs";
import { hostile } from "./hostile.mjs";

const COUNT = Number(process.env.HOSTILE ?? 24);
const SEED = Number(process.env.SEED ?? 7);
/** Longest that the page may stand still, ms. Other tests run beside this one: what the programs add shows on a quiet machine. */
const MOST_MS = Number(process.env.MOST_MS ?? (process.env.HOSTILE ? 100 : 1000));

/** Listens where nobody must ask. */
async function trap(t) {
  const caught = [];
  const server = http.createServer((request, response) => {
    caught.push(request.url);
    response.writeHead(200, { "access-control-allow-origin": "*", "content-type": "text/javascript" }).end("");
  });
  server.on("upgrade", (request, socket) => {
    caught.push(request.url);
    socket.destroy();
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  t.after(() => {
    server.close();
    server.closeAllConnections();
  });
  return { caught, address: `http://127.0.0.1:${server.address().port}/` };
}

/** Runs in the page: a program in the sandbox until it has ended, failed, been ended or driven 600 steps. */
async function run({ language, source }) {
  const [{ kitFor }, { Inmate }] = await Promise.all([import(new URL("www/program/kit.js", document.baseURI).href), import(new URL("www/program/sandbox.js", document.baseURI).href)]);
  const kit = await kitFor(language);
  let longest = 0;
  let last = performance.now();
  const beat = setInterval(() => {
    const now = performance.now();
    longest = Math.max(longest, now - last);
    last = now;
  }, 4);
  const began = performance.now();
  const how = await new Promise((resolve) => {
    const hear = (message) => {
      if (message?.type === "loaded") inmate.ask(message.kind === "plan" ? { type: "plan", id: 1 } : { type: "go", id: 1, until: 600 });
      else if (message?.type === "failed") resolve(`failed: ${String(message.message).slice(0, 120)}`);
      else if (message?.type === "planned") resolve("planned");
      else if (message?.type === "ran" && message.more !== true) resolve(`ran ${message.steps}`);
    };
    const inmate = new Inmate(kit, hear, (why) => resolve(`ended: ${why}`));
    window.hostileJob ??= window.robovac?.job;
    inmate.ask({ type: "load", id: 1, language, source, job: window.hostileJob, traced: false, breakpoints: [], from: 0 });
    window.endHostile = () => inmate.end();
  });
  const took = performance.now() - began;
  clearInterval(beat);
  window.endHostile();
  return { how, took, longest };
}

// slow: each endless loop is waited for a second, and there are many.
test(`${COUNT} hostile programs reach nothing and stop nothing`, { timeout: 3_600_000 }, async (t) => {
  const { caught, address } = await trap(t);
  const { page, server } = await openPage(t, { allow: [/Content Security Policy/, /violates/, /blocked/i, /uncaught/i, /console: /, /hostile/] });
  await page.waitForFunction(() => document.body.dataset.boot === "ready");
  await page.evaluate(async () => {
    const { default: init, Playground } = await import(new URL("page.js", document.baseURI).href);
    await init({ module_or_path: new URL("page_bg.wasm", document.baseURI) });
    const playground = new Playground(Object.assign(document.createElement("canvas"), { width: 10, height: 10 }));
    playground.take_plan_request();
    window.hostileJob = playground.program_job();
  });
  const kept = () => page.evaluate(async () => JSON.stringify([Object.keys(localStorage).filter((key) => /hostile/.test(key)), (await indexedDB.databases()).map(({ name }) => name), await caches.keys(), document.body.childElementCount > 5]));
  const before = await kept();
  const programs = hostile(SEED, address);
  /** @type {Record<string, number>} */
  const ends = {};
  const slow = [];
  // What is fetched for the sandbox itself.
  await page.evaluate(run, { language: "python", source: "def step(robot):\n    robot.go(0.1)\n" });
  const asked = server.requests.length;
  for (let index = 0; index < COUNT; index += 1) {
    const program = programs.next().value;
    const { how, took, longest } = await page.evaluate(run, program);
    const end = how.split(":")[0].replace(/\d+/, "");
    ends[end] = (ends[end] ?? 0) + 1;
    assert.ok(took < 60_000, `${took} ms until the end of\n${program.source}`);
    if (longest > MOST_MS) slow.push(`${Math.round(longest)} ms: ${how}\n${program.source}`);
    if (process.env.VERBOSE) console.log(`${index} ${program.language} ${Math.round(took)} ms, longest ${Math.round(longest)} ms, ${how}\n${program.source}`);
  }
  t.diagnostic(JSON.stringify(ends));
  assert.deepEqual(slow, [], "the page stood still");
  assert.deepEqual(caught, [], "requests that arrived");
  // The page may still fetch parts of its own.
  assert.deepEqual(server.requests.slice(asked).filter((request) => !/\.(js|css|json|wasm|html)(\?|$)/.test(request)), [], "requests to the page's own server");
  assert.equal(await kept(), before);
});
