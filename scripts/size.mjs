// Prints what the page weighs when served with gzip, and fails when its first load exceeds the budget.
import fs from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { filesBelow, firstLoad } from "./references.mjs";

const BUDGET_KB = 350;
/** What the panel Learn may load besides, with the largest lesson. */
const LESSON_KB = 150;
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

const below = (folder, fits) => filesBelow(path.join(dist, folder)).filter((file) => fits.test(file));
// The template and the tour load when they are asked for.
const learn = [path.join(dist, "learn.js"), path.join(dist, "learn_bg.wasm"), path.join(dist, "lessons/index.json"), ...below("www/learn", /\.(js|css)$/)].filter((file) => !/(template|tour)\.js$/.test(file));
const lessonKb = sum(learn) + Math.max(...below("lessons", /\.md$/).map(gzipKb));
console.log(`    a lesson adds ${lessonKb.toFixed(1)} KB of ${LESSON_KB} KB gzip`);
if (lessonKb > LESSON_KB) {
  console.error(`error: a lesson exceeds its budget of ${LESSON_KB} KB gzip`);
  process.exit(1);
}
