// @ts-check
// The place Compare with all that it needs: style, workshop, modules. Loaded when one first goes there.
import init from "../compare.js";
import { startCompare } from "./compare.js";
import { compile } from "./wasm.js";
import { workshop } from "./workers.js";

/** Those that are loaded or on their way. @type {Map<string, Promise<void>>} */
const styled = new Map();

/** A style sheet of it, in the place among the others that it would have in the page's head. @param {string} address */
function style(address) {
  const sheet = document.createElement("link");
  const loaded = styled.get(address) ?? new Promise((/** @type {(done: void) => void} */ resolve, reject) => {
    sheet.rel = "stylesheet";
    sheet.href = address;
    sheet.onload = () => resolve();
    sheet.onerror = () => {
      sheet.remove();
      styled.delete(address);
      reject(new Error("its style could not be loaded"));
    };
    const small = document.querySelector('link[href*="small.css"]');
    document.head.insertBefore(sheet, small);
  });
  styled.set(address, loaded);
  return loaded;
}

/** @param {import("./main.js").App} app @param {(what: () => void) => boolean} guard */
export async function enterCompare(app, guard) {
  // Each address by itself, as the build looks for them.
  const sheets = [new URL("./compare.css", import.meta.url), new URL("./montecarlo.css", import.meta.url)];
  const own = compile(new URL("../compare_bg.wasm", import.meta.url)).then((compiled) => init({ module_or_path: compiled }));
  const [module] = await Promise.all([workshop(), own, ...sheets.map(({ href }) => style(href))]);
  return startCompare(app, module, guard);
}
