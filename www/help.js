// @ts-check
// The text of the dialog Help, loaded when that is first opened.
import { Playground } from "../page.js";
import { make, setText } from "./dom.js";
import { explainers } from "./explainer.js";
import { text } from "./parts.js";

/** @type {Promise<string> | undefined} */
let told;

/** @param {HTMLElement} into */
export async function fillHelp(into) {
  told ??= text(new URL("./help.html", import.meta.url));
  try {
    into.innerHTML = await told;
  } catch (error) {
    told = undefined;
    throw error;
  }
  void tellOffline(into.querySelector("#offline"));
  const [{ planners, behaviours }, sources] = [Playground.catalogue(), await explainers()];
  into.querySelector("#authors")?.replaceChildren(
    ...[...planners, ...behaviours].flatMap(({ id, title }) => {
      const { source, link } = sources[id] ?? {};
      if (!source) return [];
      return [make("li", {}, make("b", {}, title), ": ", link ? make("a", { href: link, target: "_blank", rel: "noopener" }, source) : source)];
    }),
  );
}

/** Says whether the page works without a network, now and once it does. @param {Element | null} status */
async function tellOffline(status) {
  if (!status || !("serviceWorker" in navigator)) return;
  const { serviceWorker } = navigator;
  if (!serviceWorker.controller && (await serviceWorker.getRegistration())) setText(status, "The page is being kept for use offline…");
  // Never, while it is served for development.
  await serviceWorker.ready;
  setText(status, "The page works offline: all of it is kept in this browser.");
}
