// @ts-check
// What `robovac bridge` says in text messages (crates/roomba-bridge/src/words.rs). Other bridges send none, or text of the robot.
import { mayTry } from "./local-network.js";
import { failure } from "./ports.js";

/** The version that this page speaks. */
const VERSION = "2";

/** The codes with which the bridge closes a connection, with the reason in words: one that may pass, or for good. */
const CLOSED = 4000;
const REFUSED = 4001;

/** Why a connection was closed, and whether it is no use to try again. @param {CloseEvent} event */
export const closure = ({ code, reason }) => ({ why: `The bridge closed the connection${code === CLOSED || code === REFUSED ? `: ${reason}.` : "."}`, isForGood: code === REFUSED });

/** The bridge's TCP port, unless the address names another. */
const PORT = 7626;

/** @param {unknown} data */
const versionIn = (data) => (typeof data === "string" ? /^hello roomba-bridge (\d+)$/.exec(data)?.[1] : undefined);

/** Whether a bridge's first message is that of one of ours. @param {unknown} data */
export const isHello = (data) => versionIn(data) !== undefined;

/** Why this page can't speak to a bridge of ours; "" if it can. @param {unknown} hello Its first message. */
export function misfit(hello) {
  const version = versionIn(hello);
  return version === undefined || version === VERSION ? "" : `This bridge speaks version ${version} of the protocol, this page version ${VERSION}. Use a bridge and a page from the same release.`;
}

/** Why the bridge stopped the robot, as a sentence about it. @type {Record<string, string>} */
const HALTED = {
  silent: "The bridge stopped the wheels: this page didn't answer it within 0.2 s. The page was busy, or the network is slow.",
  late: "The bridge didn't let the robot start: the command took longer than 0.2 s. The network is too slow to drive over.",
  flooded: "The bridge stopped the robot: this page sent more than the robot's serial line can carry.",
  stopped: "Another client of the bridge stopped the robot.",
  lost: "The bridge stopped the robot: this page was silent for a second.",
  left: "The bridge stopped the robot: the driving page has left.",
  ended: "The bridge was ended, and stopped the robot.",
};

/** @param {string} word */
export const haltedBecause = (word) => HALTED[word] ?? "The bridge stopped the robot.";

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
