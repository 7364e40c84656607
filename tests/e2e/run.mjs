// Runs tests/e2e/*.test.mjs, or those whose file name contains one of the arguments: node tests/e2e/run.mjs [word...]
import fs from "node:fs";
import path from "node:path";
import { run } from "node:test";
import { spec as Spec } from "node:test/reporters";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const words = process.argv.slice(2);
const files = fs
  .readdirSync(here)
  .filter((name) => name.endsWith(".test.mjs") && (words.length === 0 || words.some((word) => name.includes(word))))
  .map((name) => path.join(here, name));

function fail(message) {
  console.error(`error: ${message}`);
  process.exit(1);
}
if (!fs.existsSync(path.join(here, "../../dist/index.html"))) fail("dist/ is missing: run ./dev build first");
if (files.length === 0) fail(`no test file matches: ${words.join(" ") || "tests/e2e/*.test.mjs"}`);

/** Where a robot's stop is due soon, its page has the machine for itself. */
const isAlone = (file) => /^connection/.test(path.basename(file));
const timeout = 300_000 * Math.max(1, Number(process.env.LINK_ROUNDS ?? 0) / 10);
let ran = 0;

/** @param {string[]} files @param {number} concurrency How many files run at a time, each with a browser of its own. */
async function runAll(files, concurrency) {
  if (files.length === 0) return;
  const report = run({ files, concurrency, timeout })
    .on("test:pass", ({ details, skip }) => {
      if (details.type !== "suite" && skip === undefined) ran += 1;
    })
    .on("test:fail", () => {
      ran += 1;
      process.exitCode = 1;
    })
    .compose(new Spec());
  for await (const text of report) process.stdout.write(text);
}

await runAll(files.filter((file) => !isAlone(file)), 2);
await runAll(files.filter(isAlone), 1);
if (ran === 0) fail("no end-to-end test ran");
