// Which test files passed, and with what: one whose page, tools and tests are the same to the byte has nothing new to say.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { filesBelow } from "../../scripts/references.mjs";
import { DIST, ROOT } from "./browser.mjs";

const LIST = path.join(ROOT, "target/e2e-passed.json");
const git = (...words) => execFileSync("git", words, { cwd: ROOT, encoding: "utf8" });
const version = (program) => (program ? execFileSync(program, ["--version"], { encoding: "utf8" }) : "");

/** A digest of all that decides how tests end, but for their own text: page, native program, helpers, browsers. */
function circumstances() {
  const { ROBOVAC, CHROMIUM, PAGE_BROWSER, FIREFOX } = process.env;
  // The sources of Rust are in dist/ and in the native program.
  const sources = git("ls-files", "-co", "--exclude-standard", "-z", "--", ".", ":!crates", ":!src", ":!docs", ":!tests/e2e/*.test.mjs");
  const files = [...sources.split("\0").filter(Boolean).map((name) => path.join(ROOT, name)), ...filesBelow(DIST).sort(), ROBOVAC];
  const hash = createHash("sha256");
  for (const file of files.filter((file) => file && fs.existsSync(file))) hash.update(file).update("\0").update(fs.readFileSync(file));
  for (const program of [process.execPath, CHROMIUM, PAGE_BROWSER, FIREFOX]) hash.update(version(program));
  return hash.digest("hex");
}

/** The test files that passed as they are now. */
export class Passed {
  #around = circumstances();
  /** @type {Record<string, string>} */
  #known = fs.existsSync(LIST) ? JSON.parse(fs.readFileSync(LIST, "utf8")) : {};

  #digest(file) {
    return createHash("sha256").update(this.#around).update(fs.readFileSync(file)).digest("hex");
  }
  /** @param {string} file */
  has(file) {
    return this.#known[path.basename(file)] === this.#digest(file);
  }
  /** @param {string} file */
  add(file) {
    this.#known[path.basename(file)] = this.#digest(file);
    fs.mkdirSync(path.dirname(LIST), { recursive: true });
    fs.writeFileSync(LIST, JSON.stringify(this.#known));
  }
}
