// Runs after every trunk build, on the finished page before it is published as dist/.
// Appends ?v=<digest of the whole build> to each reference between the page's files. A browser then never mixes files of
// two builds, and because all of them get the same version, page and worker still share one address per module. For a release,
// scripts and style sheets are packed.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { minify } from "terser";
import { bundleFirstLoad } from "./first-load.mjs";
import { writeWorker } from "./offline.mjs";
import { filesBelow, rewriteReferences } from "./references.mjs";

const page = path.resolve(process.env.TRUNK_STAGING_DIR ?? "dist");

// Declarations are for the type check, not for the web. Those of www/ are found where they are.
const types = path.resolve("target/types");
fs.mkdirSync(types, { recursive: true });
for (const file of filesBelow(page).filter((name) => name.endsWith(".d.ts"))) {
  if (path.dirname(file) === page) fs.copyFileSync(file, path.join(types, path.basename(file)));
  fs.rmSync(file);
}

// While working on it, one wants to see the modules as they are written, and soon.
const isRelease = process.env.TRUNK_PROFILE === "release";
if (isRelease) await bundleFirstLoad(page);

const digest = createHash("sha256");
for (const file of filesBelow(page)) {
  digest.update(path.relative(page, file)).update("\0").update(fs.readFileSync(file));
}
const version = digest.digest("hex").slice(0, 12);

// trunk leaves its own link in the page when it injects no script.
const index = path.join(page, "index.html");
let document = fs.readFileSync(index, "utf8").replace(/\s*<link data-trunk[^>]*>/g, "");
// Whoever shows a preview of a link needs the whole address of its picture.
const { PAGE_URL, SOURCE_URL } = process.env;
// Style sheets that follow one another become one, which packs smaller; small.css stays, as others are put before it.
document = document.replace(/(?:<link rel="stylesheet" href="(?!www\/small\.css)[^"]+" \/>\s*){2,}/g, (links) => {
  const [first, ...others] = [...links.matchAll(/href="([^"]+)"/g)].map(([, name]) => path.join(page, name));
  for (const other of others) {
    fs.appendFileSync(first, fs.readFileSync(other));
    fs.rmSync(other);
  }
  return `<link rel="stylesheet" href="${path.relative(page, first)}" />\n`;
});
if (PAGE_URL) {
  const picture = '<meta property="og:image" content="';
  document = document.replace(`${picture}screenshot.png"`, `<meta property="og:url" content="${new URL(PAGE_URL)}" />\n    ${picture}${new URL("screenshot.png", PAGE_URL)}"`);
}
fs.writeFileSync(index, document);

// As text, which browsers show.
for (const licence of ["LICENSE-MIT", "LICENSE-APACHE"]) fs.copyFileSync(licence, path.join(page, `${licence}.txt`));

// What the page tells about itself.
const release = /^version = "(.*)"$/m.exec(fs.readFileSync("Cargo.toml", "utf8"))?.[1] ?? "";
const about = path.join(page, "www/help.html");
const linkTo = (/** @type {string} */ address, more = "") => `<a href="${address}" ${more}>Source code</a> under`;
/** Beside the page, if it can be got nowhere else. */
const ARCHIVE = "source.tar.gz";

function sourceLink() {
  if (SOURCE_URL) return linkTo(new URL(SOURCE_URL).href, 'target="_blank" rel="noopener"');
  const none = "Free software under";
  if (!isRelease) return none;
  try {
    execFileSync("git", ["archive", "--prefix=robovac-playground/", `--output=${path.join(page, ARCHIVE)}`, "HEAD"], { stdio: "ignore" });
  } catch {
    // Not a git repository.
    return none;
  }
  return linkTo(ARCHIVE, "download");
}
const source = sourceLink();
fs.writeFileSync(about, fs.readFileSync(about, "utf8").replace("@RELEASE@", release).replace("@BUILD@", version).replace("@SOURCE@", source));

/** Comments and indentation are for whoever reads the sources. */
const HTML_SPARE = /<!--(?:(?!-->)[^])*-->\n*|^[ \t]+/gm;
const CSS_SPARE = /\/\*(?:(?!\*\/)[^])*\*\/\n*|^[ \t]+|^\n/gm;

/** @param {string} file @param {string} text */
async function packed(file, text) {
  if (file.endsWith(".js")) return (await minify(text, { module: true, ecma: 2022, compress: { passes: 3 } })).code;
  return text.replace(file.endsWith(".css") ? CSS_SPARE : HTML_SPARE, "");
}

// Programs are shown as they were written.
const isWritten = (name) => name.startsWith(path.join(page, "programs"));

for (const file of filesBelow(page).filter((name) => /\.(html|js|css)$/.test(name) && !isWritten(name))) {
  const text = rewriteReferences(file, (_target, reference) => `${reference}?v=${version}`);
  fs.writeFileSync(file, isRelease ? await packed(file, text) : text);
}

// Last, as it knows all files.
await writeWorker(page, version);
