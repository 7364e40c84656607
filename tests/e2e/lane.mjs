// One of the processes that run the test files: takes the next that no other has taken, until there is none. Files that share
// a process share its browser, and windows that are open already.
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { ends } from "./ends.mjs";

const { E2E_FILES, E2E_TAKEN, LINK_ROUNDS } = process.env;
/** What a file may take, in ms: several times what the longest needs where browsers get a third of a slow processor. */
const LIMIT = 1_800_000 * Math.max(1, Number(LINK_ROUNDS ?? 0) / 10);
for (const file of JSON.parse(E2E_FILES)) {
  const name = path.basename(file, ".test.mjs");
  try {
    fs.mkdirSync(path.join(E2E_TAKEN, name));
  } catch {
    continue;
  }
  const late = setTimeout(() => {
    console.error(`error: ${name} hasn't ended after ${LIMIT / 60_000} min`);
    process.exit(1);
  }, LIMIT);
  await import(pathToFileURL(file).href);
  // Tests run in the order in which they are declared: when this one has its turn, the file is done.
  await test(`end of ${name}`, () => clearTimeout(late));
}
for (const end of ends) await end();
