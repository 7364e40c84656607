// One of the processes that run the test files: takes the next that no other has taken, until there is none. Files that share
// a process share its browser, and windows that are open already.
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { ends } from "./ends.mjs";

const { E2E_FILES, E2E_TAKEN } = process.env;
for (const file of JSON.parse(E2E_FILES)) {
  const name = path.basename(file, ".test.mjs");
  try {
    fs.mkdirSync(path.join(E2E_TAKEN, name));
  } catch {
    continue;
  }
  await import(pathToFileURL(file).href);
  // Tests run in the order in which they are declared: when this one has its turn, the file is done.
  await test(`end of ${name}`, () => {});
}
for (const end of ends) await end();
