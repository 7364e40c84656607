// @ts-check
// The playground's session as another wasm module sees it: each module has a memory of its own.

/**
 * A copy of the session that is brought up to date whenever it is asked for; cheap if nothing has changed.
 * @param {import("./main.js").App} app @param {import("../workshop.js").SessionMirror} mirror
 */
export function startMirror({ playground }, mirror) {
  return () => {
    mirror.follow(playground.snapshot(mirror.room_version()));
    return mirror;
  };
}
