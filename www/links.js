// @ts-check
// Follows links: the address of the page, and what back, forward and other links make of it.
import { follow, restoreLink } from "./keep.js";
import { tabOf } from "./tabs.js";

/**
 * Follows the present address, and every later one. Resolves when the first was followed.
 * @param {import("./main.js").App} app @param {import("./tab-loader.js").TabLoader} tabs @param {(lesson: string) => void} learn
 */
export async function startLinks(app, tabs, learn) {
  /** Links that are still being followed. */
  let following = 0;
  /** @param {string} address */
  const restore = async (address) => {
    const { hash } = new URL(address);
    follow(hash);
    // Other fragments are positions on the page, such as that of the skip link.
    if (!hash.includes("=")) return;
    // A lesson is last: its address can have an & of its own.
    const [, link = "", lesson] = /^(.*?)(?:(?:^|&)lesson=(.*))?$/.exec(hash.slice(1)) ?? [];
    if (lesson) learn(lesson);
    if (!link) return;
    following += 1;
    await restoreLink(app, link);
    await tabs.enter(tabOf(link));
    following -= 1;
    tabs.shown?.restore(link);
    app.followed = link;
  };
  await restore(location.href);
  // One after the other, and not the address as it is by then: `keepState` may have been faster.
  let restored = Promise.resolve();
  addEventListener("hashchange", ({ newURL }) => (restored = restored.then(() => restore(newURL))));
  return {
    /** Whether links are still being followed: until then, the address is theirs. */
    isFollowing: () => following > 0,
  };
}
