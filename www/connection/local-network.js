// @ts-check
// Reaching a bridge at ws:// from a page that came over https://. Browsers forbid it, but for addresses of one's own computer
// and, where they know Local Network Access (Chrome 147 for WebSockets), for one's own network once the user has agreed.
import { failure } from "./ports.js";

/** Addresses of this computer, which browsers count as safe. @param {string} host */
const isHere = (host) => /^(localhost|127\..*|\[::1\])$/.test(host);

/** Addresses of one's own network, by which browsers see before connecting that they are. @param {string} host */
export const isNear = (host) =>
  isHere(host) || /^(10\.|192\.168\.|169\.254\.|172\.(1[6-9]|2\d|3[01])\.)[\d.]+$/.test(host) || /^\[(f[cd][0-9a-f]{2}|fe80):/.test(host) || /\.local$/.test(host);

/** Whether a page over https can try it at all. @param {URL} url */
export function mayTry(url) {
  return self.location.protocol !== "https:" || url.protocol !== "ws:" || isNear(url.hostname);
}

/** The state of the permission, or "unknown" where the browser doesn't have it. @returns {Promise<string>} */
async function permission() {
  for (const name of ["local-network", "local-network-access"]) {
    try {
      return (await navigator.permissions.query({ name: /** @type {PermissionName} */ (name) })).state;
    } catch {
      // Not known by that name.
    }
  }
  return "unknown";
}

/** Why a bridge doesn't answer, as far as a page can know: browsers don't tell. @param {URL} url */
export async function unreachable(url) {
  const from = `The bridge at ${url.origin} doesn't answer.`;
  const check = "Check that it is on and on the same network, and that address, port and path are right.";
  const isMixed = self.location.protocol === "https:" && url.protocol === "ws:" && !isHere(url.hostname);
  // What is in the same network as the page needs no permission.
  const state = isNear(self.location.hostname) ? "granted" : await permission();
  if (state === "denied") return failure("denied", "This browser doesn't let this page reach devices in your network.", "Allow \"Local network access\" in the site's settings (the icon beside the address), then connect again.");
  if (isMixed && state === "unknown")
    return failure("mixed", `${from} This browser lets a page over https:// reach only bridges at wss://.`, "Use Chrome or Edge from version 147, a bridge with wss://, or a copy of this page over http:// in your own network.");
  if (state === "prompt") return failure("denied", `${from} The browser asks first whether this page may reach devices in your network.`, `Connect again and choose Allow. If there is no question: ${lower(check)}`);
  return failure("unreachable", from, check);
}

/** @param {string} sentence */
const lower = (sentence) => sentence.charAt(0).toLowerCase() + sentence.slice(1);
