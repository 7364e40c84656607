// @ts-check
// Learn, with its style and module: lessons beside the live floor. Loaded when it is first opened.
import init from "../../learn.js";
import { style } from "../parts.js";
import { compile } from "../wasm.js";
import { startPanel } from "./panel.js";

/** @type {Promise<ReturnType<typeof startPanel>> | undefined} */
let panel;

/** @param {import("../main.js").App} app @param {string | File} [what] A lesson: its id, its address, or its file. */
export async function enterLearn(app, what) {
  panel ??= load(app).catch((error) => {
    panel = undefined;
    throw error;
  });
  await (await panel).open(what);
}

/** @param {import("../main.js").App} app */
async function load(app) {
  const compiled = compile(new URL("../../learn_bg.wasm", import.meta.url));
  const [module] = await Promise.all([compiled, style(new URL("./learn.css", import.meta.url).href)]);
  await init({ module_or_path: module });
  return startPanel(app);
}
