// @ts-check
// The playground's session as another wasm module sees it: each module has a memory of its own.

/**
 * A mirror of the session, updated on every access; cheap if unchanged.
 * @param {import("./main.js").App} app @param {import("../workshop.js").SessionMirror} mirror
 */
export function startMirror({ playground }, mirror) {
  return () => {
    mirror.follow(playground.snapshot(mirror.room_version()));
    return mirror;
  };
}
