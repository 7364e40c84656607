// @ts-check
// Content beyond the right edge fades there, as a cue that it can be scrolled.

/** @param {HTMLElement} node What scrolls. */
export function cueScroll(node) {
  const look = () => (node.dataset.more = String(node.scrollWidth - node.clientWidth - node.scrollLeft > 2));
  node.addEventListener("scroll", look, { passive: true });
  // Not at once: what it changes would be observed again.
  const watch = new ResizeObserver(() => requestAnimationFrame(look));
  for (const part of [node, ...node.children]) watch.observe(part);
}
