// @ts-check
// Planning cells for a coverage: chosen in a worker of its own, as it plans some dozen times. Loaded when it is asked for.
import { select } from "../dom.js";
import { hire } from "../workers.js";

/** Chooses the cells with which the algorithm sweeps so many percent in the least time. @param {import("../main.js").App} app @param {number} percent */
export async function fitCells({ playground, act }, percent) {
  const menu = select("cell-size");
  const asked = playground.link();
  menu.disabled = true;
  const worker = await hire();
  try {
    const metres = await new Promise((resolve, reject) => {
      worker.addEventListener("message", (/** @type {MessageEvent<import("../worker-types").FromFit>} */ { data }) => {
        if (data.type === "fitted") resolve(data.metres);
        else reject(data.message);
      });
      worker.addEventListener("error", (event) => reject(event.message || "The planner could not be loaded."));
      worker.postMessage({ type: "fit", request: { id: 0, snapshot: playground.snapshot(undefined), percent } });
    });
    // Whatever was changed meanwhile counts.
    if (playground.link() !== asked) return;
    act((p) => p.set_cell_size(metres));
  } catch (error) {
    act(() => {
      throw error;
    });
  } finally {
    worker.terminate();
    menu.disabled = false;
  }
}
