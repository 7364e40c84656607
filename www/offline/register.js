// @ts-check
// Makes the page installable and keeps it for use without a network: registers the service worker, and announces a new
// version. Loaded when the page is used and has nothing else to load.
import { byId, make } from "../dom.js";
import { complain, toast } from "../messages.js";

/** Digest of the build; scripts/offline.mjs fills it in where the page isn't served for development. */
const BUILD = "@BUILD@";
/** Milliseconds between looks for a new version while the page stays open. */
const PAUSE = 3_600_000;

export async function startOffline() {
  document.head.append(make("link", { rel: "manifest", href: new URL("../manifest.webmanifest", import.meta.url).href }));
  // Without a secure connection browsers have no workers of this kind, and some users have little data.
  if (BUILD.startsWith("@") || !("serviceWorker" in navigator) || Reflect.get(navigator, "connection")?.saveData) return;
  const { serviceWorker } = navigator;
  const registration = await serviceWorker.register(new URL("../../sw.js", import.meta.url), { updateViaCache: "none" });
  if (!registration) return;
  const look = () => registration.waiting && serviceWorker.controller && announce(registration.waiting);
  registration.addEventListener("updatefound", () => registration.installing?.addEventListener("statechange", look));
  look();
  // Without a network there is no newer one.
  setInterval(() => void registration.update().catch(() => {}), PAUSE);
}

/** @param {ServiceWorker} next */
function announce(next) {
  document.getElementById("update")?.remove();
  const button = make("button", { type: "button", id: "update", className: "primary", title: "A new version of this page is ready. Room and settings are kept." }, "Update");
  button.addEventListener("click", () => void update(next));
  byId("share").before(button);
  toast("A new version of this page is ready");
}

/** @param {ServiceWorker} next */
async function update(next) {
  if (document.body.dataset.robot === "open") return complain("A robot is connected. Disconnect it, then update.");
  navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
  const { port1, port2 } = new MessageChannel();
  const isAlone = new Promise((resolve) => (port1.onmessage = ({ data }) => resolve(data)));
  next.postMessage("take over", [port2]);
  if (!(await isAlone)) complain("This page is open in another tab or window. Close the others, then update.");
}
