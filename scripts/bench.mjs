// Runs www/bench.html of the built page in headless Chromium and compares it with the same work done natively.
//
// Both sides report a list of { "name": string, "ms": number }, or an object that has it as "results":
// the page as the promise window.benchResult, the native program by `robovac bench --json`.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { DIST, launchBrowser, serveFolder } from "../tests/e2e/browser.mjs";

/** @returns {Map<string, number>} milliseconds by name */
function times(report) {
  const list = Array.isArray(report) ? report : report.results;
  return new Map(list.map(({ name, ms }) => [name, ms]));
}

function native() {
  const command = ["run", "--release", "--locked", "--quiet", "--bin", "robovac", "--", "bench", "--json"];
  const { status, stdout } = spawnSync("cargo", command, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
  if (status === 0) return times(JSON.parse(stdout));
  console.log("    `robovac bench --json` failed, so there is nothing to compare with");
  return new Map();
}

async function inBrowser() {
  const server = await serveFolder(DIST);
  const browser = await launchBrowser();
  try {
    const page = await browser.newPage();
    page.on("pageerror", (error) => console.error(`    page: ${error}`));
    await page.goto(`${server.url}www/bench.html`);
    await page.waitForFunction(() => "benchResult" in window, null, { timeout: 600_000 });
    return times(await page.evaluate(() => window.benchResult));
  } finally {
    await browser.close();
    await server.close();
  }
}

if (!fs.existsSync(path.join(DIST, "www/bench.html"))) {
  console.log("    skipped: there is no www/bench.html");
  process.exit();
}
const nativeMs = native();
const wasmMs = await inBrowser();
const columns = (name, ...cells) => `    ${name.padEnd(48)}${cells.map((cell) => cell.padStart(14)).join("")}`;
console.log(columns("", "native ms", "wasm ms", "wasm / native"));
for (const [name, ms] of wasmMs) {
  const reference = nativeMs.get(name);
  console.log(columns(name, reference?.toFixed(2) ?? "-", ms.toFixed(2), reference ? (ms / reference).toFixed(2) : "-"));
}
const ratios = [...wasmMs].filter(([name]) => nativeMs.get(name) > 0).map(([name, ms]) => ms / nativeMs.get(name));
if (ratios.length > 0) {
  const mean = Math.exp(ratios.reduce((sum, ratio) => sum + Math.log(ratio), 0) / ratios.length);
  console.log(`    geometric mean of wasm / native: ${mean.toFixed(2)}`);
}
