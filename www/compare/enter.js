// @ts-check
// The tab Compare with its style, workshop and modules. Loaded when it is first opened.
import init from "../../workshop.js";
import { startCompare } from "./tab.js";
import { byId } from "../dom.js";
import { style, text } from "../parts.js";
import { workshop } from "../workers.js";

/** @param {import("../main.js").App} app @param {(what: () => void) => boolean} guard */
export async function enterCompare(app, guard) {
  // Each address by itself, as the build looks for them.
  const sheets = [new URL("./compare.css", import.meta.url), new URL("./montecarlo.css", import.meta.url), new URL("./print.css", import.meta.url)];
  const [module, fragment] = await Promise.all([workshop(), text(new URL("./compare.html", import.meta.url)), ...sheets.map(({ href }) => style(href))]);
  await init({ module_or_path: module });
  byId("panel-compare").innerHTML = fragment;
  return startCompare(app, module, guard);
}
