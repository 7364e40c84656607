// How near the best possible the planner near_optimal comes in a browser, and how soon:
// node scripts/near-optimal.mjs [SECONDS [WORD...]], after ./dev build, on the rooms of ../shared/maps/grids whose names contain a word.
// Open walks at steps + 2 x quarter turns, as examples/near_optimal_table.rs measures them natively; its effort is the
// largest, and the worker is ended after SECONDS (30).
import fs from "node:fs";
import path from "node:path";
import { DIST, ROOT, launchBrowser, serveFolder } from "../tests/e2e/browser.mjs";

const GRIDS = path.join(ROOT, "../shared/maps/grids");
const [seconds = "30", ...words] = process.argv.slice(2);
/** When a first walk is wanted, s. */
const SOON = 0.2;
/** Walks are priced in sixteenths of a step. */
const UNIT = 16;

/** A room, rows from the bottom up. */
function read(file) {
  const rows = fs
    .readFileSync(file, "utf8")
    .split("\n")
    .filter((line) => line !== "" && !line.startsWith(";"))
    .reverse();
  const width = Math.max(...rows.map((row) => row.length));
  const glyphs = rows.map((row) => row.padEnd(width, "#")).join("");
  const marked = glyphs.indexOf("S");
  const start = marked < 0 ? [...glyphs].findIndex((glyph) => glyph !== "#") : marked;
  return { width, free: [...glyphs].map((glyph) => Number(glyph !== "#")), start: [start % width, Math.floor(start / width)] };
}

/** Runs in the page: plans in the page's own worker, and looks at every walk that is reported. */
async function measure({ room, seconds, unit }) {
  const { width, start } = room;
  const free = Uint8Array.from(room.free);
  const worker = new Worker("./www/worker.js", { type: "module" });
  const module = await WebAssembly.compileStreaming(fetch("./workshop_bg.wasm"));
  /** Steps + 2 x quarter turns; cells that can't be reached from the start don't count. */
  const cost = (cells) => {
    let sum = cells.length / 2 - 1;
    for (let i = 4; i < cells.length; i += 2) {
      const [ax, ay] = [cells[i - 2] - cells[i - 4], cells[i - 1] - cells[i - 3]];
      const [bx, by] = [cells[i] - cells[i - 2], cells[i + 1] - cells[i - 1]];
      sum += 2 * (1 - (ax * bx + ay * by));
    }
    return sum;
  };
  const reachable = () => {
    const seen = new Uint8Array(free.length);
    const queue = [start[1] * width + start[0]];
    seen[queue[0]] = 1;
    for (const at of queue) {
      const near = [at % width ? at - 1 : -1, (at + 1) % width ? at + 1 : -1, at - width, at + width];
      for (const next of near) if (free[next] && !seen[next]) (seen[next] = 1), queue.push(next);
    }
    return queue.length;
  };
  const needed = reachable();
  const isWhole = (cells) => {
    const seen = new Uint8Array(free.length);
    let count = 0;
    for (let i = 0; i < cells.length; i += 2) {
      const at = cells[i + 1] * width + cells[i];
      if (!seen[at]) (seen[at] = 1), (count += 1);
    }
    return count === needed;
  };
  const request = {
    id: 1, planner: "near_optimal", params: { effort: 100, turn: 2, finish: "anywhere" }, seed: 0,
    width, height: free.length / width, free, start, heading: "right", step_s: 1, turn_s: 2,
  };
  // Warmed up on four cells: the page hires its worker before it's needed.
  const small = { ...request, id: 0, width: 2, height: 2, free: Uint8Array.of(1, 1, 1, 1), start: [0, 0] };
  const reports = [];
  const result = await new Promise((resolve, reject) => {
    let began = 0;
    const end = () => resolve({ needed, reports });
    worker.onerror = (event) => reject(new Error(event.message));
    worker.onmessage = ({ data }) => {
      const after = (performance.now() - began) / 1000;
      if (data.type === "failed") reject(new Error(data.message));
      if (data.id === 0) {
        if (data.type !== "finished") return;
        began = performance.now();
        worker.postMessage({ type: "plan", request });
        setTimeout(end, 1000 * seconds);
        return;
      }
      if (!data.cells || !(reports.length > 0 || isWhole(data.cells))) return;
      reports.push({ after, cost: cost(data.cells), bound: data.proof ? Math.ceil(data.proof[1] / unit) : 0 });
      if (data.type === "finished") end();
    };
    worker.postMessage({ type: "init", module });
    worker.postMessage({ type: "plan", request: small });
  });
  worker.terminate();
  return result;
}

if (!fs.existsSync(GRIDS)) {
  console.log("    skipped: ../shared/maps/grids isn't there");
  process.exit();
}
const server = await serveFolder(DIST, { also: { "/empty.html": "" } });
const browser = await launchBrowser();
console.log(`| room | cells | first complete walk | after, s | walk after ${SOON} s | best walk after ${seconds} s | found after, s | our bound | gap |`);
console.log("|---|---|---|---|---|---|---|---|---|");
try {
  for (const name of fs.readdirSync(GRIDS).sort()) {
    if (words.length > 0 && !words.some((word) => name.includes(word))) continue;
    const page = await browser.newPage();
    await page.goto(`${server.url}empty.html`);
    const { needed, reports } = await page.evaluate(measure, { room: read(path.join(GRIDS, name)), seconds: Number(seconds), unit: UNIT });
    await page.close();
    const [first] = reports;
    if (!first) {
      console.log(`| ${path.parse(name).name} | ${needed} | no complete walk |`);
      continue;
    }
    const last = reports.at(-1);
    const best = reports.reduce((best, report) => (report.cost < best.cost ? report : best), first);
    const soon = reports.filter(({ after }) => after <= SOON).at(-1);
    const above = last.bound > 0 ? (100 * (best.cost / last.bound - 1)).toFixed(2) : "-";
    const cells = [path.parse(name).name, needed, first.cost, first.after.toFixed(2), soon?.cost ?? "", best.cost, best.after.toFixed(1), last.bound, `${above} %`];
    console.log(`| ${cells.join(" | ")} |`);
  }
} finally {
  await browser.close();
  await server.close();
}
