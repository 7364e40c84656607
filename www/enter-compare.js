// @ts-check
// The place Compare with all that it needs: style, workshop, modules. Loaded when one first goes there.
import init from "../compare.js";
import { startCompare } from "./compare.js";
import { style } from "./sheet.js";
import { compile } from "./wasm.js";
import { workshop } from "./workers.js";

/** @param {import("./main.js").App} app @param {(what: () => void) => boolean} guard */
export async function enterCompare(app, guard) {
  // Each address by itself, as the build looks for them.
  const sheets = [new URL("./compare.css", import.meta.url), new URL("./montecarlo.css", import.meta.url)];
  const own = compile(new URL("../compare_bg.wasm", import.meta.url)).then((compiled) => init({ module_or_path: compiled }));
  const [module] = await Promise.all([workshop(), own, ...sheets.map(({ href }) => style(href))]);
  return startCompare(app, module, guard);
}
