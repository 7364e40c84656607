// @ts-check
// Work that isn't needed in every frame.

/**
 * @param {number} ms
 * @returns {(isNew?: () => boolean, hurries?: boolean) => boolean} Whether it is to be done now: something is new, and the last time was longer ago than that.
 */
export function atMostEvery(ms) {
  let last = -Infinity;
  return (isNew, hurries = false) => {
    const now = performance.now();
    if ((!hurries && now - last <= ms) || isNew?.() === false) return false;
    last = now;
    return true;
  };
}
