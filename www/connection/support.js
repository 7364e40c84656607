// @ts-check
// Connections that this browser supports, and alternatives.

// Versions are those of MDN's browser compatibility data for `Serial` (Chrome and Edge 89, Opera 76, Firefox 151). What
// counts is what the browser offers, though. On Android, Chrome has ports over Bluetooth and, from 148, adapters of USB's
// own class (CDC), but none of those that most cables are built with: these, the page drives itself over WebUSB.
// Chrome on Android isn't named: nobody has tried it on a phone.
const BROWSERS = "Chrome, Edge, Opera, or Firefox 151 or later, on a computer";
const OTHERWISE = "reach the robot through a Wi-Fi bridge (WebSocket), or try the virtual robot, which works everywhere";

/**
 * What decides it about a browser. `serial` and `usb`: whether it has Web Serial and WebUSB, and whether the embedding page and
 * the server allow them.
 * @typedef {{ isSecure: boolean, serial: "absent" | "forbidden" | "here", usb: "absent" | "forbidden" | "here", isAndroid: boolean, isApple: boolean, isNewFirefox: boolean, socket: boolean }} Browser
 */

/** Connections that a browser supports. @param {Browser} browser @returns {import("./types").Support} */
export function supportIn({ isSecure, serial, usb, isAndroid, isApple, isNewFirefox, socket }) {
  const none = { serial: false, usb: false, socket };
  if (!isSecure) {
    return {
      ...none,
      why: "Browsers allow serial adapters only for pages loaded over https:// or from this computer.",
      instead: `Open this page over https:// or from localhost, or ${OTHERWISE}.`,
    };
  }
  // Who has all adapters as serial ports isn't asked to choose between two ways.
  const byUsb = usb === "here" && (isAndroid || serial === "absent");
  if (serial === "here" || byUsb) return { serial: serial === "here", usb: byUsb, socket, why: "", instead: "" };
  if (serial === "forbidden" || usb === "forbidden") {
    return {
      ...none,
      why: "The embedding page or the server forbids serial ports here (permissions policy).",
      instead: `Open this page in a tab of its own, or ${OTHERWISE}.`,
    };
  }
  // An organisation that manages Firefox can forbid them (policy DefaultSerialGuardSetting).
  if (isNewFirefox) {
    return {
      ...none,
      why: "Serial ports are switched off in this Firefox, by you or by the organisation that manages it.",
      instead: `Switch on dom.webserial.enabled in about:config, or ask your organisation; or ${OTHERWISE}.`,
    };
  }
  return {
    ...none,
    why: isApple ? "No browser on an iPhone or iPad can use serial ports." : "This browser can't use serial ports (Web Serial).",
    instead: `Use ${BROWSERS}; or ${OTHERWISE}.`,
  };
}

/** Connections that this browser supports. */
export function support() {
  // A frame needs permissions from its parent page, which only Chromium reports.
  const policy = /** @type {{ featurePolicy?: { allowsFeature(name: string): boolean } }} */ (document).featurePolicy;
  const state = (/** @type {"serial" | "usb"} */ name) => {
    if (!navigator[name]) return "absent";
    return policy?.allowsFeature(name) === false ? "forbidden" : "here";
  };
  const { userAgent, maxTouchPoints } = navigator;
  return supportIn({
    isSecure: window.isSecureContext,
    serial: state("serial"),
    usb: state("usb"),
    isAndroid: /Android/.test(userAgent),
    isApple: /iPhone|iPad|iPod/.test(userAgent) || (/Macintosh/.test(userAgent) && maxTouchPoints > 1),
    isNewFirefox: Number(/ Firefox\/(\d+)/.exec(userAgent)?.[1]) >= 151 && !/Android/.test(userAgent),
    socket: "WebSocket" in window,
  });
}
