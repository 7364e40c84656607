// Prints what the page weighs when served with gzip, and fails when its first load exceeds the budget.
import fs from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { filesBelow, firstLoad } from "./references.mjs";

const BUDGET_KB = 350;
const dist = path.resolve("dist");
const gzipKb = (file) => gzipSync(fs.readFileSync(file), { level: 9 }).length / 1024;
const sum = (files) => files.map(gzipKb).reduce((total, size) => total + size, 0);

const first = firstLoad(path.join(dist, "index.html"));
for (const file of first) console.log(`    ${gzipKb(file).toFixed(1).padStart(7)} KB  ${path.relative(dist, file)}`);
const firstKb = sum(first);
console.log(`    first load ${firstKb.toFixed(1)} KB of ${BUDGET_KB} KB gzip; whole dist/ ${sum(filesBelow(dist)).toFixed(1)} KB`);

if (!first.some((file) => file.endsWith(".wasm"))) {
  console.error("error: the first load does not reach the wasm module; the page imports it in a way that scripts/references.mjs does not know");
  process.exit(1);
}
if (firstKb > BUDGET_KB) {
  console.error(`error: the first load exceeds its budget of ${BUDGET_KB} KB gzip`);
  process.exit(1);
}
