// @ts-check
// The room that the robot is in, as the page's copy and the worker's have it, and the algorithm that is to drive.
import { SessionMirror } from "../../workshop.js";

/** The robots that can be connected are of this kind. */
const MODEL = "roomba600";

/**
 * The playground's room as it was when it was last taken over, with an algorithm of one's own choice.
 * @param {import("../main.js").App} app
 */
export function startRoom({ playground, catalogue }) {
  const mirror = new SessionMirror();
  /** @type {import("./types").Followed} */
  let taken = { link: "", version: -1, scenario: "" };
  /** What Explore had chosen. */
  let chosenThere = "";
  let algorithm = "";
  const all = [...catalogue.behaviours.filter(({ manual }) => !manual), ...catalogue.planners];

  /** @param {string} link */
  const named = (link) => {
    const pairs = new URLSearchParams(link);
    return pairs.get("behaviour") ?? pairs.get("planner") ?? "";
  };

  /** What to follow for the algorithm that is chosen. @returns {import("./types").Followed} */
  const followed = () => {
    const pairs = taken.link.split("&").filter((pair) => !/^(tab|place|speed|show|quantised)=/.test(pair));
    const kept = pairs.filter((pair) => !pair.startsWith("robot=") && !(algorithm !== chosenThere && /^(planner|behaviour|p\.[^=]*)=/.test(pair)));
    // Cells of another robot don't fit this one.
    const own = taken.link.includes(`robot=${MODEL}`) ? kept : kept.filter((pair) => !pair.startsWith("cell="));
    const { kind } = all.find(({ id }) => id === algorithm) ?? { kind: "behaviour" };
    const choice = algorithm === chosenThere ? [] : [`${kind}=${algorithm}`];
    return { ...taken, link: [...own, ...choice, `robot=${MODEL}`].join("&") };
  };
  const follow = () => {
    const { link, version, scenario } = followed();
    if (mirror.is_behind(link, version)) mirror.follow(link, version, scenario);
  };

  return {
    mirror,
    /** All that can drive a robot. */
    all,
    get algorithm() {
      return all.find(({ id }) => id === algorithm);
    },
    /** Takes over what Explore shows now; says whether the room is another one. */
    take() {
      const [link, version] = [playground.link(), playground.room_version()];
      const isOther = version !== taken.version || room(link) !== room(taken.link);
      taken = { link, version, scenario: /(^|&)room=own(&|$)/.test(link) ? playground.scenario_json() : "" };
      const there = named(link);
      // What is driven by hand needs no algorithm here.
      if (there !== chosenThere || !algorithm) algorithm = all.some(({ id }) => id === there) ? there : algorithm || (all[0]?.id ?? "");
      chosenThere = there;
      follow();
      return isOther;
    },
    /** @param {string} id */
    choose(id) {
      algorithm = id;
      follow();
    },
    followed,
    /** Says which room it is. */
    version: () => `${taken.version} ${room(taken.link)}`,
  };
}

/** The part of a link that says which room it is, and where the robot starts in it. @param {string} link */
const room = (link) => link.split("&").filter((pair) => /^(room|start)=/.test(pair)).join("&");
