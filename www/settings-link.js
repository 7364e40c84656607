// @ts-check
// Settings in links: pairs of a key and a value, joined by &. What they mean is decided in Rust.

/** The settings by their keys. @param {string} link */
export const settingsOf = (link) => new URLSearchParams(link);

/** The link without these settings. @param {string} link @param {string[]} keys */
export const without = (link, ...keys) =>
  link
    .split("&")
    .filter((pair) => !keys.includes(pair.split("=", 1)[0] ?? ""))
    .join("&");

/** The link of an own room with more about it: right behind the room, as tabs' settings, which come last, may be cut off.
 * @param {string} link @param {string} more */
export const aboutRoom = (link, more) => link.replace("room=own", `room=own&${more}`);
