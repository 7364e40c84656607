// @ts-check
// The playground's session as another wasm module sees it: each module has a memory of its own.

/** @typedef {{ is_behind(link: string, version: number): boolean, follow(link: string, version: number, scenario: string): void }} Mirror */

/**
 * A copy of the session that is brought up to date whenever it is asked for; cheap if nothing has changed.
 * @template {Mirror} M
 * @param {import("./main.js").App} app @param {M} mirror
 * @returns {() => M}
 */
export function startMirror({ playground }, mirror) {
  return () => {
    const [link, version] = [playground.link(), playground.room_version()];
    if (mirror.is_behind(link, version)) {
      const isOwn = new URLSearchParams(link).get("room") === "own";
      mirror.follow(link, version, isOwn ? playground.scenario_json() : "");
    }
    return mirror;
  };
}
