// @ts-check
// What this browser can connect to, and what works instead.

/** What this browser can connect to. @returns {import("./types").Support} */
export function support() {
  return { serial: "serial" in navigator, socket: "WebSocket" in window, why: "", instead: "" };
}
