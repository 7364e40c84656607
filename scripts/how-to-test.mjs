// Follows docs/adding.md to the letter on a copy of the repository: every block goes into the file that its step names, and
// then the commands that are given there must succeed.
//
// node scripts/how-to-test.mjs           all of it, natively; takes minutes
// node scripts/how-to-test.mjs --page    and the page is built, type-checked and tried in a browser ($PAGE_BROWSER)
// node scripts/how-to-test.mjs --check   only that every step can be followed: it has a block, which fits its file
import { execFileSync, spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const GUIDE = "docs/adding.md";
const ROOT = path.join(path.dirname(fileURLToPath(import.meta.url)), "..");
/** Copies are kept, so that cargo only compiles what has changed since. */
const COPY = path.join(ROOT, "target/how-to");
// Not the repository's own: cargo tells crates at the same place of two copies apart by their dates alone.
const TARGET = path.join(ROOT, "target/how-to-target");
const WALKS = "tests/golden/walks.txt";

const read = (file) => fs.readFileSync(path.join(ROOT, file), "utf8");

/** The guide's blocks, each with the file that its step names, its commands, and what can't be followed. */
function parse(guide) {
  const [blocks, commands, problems] = [[], [], []];
  let [file, block, step, last] = ["", null, null, 0];
  const endStep = () => {
    if (step && !step.hasBlock && !/\boptional\b/i.test(step.text)) problems.push(`${step.at}: step ${last} has no block to follow and isn't called optional`);
    step = null;
  };
  guide.split("\n").forEach((line, index) => {
    const at = `${GUIDE}:${index + 1}`;
    const fence = /^( *)```(\w*)$/.exec(line);
    const number = /^(\d+)\. /.exec(line)?.[1];
    if (block && fence) {
      if (block.language === "sh") commands.push(...block.lines);
      else blocks.push(block);
      block = null;
    } else if (block) {
      block.lines.push(line.slice(block.indent));
    } else if (fence) {
      block = { file, language: fence[2], indent: fence[1].length, lines: [], at };
      if (step) step.hasBlock = true;
    } else if (number) {
      endStep();
      if (Number(number) !== last + 1) problems.push(`${at}: step ${number} follows step ${last}`);
      last = Number(number);
      file = /^\d+\. +\*\*`([^`]+)`\*\*/.exec(line)?.[1] ?? "";
      step = { text: line, hasBlock: false, at };
    } else if (/^\S/.test(line)) {
      // What isn't indented belongs to no step.
      endStep();
      if (line.startsWith("#")) [file, last] = ["", 0];
    } else if (step) {
      step.text += line;
    }
  });
  endStep();
  if (block || !guide.endsWith(".\n")) problems.push(`${GUIDE}: it ends in the middle of a block or sentence`);
  return { blocks, commands: [...new Set(commands)], problems };
}

/** The text with one hunk of a difference in it. */
function patched(text, hunk, what) {
  const part = (sign) => hunk.filter((line) => line[0] !== sign).map((line) => line.slice(1)).join("\n");
  const [old, next] = [`\n${part("+")}\n`, `\n${part("-")}\n`];
  const pieces = `\n${text}`.split(old);
  if (pieces.length !== 2) throw `${what} stands ${pieces.length - 1} times there, not once:\n${part("+")}`;
  return pieces.join(next).slice(1);
}

/** All files that the blocks change, with what is in them afterwards; what doesn't fit is added to the problems. */
function apply(blocks, problems) {
  const files = new Map();
  for (const { file, language, lines, at } of blocks) {
    const known = files.get(file) ?? (file && fs.existsSync(path.join(ROOT, file)) ? read(file) : undefined);
    const what = `${at}: what goes into ${file || "no file"}`;
    try {
      if (!file || (known === undefined) === (language === "diff")) throw `${what}: it is ${known === undefined ? "missing" : "there already"}`;
      const hunks = lines.join("\n").split("\n@@\n").map((hunk) => hunk.split("\n"));
      files.set(file, language === "diff" ? hunks.reduce((text, hunk) => patched(text, hunk, what), known) : `${lines.join("\n")}\n`);
    } catch (problem) {
      problems.push(problem);
    }
  }
  return files;
}

/** Makes the copy the same as the repository with these files in it; what is the same already isn't touched. */
function copy(files) {
  const list = execFileSync("git", ["ls-files", "-co", "--exclude-standard"], { cwd: ROOT, encoding: "utf8" }).trim().split("\n");
  const wanted = new Set([...list.filter((file) => fs.existsSync(path.join(ROOT, file))), ...files.keys()]);
  for (const file of wanted) {
    const [from, to] = [path.join(ROOT, file), path.join(COPY, file)];
    const bytes = files.has(file) ? Buffer.from(files.get(file)) : fs.readFileSync(from);
    if (fs.existsSync(to) && fs.readFileSync(to).equals(bytes)) continue;
    fs.mkdirSync(path.dirname(to), { recursive: true });
    fs.writeFileSync(to, bytes, { mode: fs.existsSync(from) ? fs.statSync(from).mode : 0o644 });
  }
  for (const entry of fs.readdirSync(COPY, { recursive: true, withFileTypes: true })) {
    const file = path.relative(COPY, path.join(entry.parentPath, entry.name));
    if (entry.isFile() && !wanted.has(file) && !/^(dist|target)\//.test(file)) fs.rmSync(path.join(COPY, file));
  }
  const modules = path.join(COPY, "node_modules");
  if (!fs.existsSync(modules)) fs.symlinkSync(fs.realpathSync(path.join(ROOT, "node_modules")), modules);
}

function run(command) {
  console.log(`$ ${command}`);
  const { status } = spawnSync("bash", ["-c", command], { cwd: COPY, stdio: "inherit", env: { ...process.env, CARGO_TARGET_DIR: TARGET } });
  if (status === 0) return;
  console.error(`error: the last command failed in ${COPY}, a copy changed as ${GUIDE} says`);
  process.exit(1);
}

const { blocks, commands, problems } = parse(read(GUIDE));
const files = apply(blocks, problems);
for (const problem of problems) console.error(problem);
if (problems.length > 0) process.exit(1);
console.log(`${blocks.length} blocks of ${GUIDE} fit.`);
if (!process.argv.includes("--check")) {
  copy(files);
  ["cargo fmt --all --check", "cargo check --quiet -p robovac-playground --bins", ...commands].forEach(run);
  const walks = fs.readFileSync(path.join(COPY, WALKS), "utf8");
  const changed = read(WALKS).split("\n").filter((line) => !walks.includes(line));
  if (changed.length > 0) throw new Error(`${WALKS} was to get new lines only, but these have changed:\n${changed.join("\n")}`);
  if (process.argv.includes("--page")) ["trunk build --offline=true", "tsc --project .", "node tests/e2e/run.mjs yours delivery"].forEach(run);
  console.log("Every step works.");
}
