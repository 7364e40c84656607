// Called by scripts/modules: bundles what the page carries besides our own modules into $TRUNK_STAGING_DIR.
//
// codemirror.js: the editor of the tab Program, hyparquet.js: the reader of a study's results in Compare, ES modules. sandbox.js: all that runs inside the sandbox, one classic script, because nothing
// can be fetched there. micropython.wasm goes beside them.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { build } from "esbuild";
import { filesBelow } from "./references.mjs";

const out = process.env.TRUNK_STAGING_DIR;
if (!out) throw new Error("TRUNK_STAGING_DIR is set by trunk");
const root = path.resolve(import.meta.dirname, "..");
const options = { bundle: true, minify: true, target: "es2022", logLevel: "warning", absWorkingDir: root, legalComments: "none" };

for (const name of ["codemirror", "hyparquet"]) {
  await build({ ...options, entryPoints: [`scripts/bundles/${name}.js`], format: "esm", outfile: path.join(out, `${name}.js`) });
  // For the type check: see tsconfig.json.
  fs.writeFileSync(path.join(out, `${name}.d.ts`), `export * from "../../scripts/bundles/${name}.js";\n`);
}

/** Modules of programs/python that only the command line needs. */
const NATIVE = ["__main__.py", "frames.py", "native.py"];

/** Texts by their paths below programs/python. */
function pythonFiles() {
  const folder = path.join(root, "programs/python");
  const files = filesBelow(folder).filter((file) => file.endsWith(".py") && !NATIVE.includes(path.basename(file)));
  return Object.fromEntries(files.map((file) => [path.relative(folder, file), fs.readFileSync(file, "utf8")]));
}

/** Our WebAssembly is bound to a script in the folder of the page. */
const bound = {
  name: "bound",
  setup(build) {
    build.onResolve({ filter: /^(\.\.\/)+program\.js$/ }, () => ({ path: path.join(out, "program.js") }));
    // The interface's package: it goes in as text.
    build.onResolve({ filter: /^python-files$/ }, () => ({ path: "python-files", namespace: "texts" }));
    build.onLoad({ filter: /.*/, namespace: "texts" }, () => ({ contents: JSON.stringify(pythonFiles()), loader: "json" }));
  },
};
await build({
  ...options,
  entryPoints: ["www/program/inside/worker.js"],
  format: "iife",
  outfile: path.join(out, "sandbox.js"),
  plugins: [bound],
  // Addresses mean nothing in there: bytes are handed in.
  define: { "import.meta.url": '"about:blank"' },
});
execFileSync("node", ["scripts/micropython.mjs", path.join(out, "micropython.wasm")], { cwd: root, stdio: "inherit" });
