// node figures-cold.mjs DIST...: first and later sweeps of hall20 in fresh instances of the draft module, ms.
import fs from "node:fs";
import { launchBrowser, serveFolder } from "/work/wt-figures/tests/e2e/browser.mjs";
const room = fs.readFileSync("/tmp/figures-hall20.json", "utf8");
const browser = await launchBrowser();
for (let round = 0; round < 3; round += 1) for (const dist of process.argv.slice(2)) {
  const server = await serveFolder(dist);
  const page = await (await browser.newContext()).newPage();
  await page.goto(`${server.url}scenario.schema.json`);
  const result = await page.evaluate(async (room) => {
    const script = `import init, { Drafting } from "${location.origin}/draft.js";
      await init({ module_or_path: await WebAssembly.compileStreaming(fetch("${location.origin}/draft_bg.wasm")) });
      const board = new Drafting(new OffscreenCanvas(10, 10));
      board.open([{ name: "hall20.json", bytes: new TextEncoder().encode(${JSON.stringify(room)}) }]);
      board.set({ ...board.view().settings, cell: 0.1, body: { kind: "octagon", width: 0.36 } });
      const times = [];
      for (let i = 0; i < 40; i += 1) { const began = performance.now(); board.sweep(() => {}); times.push(performance.now() - began); }
      self.postMessage({ first: times[0], second: times[1], last: times.slice(-11).sort((a, b) => a - b)[5], length: board.view().sweep.length });`;
    const worker = new Worker(URL.createObjectURL(new Blob([script], { type: "text/javascript" })), { type: "module" });
    return new Promise((resolve, reject) => { worker.onmessage = ({ data }) => resolve(data); worker.onerror = (e) => reject(new Error(e.message)); });
  }, room);
  console.log(dist, JSON.stringify(result));
  await server.close();
}
await browser.close();
