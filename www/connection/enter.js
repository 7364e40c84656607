// @ts-check
// The tab Robot with its style, document and module. Loaded when it is first opened.
import init from "../../workshop.js";
import { byId } from "../dom.js";
import { style, text } from "../parts.js";
import { workshop } from "../workers.js";
import { startConnection } from "./tab.js";

/** @param {import("../main.js").App} app @param {(what: () => void) => boolean} guard */
export async function enterConnection(app, guard) {
  const sheets = [new URL("./connection.css", import.meta.url), new URL("./tools.css", import.meta.url), new URL("../senses.css", import.meta.url), new URL("../manual.css", import.meta.url)];
  const [module, fragment] = await Promise.all([workshop(), text(new URL("./connection.html", import.meta.url)), ...sheets.map(({ href }) => style(href))]);
  await init({ module_or_path: module });
  byId("panel-connection").innerHTML = fragment;
  return startConnection(app, module, guard);
}
