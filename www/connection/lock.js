// @ts-check
// One tab at a time per line: a second one is refused instead of both talking to the robot.

/**
 * Takes the lock of that name for as long as this worker lives, or until the returned function is called; `null` if
 * another tab has it.
 * @param {string} name
 * @returns {Promise<(() => void) | null>}
 */
export async function takeLock(name) {
  // A page that was just reloaded can still be releasing it.
  for (let tries = 0; tries < 4; tries++) {
    const release = await tryLock(name);
    if (release) return release;
    await new Promise((later) => setTimeout(later, 100));
  }
  return null;
}

/** @param {string} name @returns {Promise<(() => void) | null>} */
function tryLock(name) {
  if (!navigator.locks) return Promise.resolve(() => {});
  return new Promise((resolve, reject) => {
    const held = (/** @type {Lock | null} */ lock) => {
      if (!lock) return resolve(null);
      return new Promise((/** @type {(value: void) => void} */ release) => resolve(() => release()));
    };
    navigator.locks.request(`robovac ${name}`, { ifAvailable: true }, held).catch(reject);
  });
}
