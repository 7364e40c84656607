// Which files of the page refer to which: the one place that knows how a page names its parts.
import fs from "node:fs";
import path from "node:path";

// Each pattern: what stands before the relative address, the address, what stands behind it. A version that
// fingerprint.mjs has appended to the address is skipped.
const SCRIPT_PATTERNS = {
  // import ... from "./x.js", export ... from "./x.js", import "./x.js"
  static: /(\b(?:from|import)\s*["'])(\.{1,2}\/[^"'?#]+)(?:\?v=\w+)?(["'])/g,
  // import("./x.js")
  lazy: /(\bimport\(\s*["'])(\.{1,2}\/[^"'?#]+)(?:\?v=\w+)?(["'])/g,
  // new URL("./x", import.meta.url), the way to a worker or to the wasm module
  url: /(\bnew URL\(\s*["'])([^"'?#:]+)(?:\?v=\w+)?(["']\s*,\s*import\.meta\.url)/g,
};
const PATTERNS = {
  ".html": { static: /(\b(?:src|href)=["']?)([^"'?#:>\s]+\.(?:js|css|wasm|png|svg|ico|webmanifest))(?:\?v=\w+)?(["'>\s])/g },
  ".css": { static: /(\burl\(\s*["']?)([^"'?#:)]+)(?:\?v=\w+)?(["']?\s*\))/g },
  ".js": SCRIPT_PATTERNS,
};

/** A service worker's address is its identity, so it never gets a version. */
const UNVERSIONED = new Set(["sw.js"]);

/** Rewrites every reference in `file` to another file of the page: `replace(target, reference, kind)` gives the new one. */
export function rewriteReferences(file, replace) {
  let text = fs.readFileSync(file, "utf8");
  for (const [kind, pattern] of Object.entries(PATTERNS[path.extname(file)] ?? {})) {
    text = text.replace(pattern, (whole, before, reference, after) => {
      const target = path.resolve(path.dirname(file), reference);
      const isPart = !UNVERSIONED.has(path.basename(target)) && fs.statSync(target, { throwIfNoEntry: false })?.isFile();
      return isPart ? before + replace(target, reference, kind) + after : whole;
    });
  }
  return text;
}

/** The files to which `file` refers in the way `kind`. */
export function referencesOf(file, kind) {
  const found = [];
  rewriteReferences(file, (target, reference, way) => {
    if (way === kind) found.push(target);
    return reference;
  });
  return found;
}

/** All files that opening `entry` loads, `entry` included; a lazy import() does not count. */
export function firstLoad(entry) {
  const seen = new Set();
  const visit = (file) => {
    if (seen.has(file)) return;
    seen.add(file);
    rewriteReferences(file, (target, reference, kind) => {
      if (kind !== "lazy") visit(target);
      return reference;
    });
  };
  visit(path.resolve(entry));
  return [...seen];
}

/** Every file below `folder`, in a fixed order. */
export function filesBelow(folder) {
  return fs
    .readdirSync(folder, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => {
      const file = path.join(folder, entry.name);
      return entry.isDirectory() ? filesBelow(file) : [file];
    });
}
