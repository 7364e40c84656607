// Programs of strangers: whatever they do, they reach nothing, and the page goes on. HOSTILE=1000 runs a thousand of them;
// with FROM=500, the thousand after the first 500.
import assert from "node:assert/strict";
import http from "node:http";
import { test } from "node:test";
import { launchBrowser, serveFolder, withoutServiceWorkers } from "./browser.mjs";
import { DIST } from "./harness.mjs";
import { hostile } from "./hostile.mjs";

const COUNT = Number(process.env.HOSTILE ?? 24);
const FROM = Number(process.env.FROM ?? 0);
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

/** The page in a browser that gives the frame of programs a process of its own, as those with windows do by themselves. */
async function openApart(t, address, ...flags) {
  const server = await serveFolder(DIST);
  const browser = await launchBrowser({ flags: ["--site-per-process", ...flags] });
  t.after(async () => {
    await browser.close();
    await server.close();
  });
  const context = await browser.newContext({ viewport: { width: 1000, height: 640 } });
  await withoutServiceWorkers(context);
  const page = await context.newPage();
  await page.goto(server.url + address);
  return { page, server };
}

/** Playwright takes a page whose frame has broken down for broken; this evaluates in it all the same. */
async function evaluator(page) {
  const session = await page.context().newCDPSession(page);
  return async (what, value) => {
    const { result, exceptionDetails } = await session.send("Runtime.evaluate", { expression: `(${what})(${JSON.stringify(value)})`, awaitPromise: true, returnByValue: true });
    assert.equal(exceptionDetails, undefined);
    return result.value;
  };
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
  const { page, server } = await openApart(t, "");
  await page.waitForFunction(() => document.body.dataset.boot === "ready");
  const evaluate = await evaluator(page);
  await evaluate(async () => {
    const { default: init, Playground } = await import(new URL("page.js", document.baseURI).href);
    await init({ module_or_path: new URL("page_bg.wasm", document.baseURI) });
    const playground = new Playground(Object.assign(document.createElement("canvas"), { width: 10, height: 10 }));
    playground.take_plan_request();
    window.hostileJob = playground.program_job();
  });
  const kept = () => evaluate(async () => JSON.stringify([Object.keys(localStorage).filter((key) => /hostile/.test(key)), (await indexedDB.databases()).map(({ name }) => name), await caches.keys(), document.body.childElementCount > 5]));
  const before = await kept();
  const programs = hostile(SEED, address);
  /** @type {Record<string, number>} */
  const ends = {};
  const slow = [];
  // What is fetched for the sandbox itself.
  await evaluate(run, { language: "python", source: "def step(robot):\n    robot.go(0.1)\n" });
  const asked = server.requests.length;
  for (let index = 0; index < FROM; index += 1) programs.next();
  for (let index = FROM; index < FROM + COUNT; index += 1) {
    const program = programs.next().value;
    const { how, took, longest } = await evaluate(run, program);
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

// slow: a worker counts as silent after a second, and its frame as broken after two more.
test("memory that a program uses up ends the program, and neither the page nor the next one", async (t) => {
  // So little memory that it is soon used up.
  const { page } = await openApart(t, "#tab=program&script=turn_when_you_bump.javascript", "--js-flags=--max-old-space-size=200");
  await page.locator("#program-run").waitFor();
  const evaluate = await evaluator(page);
  const until = (what) => evaluate(`async () => { while (!(${what})()) await new Promise(requestAnimationFrame) }`);
  await page.locator(".cm-content", { hasText: "function step" }).click();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.insertText("const all = [];\nfunction step(robot) {\n  robot.go(0.2);\n  all.push(new Array(1e5).fill(1.5));\n}\n");
  await page.keyboard.press("Control+Enter");
  await until(() => /too much memory/.test(document.getElementById("program-error").textContent));
  await evaluate(() => {
    const list = document.getElementById("program-list");
    list.value = "turn_when_you_bump.python";
    list.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await until(() => document.getElementById("program-error").hidden && Number(document.getElementById("n-distance").textContent) > 0.5);
});
