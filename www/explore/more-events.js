// @ts-check
// Events that others add to the list, such as what a program prints.

/** @typedef {{ time: number, text: string, felt: boolean }} Entry */

let version = () => 0;
/** @type {() => Entry[]} In the order of time. */
let entries = () => [];

/** @param {() => number} changes Differs when the entries do. @param {() => Entry[]} source */
export function tellMore(changes, source) {
  [version, entries] = [changes, source];
}

export const moreVersion = () => version();

/** The latest of theirs and ours, the latest first. @param {Entry[]} ours @param {number} now Seconds. @param {number} most */
export function withMore(ours, now, most) {
  const theirs = entries().filter(({ time }) => time <= now + 0.01).slice(-most).reverse();
  return theirs.length ? [...theirs, ...ours].sort((a, b) => b.time - a.time).slice(0, most) : ours;
}
