// @ts-check
// The tab Floor plan with its style, document and module. Loaded when it is first opened or brings a file.
import { byId } from "../dom.js";
import { style, text } from "../parts.js";
import { compile } from "../wasm.js";
import { startFloorPlan } from "./tab.js";

/** @param {import("../main.js").App} app */
export async function enterFloorPlan(app) {
  const compiled = compile(new URL("../../floor_plan_bg.wasm", import.meta.url));
  const [module, fragment] = await Promise.all([compiled, text(new URL("./floor-plan.html", import.meta.url)), style(new URL("../shared/task.css", import.meta.url).href), style(new URL("./floor-plan.css", import.meta.url).href)]);
  byId("panel-floor-plan").innerHTML = fragment;
  return startFloorPlan(app, module);
}
