// Runs tests/e2e/*.test.mjs, or those whose file name contains one of the arguments: node tests/e2e/run.mjs [word...]
// KEEP_PASSED=1, as ./dev test has it, leaves out those that passed with the same page, tools and tests, to the byte; with ALL=1
// all run.
// ONLY="the page hangs" runs only tests whose name contains that.
// SLOWEST=20 lists the 20 tests that took longest, PICTURES=1 has all pictures taken that tests offer, in target/e2e.
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { run } from "node:test";
import { spec as Spec } from "node:test/reporters";
import { fileURLToPath } from "node:url";
import { Passed } from "./passed.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
const words = process.argv.slice(2);
/** Those that take long begin first, so that no process is left with one at the end. */
const LONG = ["webkit", "lessons", "rides", "firefox", "choices", "settings", "compare", "map", "connection-virtual", "floor-plan", "bench", "near-optimal", "connection-stop", "connection-window", "connection-bridge", "connection-fake", "connection-usb"];
const rank = (name) => (LONG.indexOf(name.replace(".test.mjs", "")) + LONG.length + 1) % (LONG.length + 1);
const all = fs
  .readdirSync(here)
  .filter((name) => name.endsWith(".test.mjs") && (words.length === 0 || words.some((word) => name.includes(word))))
  .sort((a, b) => rank(a) - rank(b))
  .map((name) => path.join(here, name));

function fail(message) {
  console.error(`error: ${message}`);
  process.exit(1);
}
if (!fs.existsSync(path.join(here, "../../dist/index.html"))) fail("dist/ is missing: run ./dev build first");
if (all.length === 0) fail(`no test file matches: ${words.join(" ") || "tests/e2e/*.test.mjs"}`);

const passed = process.env.KEEP_PASSED && !process.env.ALL && !process.env.ONLY ? new Passed() : undefined;
const files = all.filter((file) => !passed?.has(file));
if (files.length < all.length) console.log(`${all.length - files.length} of ${all.length} files passed before with all that they test unchanged, and are left out; ALL=1 runs them`);

/** Where a robot's stop is due soon, the machine has nothing heavy to do besides. */
const isUrgent = (file) => /^connection(-bridge|-fake|-motors|-program|-serial|-stop|-usb|-window)?\.test/.test(path.basename(file));
/**
 * That a robot stops in time is measured there, or it rides as long as a page may not be busy: beside nothing else. Another browser's
 * start delays a stop by 0.1 s.
 */
const isStop = (file) => /^connection-(bridge|motors|stop|window)\.test/.test(path.basename(file));
const isEngine = (/** @type {string} */ file) => /^(firefox|webkit)\.test/.test(path.basename(file));
/** That a robot stops in time has to hold at the first try. */
const hasOneTry = (file) => /^connection-(bridge|stop)\.test/.test(path.basename(file));
/** Of each file, the tests with these names; the ends of files are always among them. @param {(string | RegExp)[]} [names] */
const only = (names) => names && [...names, /^end of /];
const asked = only(process.env.ONLY ? [process.env.ONLY] : undefined);
/** Those that failed and those that passed, by their file. @type {Map<string, Set<string>>} */
const [failures, passes] = [new Map(), new Map()];
const add = (/** @type {Map<string, Set<string>>} */ lists, /** @type {string} */ file, /** @type {string} */ name) => lists.set(file, (lists.get(file) ?? new Set()).add(name));
/** How long every test took that has run, in ms, and what it is called. */
const took = [];

function note({ name, file, details, skip }) {
  if (details.type === "suite" || skip !== undefined || name.startsWith("end of ")) return;
  took.push([details.duration_ms, `${path.basename(file ?? "", ".test.mjs")}: ${name}`]);
}

/** The file that a test belongs to. Those of other engines are declared by one suite, and begin with the engine's name. */
function fileOf({ file, name }, files) {
  const engine = `${name.split(":")[0].toLowerCase()}.test.mjs`;
  return files.find((known) => known === file || (/engines/.test(file ?? "") && path.basename(known) === engine));
}

/**
 * @param {string[]} files
 * @param {number} lanes How many run at a time, each in a process with a browser of its own.
 * @param {(string | RegExp)[]} [testNamePatterns]
 * @returns {Promise<Set<string>>} The files in which a test failed.
 */
async function runAll(files, lanes, testNamePatterns = asked) {
  const failed = new Set();
  if (files.length === 0) return failed;
  const taken = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-e2e-"));
  Object.assign(process.env, { E2E_FILES: JSON.stringify(files), E2E_TAKEN: taken });
  const report = run({ files: Array(Math.min(lanes, files.length)).fill(path.join(here, "lane.mjs")), concurrency: lanes, testNamePatterns })
    .on("test:pass", (test) => {
      note(test);
      const file = fileOf(test, files);
      if (file && test.skip === undefined) add(passes, file, test.name);
    })
    .on("test:fail", (test) => {
      note(test);
      const file = fileOf(test, files);
      // A lane fails with its tests, and by itself when its process ends.
      if (file) {
        failed.add(file);
        add(failures, file, test.name);
      }
      else if (test.details.error.failureType !== "subtestsFailed") process.exitCode = 1;
    })
    .compose(new Spec());
  for await (const text of report) process.stdout.write(text);
  fs.rmSync(taken, { recursive: true });
  return failed;
}

const urgent = files.filter(isUrgent);
const failed = [...(await runAll(files.filter((file) => !isUrgent(file)), 3))];
// They wait for most of their time.
failed.push(...(await runAll(urgent.filter((file) => !isStop(file)), 3)));
failed.push(...(await runAll(urgent.filter(isStop), 1)));
// A process that ended by itself says nothing of any file.
if (process.exitCode === undefined) for (const file of files.filter((file) => !failed.includes(file))) passed?.add(file);
// A busy machine may have made it fail; what fails alone, too, is broken.
const again = failed.filter((file) => !hasOneTry(file));
if (again.length > 0) console.log(`\nOnce more, one at a time: ${again.map((file) => path.basename(file)).join(" ")}`);
// Names of other engines' tests are within those of suites.
const [suites, plain] = [again.filter(isEngine), again.filter((file) => !isEngine(file))];
const exactly = (/** @type {string} */ name) => new RegExp(`^${name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}$`);
const failuresOf = (/** @type {string} */ file) => [...(failures.get(file) ?? [])];
const names = plain.flatMap((file) => failuresOf(file).map(exactly));
const broken = [...failed.filter(hasOneTry), ...(await runAll(suites, 1)), ...(await runAll(plain, 1, asked ?? only(names)))];
// Whose name is another one now would have been left out.
broken.push(...plain.filter((file) => !broken.includes(file) && failuresOf(file).some((name) => !passes.get(file)?.has(name))));
if (broken.length > 0) process.exitCode = 1;
const unreliable = failed.filter((file) => !broken.includes(file));
if (unreliable.length > 0) {
  console.log(`\nUnreliable: failed, then passed: ${unreliable.map((file) => path.basename(file)).join(" ")}`);
}
if (took.length === 0 && files.length > 0) fail("no end-to-end test ran");
const slowest = took.sort(([a], [b]) => b - a).slice(0, Number(process.env.SLOWEST ?? 0));
for (const [ms, what] of slowest) console.log(`${(ms / 1000).toFixed(1).padStart(6)} s  ${what}`);
