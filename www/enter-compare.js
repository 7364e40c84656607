// @ts-check
// The place Compare with all that it needs: style, workshop, modules. Loaded when one first goes there.
import { startCompare } from "./compare.js";
import { workshop } from "./workers.js";

/** @type {Promise<void> | undefined} */
let styled;

/** Its style sheet, in the place among the others that it would have in the page's head. */
function style() {
  styled ??= new Promise((resolve, reject) => {
    const sheet = document.createElement("link");
    sheet.rel = "stylesheet";
    sheet.href = new URL("./compare.css", import.meta.url).href;
    sheet.onload = () => resolve();
    sheet.onerror = () => {
      sheet.remove();
      styled = undefined;
      reject(new Error("its style could not be loaded"));
    };
    const small = document.querySelector('link[href*="small.css"]');
    document.head.insertBefore(sheet, small);
  });
  return styled;
}

/** @param {import("./main.js").App} app @param {(what: () => void) => boolean} guard */
export async function enterCompare(app, guard) {
  const [module] = await Promise.all([workshop(), style()]);
  return startCompare(app, module, guard);
}
