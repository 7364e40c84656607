// The service worker of a finished page: www/offline/sw.js with the digest of the build and all files, beside index.html.
// OFFLINE=no makes one that removes itself instead: a page served for development must show what was built last.
import { createHash } from "node:crypto";
import fs from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { minify } from "terser";
import { filesBelow } from "./references.mjs";

const SOURCE = fileURLToPath(new URL("../www/offline/sw.js", import.meta.url));

const SELF_REMOVING = `addEventListener("install", () => skipWaiting());
addEventListener("activate", (event) => event.waitUntil((async () => {
  const ours = (await caches.keys()).filter((name) => name.startsWith("robovac " + registration.scope + " "));
  await Promise.all(ours.map((name) => caches.delete(name)));
  await registration.unregister();
  for (const page of await clients.matchAll({ type: "window" })) await page.navigate(page.url);
})()));
`;

/** What the page itself never asks for: trunk's own files, the picture for those who show links to it, and its sources. */
const isLeftOut = (name) => /(^|\/)\.|^sw\.js$|^screenshot\.png$|^source\.tar\.gz$/.test(name);

/** Writes the service worker of the page in `folder`, the last step of a build. @param {string} folder @param {string} build Digest of the build. */
export async function writeWorker(folder, build) {
  const target = path.join(folder, "sw.js");
  // Its place is beside index.html.
  fs.rmSync(path.join(folder, "www/offline/sw.js"), { force: true });
  if (process.env.OFFLINE === "no") return void fs.writeFileSync(target, SELF_REMOVING);
  const register = path.join(folder, "www/offline/register.js");
  fs.writeFileSync(register, fs.readFileSync(register, "utf8").replace("@BUILD@", build));
  const files = filesBelow(folder).map((file) => path.relative(folder, file).split(path.sep).join("/"));
  const digestOf = (name) => createHash("sha256").update(fs.readFileSync(path.join(folder, name))).digest("hex").slice(0, 16);
  const kept = Object.fromEntries(files.filter((name) => !isLeftOut(name)).map((name) => [name, digestOf(name)]));
  const text = fs.readFileSync(SOURCE, "utf8").replace("@BUILD@", build).replace("FILES = {}", `FILES = ${JSON.stringify(kept)}`);
  fs.writeFileSync(target, (await minify(text)).code);
}
