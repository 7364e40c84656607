// Bundles the page's own modules that opening it loads into www/main.js: one file is fetched sooner and packs smaller.
// What is loaded later imports them from there, so that no module is there twice.
import fs from "node:fs";
import path from "node:path";
import { build } from "esbuild";
import { filesBelow, firstLoad, referencesOf, rewriteReferences } from "./references.mjs";

/** import first, { a, b as c } from "./x.js" */
const IMPORT = /^import (?:\w+, )?\{([^}]*)\} from "(\.{1,2}\/[^"]+)";$/gm;

/** @param {string} from A folder. @param {string} to A file. */
const reference = (from, to) => path.relative(from, to).replace(/^(?!\.)/, "./");

/** Bundles in the finished page in `folder`, whose references have no versions yet. @param {string} folder */
export async function bundleFirstLoad(folder) {
  const www = path.join(folder, "www");
  const main = path.join(www, "main.js");
  const ours = filesBelow(www).filter((file) => file.endsWith(".js"));
  const bundled = new Set(firstLoad(main).filter((file) => ours.includes(file)));
  // Workers and the page of benchmarks have modules of their own.
  const apart = [path.join(www, "bench.js"), ...ours.flatMap((file) => referencesOf(file, "url"))].filter((file) => ours.includes(file));
  const elsewhere = new Set(apart.flatMap(firstLoad));

  /** What is loaded later imports, by where it is. @type {Map<string, Set<string>>} */
  const wanted = new Map();
  for (const file of ours.filter((file) => !bundled.has(file) && !elsewhere.has(file))) {
    const text = fs.readFileSync(file, "utf8").replace(IMPORT, (whole, names, from) => {
      const target = path.resolve(path.dirname(file), from);
      if (!bundled.has(target)) return whole;
      const list = wanted.get(target) ?? new Set();
      wanted.set(target, list);
      for (const name of names.split(",")) list.add(name.trim().split(" as ")[0]);
      return `import {${names}} from "${reference(path.dirname(file), main)}";`;
    });
    fs.writeFileSync(file, text);
  }

  const exported = [...wanted].map(([file, names]) => `export { ${[...names].join(", ")} } from "${reference(www, file)}";\n`);
  const { outputFiles } = await build({
    stdin: { contents: `import "./main.js";\n${exported.join("")}`, resolveDir: www },
    bundle: true,
    format: "esm",
    target: "es2022",
    write: false,
    plugins: [
      {
        name: "the rest stays where it is",
        setup(build) {
          build.onResolve({ filter: /^\./ }, ({ path: to, resolveDir }) => {
            const target = path.resolve(resolveDir, to);
            return bundled.has(target) ? { path: target } : { path: reference(www, target), external: true };
          });
          // Addresses are now relative to www/.
          build.onLoad({ filter: /\.js$/ }, ({ path: file }) => ({
            contents: rewriteReferences(file, (target, to, kind) => (kind === "url" ? reference(www, target) : to)),
          }));
        },
      },
    ],
  });
  fs.writeFileSync(main, outputFiles[0].text);
  refuseTwice(main, bundled);
  for (const file of bundled) if (file !== main && !elsewhere.has(file)) fs.rmSync(file);
}

/** Fails if a module that the page loads later still refers to one of those in the bundle. @param {string} main @param {Set<string>} bundled */
function refuseTwice(main, bundled) {
  const reached = new Set([main]);
  for (const file of reached) {
    // Comments name the types of modules like imports.
    const code = fs.readFileSync(file, "utf8").replace(/\/\*[^]*?\*\//g, "");
    for (const [, to] of code.matchAll(/\b(?:from|import\(?)\s*"(\.[^"]+\.js)"/g)) {
      const target = path.resolve(path.dirname(file), to);
      if (target !== main && bundled.has(target)) throw new Error(`${file} refers to ${to}, which is in the bundle: import it by name, and not in a module that a worker has, too`);
      reached.add(target);
    }
  }
}
