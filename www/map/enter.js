// @ts-check
// The tab Map with its style, document and module. Loaded when it is first opened.
import init from "../../workshop.js";
import { byId } from "../dom.js";
import { style, text } from "../parts.js";
import { workshop } from "../workers.js";
import { startMap } from "./tab.js";

/** @param {import("../main.js").App} app */
export async function enterMap(app) {
  const [module, fragment] = await Promise.all([workshop(), text(new URL("./map.html", import.meta.url)), style(new URL("../shared/task.css", import.meta.url).href), style(new URL("./map.css", import.meta.url).href)]);
  await init({ module_or_path: module });
  byId("panel-map").innerHTML = fragment;
  return startMap(app);
}
