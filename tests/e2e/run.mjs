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

let ran = 0;
// One file at a time: browsers that compete for the processor make timings in tests meaningless.
run({ files, concurrency: 1, timeout: 300_000 * Math.max(1, Number(process.env.LINK_ROUNDS ?? 0) / 10) })
  .on("test:pass", ({ details, skip }) => {
    if (details.type !== "suite" && skip === undefined) ran += 1;
  })
  .on("test:fail", () => {
    ran += 1;
    process.exitCode = 1;
  })
  .on("end", () => {
    if (ran === 0) fail("no end-to-end test ran");
  })
  .compose(new Spec())
  .pipe(process.stdout);
