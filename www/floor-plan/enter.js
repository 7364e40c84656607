// @ts-check
// The place Floor plan with all that it needs: style, document, module. Loaded when one first goes there or brings a file.
import { byId } from "../dom.js";
import { style, text } from "../parts.js";
import { compile } from "../wasm.js";
import { startDraft } from "./tab.js";

/** @param {import("../main.js").App} app */
export async function enterDraft(app) {
  const compiled = compile(new URL("../../draft_bg.wasm", import.meta.url));
  const [module, fragment] = await Promise.all([compiled, text(new URL("./floor-plan.html", import.meta.url)), style(new URL("./floor-plan.css", import.meta.url).href)]);
  byId("place-draft").innerHTML = fragment;
  return startDraft(app, module);
}
