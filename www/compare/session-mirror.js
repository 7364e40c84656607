// @ts-check
// The playground's session as the comparisons' module sees it: that module has a memory of its own.
import { SessionMirror } from "../../compare.js";

/**
 * A copy of the session that is brought up to date whenever it is asked for; cheap if nothing has changed.
 * @param {import("../main.js").App} app
 * @returns {() => SessionMirror}
 */
export function startMirror({ playground }) {
  const mirror = new SessionMirror();
  return () => {
    const [link, version] = [playground.link(), playground.room_version()];
    if (mirror.is_behind(link, version)) {
      const isOwn = new URLSearchParams(link).get("room") === "own";
      mirror.follow(link, version, isOwn ? playground.scenario_json() : "");
    }
    return mirror;
  };
}
