// @ts-check
// Content beyond the right edge fades there, as a cue that it can be scrolled.

/** @param {HTMLElement} node What scrolls. */
export function cueScroll(node) {
  const look = () => (node.dataset.more = String(node.scrollWidth - node.clientWidth - node.scrollLeft > 2));
  node.addEventListener("scroll", look, { passive: true });
  const watch = new ResizeObserver(look);
  for (const part of [node, ...node.children]) watch.observe(part);
}
