// @ts-check
// Connections that this browser supports, and alternatives.

// Versions are those of MDN's browser compatibility data for `Serial` (Chrome and Edge 89, Opera 76, Firefox 151, Chrome for
// Android 148; before that, Android had ports over Bluetooth only). What counts is what the browser offers, though.
const BROWSERS = "Chrome, Edge or Opera on a computer, Firefox 151 or later on a computer, or Chrome 148 or later on Android";
const OTHERWISE = "reach the robot through a Wi-Fi bridge (WebSocket), or try the virtual robot, which works everywhere";

/** Connections that this browser supports. @returns {import("./types").Support} */
export function support() {
  const socket = "WebSocket" in window;
  if (!window.isSecureContext) {
    return {
      serial: false,
      socket,
      why: "Browsers allow serial ports only for pages loaded over https:// or from this computer.",
      instead: `Open this page over https:// or from localhost, or ${OTHERWISE}.`,
    };
  }
  if (!navigator.serial) {
    // Firefox has no ports where an organisation manages it and doesn't allow them (policy DefaultSerialGuardSetting).
    if (Number(/ Firefox\/(\d+)/.exec(navigator.userAgent)?.[1]) >= 151 && !/Android/.test(navigator.userAgent)) {
      return {
        serial: false,
        socket,
        why: "Serial ports are switched off in this Firefox, by you or by the organisation that manages it.",
        instead: `Switch on dom.webserial.enabled in about:config, or ask your organisation; or ${OTHERWISE}.`,
      };
    }
    const isApple = /iPhone|iPad|iPod/.test(navigator.userAgent) || (/Macintosh/.test(navigator.userAgent) && navigator.maxTouchPoints > 1);
    return {
      serial: false,
      socket,
      why: isApple ? "No browser on an iPhone or iPad can use serial ports." : "This browser can't use serial ports (Web Serial).",
      instead: `Use ${BROWSERS}; or ${OTHERWISE}.`,
    };
  }
  // A frame needs permissions from its parent page, which only Chromium reports.
  const policy = /** @type {{ featurePolicy?: { allowsFeature(name: string): boolean } }} */ (document).featurePolicy;
  if (policy?.allowsFeature("serial") === false) {
    return {
      serial: false,
      socket,
      why: "The embedding page or the server forbids serial ports here (permissions policy).",
      instead: `Open this page in a tab of its own, or ${OTHERWISE}.`,
    };
  }
  return { serial: true, socket, why: "", instead: "" };
}
