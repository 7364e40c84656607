// @ts-check
// What `robovac bridge` says in text messages (crates/roomba-bridge/src/words.rs). Other bridges send none, or text of the robot.
import { mayTry } from "./local-network.js";
import { failure } from "./ports.js";

/** The version that this page speaks. */
const VERSION = "1";

/** How often the bridge gets a sign of life, ms. It stops the robot after 200 ms without one. */
export const ALIVE_MS = 50;

/** The codes with which the bridge closes a connection, with the reason in words: one that may pass, or for good. */
const CLOSED = 4000;
const REFUSED = 4001;

/** Why a connection was closed, and whether it is no use to try again. @param {CloseEvent} event */
export const closure = ({ code, reason }) => ({ why: `The bridge closed the connection${code === CLOSED || code === REFUSED ? `: ${reason}.` : "."}`, isForGood: code === REFUSED });

/** The bridge's TCP port, unless the address names another. */
const PORT = 7626;

/**
 * The first message of a bridge: whether it is one of ours. Throws a sentence if it is too new.
 * @param {unknown} data
 */
export function isHello(data) {
  const version = typeof data === "string" ? /^hello roomba-bridge (\d+)$/.exec(data)?.[1] : undefined;
  if (version !== undefined && version !== VERSION) throw `This bridge speaks version ${version} of the protocol, this page version ${VERSION}. Use a bridge and a page of the same age.`;
  return version !== undefined;
}

/** Why the bridge stopped the robot, as a sentence about it. @param {string} word */
export function haltedBecause(word) {
  if (word === "silent") return "The bridge stopped the wheels: nothing was heard of the driving page for 0.2 s.";
  if (word === "lost") return "The bridge stopped the robot: the driving page was silent for a second.";
  if (word === "left") return "The bridge stopped the robot: the driving page has left.";
  return "The bridge was ended, and stopped the robot.";
}

/**
 * The address of a bridge as a user writes it, completed: "roomba.local" is enough. Null if it is none.
 * @param {string} text
 */
export function bridgeAddress(text) {
  const isWhole = /^[a-z][a-z0-9+.-]*:\/\//i.test(text);
  const whole = isWhole ? text : `ws://${text}`;
  const url = URL.canParse(whole) ? new URL(whole) : null;
  if (!url || !/^wss?:$/.test(url.protocol) || !url.hostname) return null;
  if (!isWhole && url.port === "" && !/:\d+($|\/|\?)/.test(text)) url.port = String(PORT);
  return url;
}

/** The address of a bridge that can be tried; throws a `Failure`. @param {string} text */
export function wellFormed(text) {
  const url = bridgeAddress(text);
  if (!url) throw failure("failed", `"${text}" isn't the address of a bridge.`, "Enter its name or address, as in roomba.local or ws://192.168.1.50:81/.");
  if (!mayTry(url)) {
    throw failure(
      "mixed",
      "A page loaded over https:// can't connect to a bridge at ws:// outside your own network.",
      "Use a bridge with wss://, or open a copy of this page over http:// in your own network: for a bridge, that is enough.",
    );
  }
  return url;
}
