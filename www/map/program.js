// @ts-check
// The user's program as method: it drives in the sandbox, ahead of what is shown, and the session repeats its log.
import { button, byId, changed, setHidden, setText } from "../dom.js";
import { complain, textOf } from "../messages.js";
import { work } from "../program/work.js";

/** How far the sandbox runs ahead of what is shown, s. */
const AHEAD = 1800;

/** @param {import("./tab.js").MapTab} it @param {() => Uint8Array | undefined} job */
export function startProgram(it, job) {
  const { app, session } = it;
  /** What is at work. */
  let version = -1;
  /** How far it was asked to go, s. */
  let asked = 0;
  /** Lets it drive until a later time, or ends it. @type {((seconds: number) => void) | undefined} */
  let goOn;
  /** Why it has failed; empty if it hasn't. */
  let fault = "";
  /** A program is being fetched. */
  let isComing = false;
  button("map-program-open").addEventListener("click", () => byId("tab-program").click());

  /** The program of a link, else the last one. @param {string} link */
  const hold = async (link) => {
    if (isComing) return;
    isComing = true;
    try {
      const { enterProgram } = await import("../program/enter.js");
      await (await enterProgram(app)).hold(link);
    } catch (error) {
      complain(`The program could not be loaded (${textOf(error)}). Check the connection, then choose the method again.`);
    }
    isComing = false;
  };

  /** @param {number} from The step before which everything is known. */
  const drive = async (from) => {
    const [mine, program, bytes] = [version, app.playground.program(), job()];
    if (!program || !bytes) return;
    asked = it.view.time_s + AHEAD;
    let isWanted = true;
    const next = () => new Promise((/** @type {(seconds: number) => void} */ resolve) => (goOn = resolve));
    try {
      const onPart = (/** @type {Uint8Array} */ part) => {
        let isTaken = false;
        isWanted = it.act((s) => (isTaken = s.extend_program(mine, part))) && isTaken;
      };
      const done = await work({ program, job: bytes, seconds: asked, from, onPart, next }, { isWanted: () => isWanted && mine === version });
      if ("cells" in done) throw "this program plans but doesn't drive: choose one with step or run in the tab Program";
    } catch (error) {
      if (mine !== version) return;
      session.fail_program(mine);
      const text = textOf(error);
      fault = `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
      complain(fault);
    }
  };

  return {
    hold,
    /** @param {import("../types").MapView} view */
    update({ behaviour, program, time_s: now, title }) {
      setHidden(byId("map-program"), !program);
      if (behaviour === "program" && program && !program.name && !app.playground.program()) {
        // Once for each time that it is chosen.
        if (changed(byId("map-program"), "held", title)) void hold("");
      } else changed(byId("map-program"), "held", undefined);
      if (program) {
        setText(byId("map-program-name"), program.name ? `“${program.name}” drives.` : "");
        setText(byId("map-program-missing"), program.missing);
        setHidden(byId("map-program-missing"), !program.missing);
        setText(byId("map-program-fault"), fault);
        setHidden(byId("map-program-fault"), !fault);
      }
      const wanted = program?.drives ? program.version : program ? version : -1;
      if (wanted !== version) {
        version = wanted;
        fault = "";
        goOn?.(0);
        goOn = undefined;
        if (wanted >= 0) void drive(program?.reach_steps ?? 0);
      } else if (goOn && program?.drives && asked - now < AHEAD / 2) {
        goOn((asked = now + AHEAD));
        goOn = undefined;
      }
    },
  };
}
