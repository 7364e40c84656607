// @ts-check
// Planning cells for a coverage: chosen in a worker of its own, as it plans some dozen times. Loaded when it is asked for.
import { byId, select, setHidden, setText } from "../dom.js";
import { clock, percent as asPercent } from "../format.js";
import { hire } from "../workers.js";
import { cellsOf, inCentimetres } from "./panel.js";

/** Chooses the cells with which the algorithm sweeps so many percent in the least time, and says what they reach. @param {import("../main.js").App} app @param {number} percent */
export async function fitCells({ playground, act, catalogue }, percent) {
  const menu = select("cell-size");
  const asked = playground.link();
  menu.disabled = true;
  const worker = await hire();
  try {
    const [size = 0, left = 0, below = 0, coverage = 0, seconds = 0] = /** @type {Float64Array} */ (await new Promise((resolve, reject) => {
      worker.addEventListener("message", (/** @type {MessageEvent<import("../worker-types").FromFit>} */ { data }) => {
        if (data.type === "fitted") resolve(data.cells);
        else reject(data.message);
      });
      worker.addEventListener("error", (event) => reject(event.message || "The planner could not be loaded."));
      worker.postMessage({ type: "fit", request: { id: 0, snapshot: playground.snapshot(undefined), percent } });
    }));
    // Whatever was changed meanwhile counts.
    if (playground.link() !== asked) return;
    act((p) => p.set_cells(size, left, below));
    // The app's view is that of the last frame.
    const [note, view] = [byId("cell-fit"), playground.view()];
    const rounded = view.smooth && view.can_smooth ? ", corners rounded" : "";
    const reached = `${asPercent(coverage)} %`;
    const told = coverage < percent / 100 ? `None of the cells tried reaches ${percent} %: ${reached} is the most` : `${reached} swept`;
    setHidden(note, false);
    // A planner that searches longer may find another walk in them.
    const tried = catalogue.planners.some(({ id, fast }) => id === view.algorithm && !fast) ? " by a short search" : "";
    setText(note, `${told}, in ${clock(seconds)}${rounded}${tried}.${begin(left, below)}`);
    note.dataset.of = cellsOf(playground, view);
  } catch (error) {
    act(() => {
      throw error;
    });
  } finally {
    worker.terminate();
    menu.disabled = false;
  }
}

/** Where the cells begin. @param {number} left @param {number} below m */
function begin(left, below) {
  const ways = [left > 0 ? `${inCentimetres(left)} to the left of the room's corner` : "", below > 0 ? `${inCentimetres(below)} below ${left > 0 ? "it" : "the room's corner"}` : ""];
  return left + below > 0 ? ` The cells begin ${ways.filter(Boolean).join(" and ")}.` : "";
}
