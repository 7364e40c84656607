// @ts-check
// Writes the view into the document, and only what changed.
import { button, byId, changed, setAttribute, setEnabled, setHidden, setText, typed } from "../dom.js";
import { clock, metres, pace, percent, shareAbove } from "../format.js";
import { updateMessage } from "../messages.js";
import { atMostEvery } from "../shared/frame-pacer.js";

/** @typedef {import("../types").PageView} View */

/** Where fingers point there is hardly a keyboard. */
const HAS_KEYS = !matchMedia("(hover: none)").matches;

/** Whether it is time to put the picture into words. */
const mayNarrate = atMostEvery(4000);

/** Time to read a word of a caption, ms. */
const WORD = 280;
/** When the caption of the search has been read. */
let isRead = 0;

/** @param {import("../main.js").App} app */
export function updateView({ view, playground }) {
  setText(byId("n-coverage"), percent(view.coverage));
  setText(byId("n-time"), clock(view.time_s));
  setText(byId("n-time-unit"), view.time_s < 3600 ? "min" : "h");
  setText(byId("n-distance"), metres(view.distance_m));
  setAttribute(byId("numbers"), "data-long", String(view.time_s >= 3600 || view.distance_m >= 1000));
  setAttribute(document.body, "data-state", view.state);
  setAttribute(document.body, "data-kind", view.kind);
  updateFolds(view);
  updateMessage(view);
  const { text, film } = view.search;
  // One says where to put a robot down.
  setHidden(byId("search-box"), !text || view.is_carried);
  // While the robot drives, each stays long enough to be read.
  const now = performance.now();
  if (view.state !== "playing" || film !== null || !text || now >= isRead) {
    if (changed(byId("search-note"), "caption", text)) isRead = now + WORD * text.split(" ").length;
    setText(byId("search-note"), text);
  }
  updatePlanning(view);
  updateTools(view);
  setHidden(byId("legend-estimate"), !view.shows.estimate && view.slip === "none");

  // While paused the search changes only by a step or a seek, which is announced at once.
  const decision = ["playing", "planning", "seeking"].includes(view.state) ? "" : view.search.text;
  const who = `${view.algorithm} ${view.robot} ${view.room.title}`;
  const news = [changed(byId("floor"), "state", view.state), changed(byId("floor"), "decision", decision), changed(byId("floor"), "who", who)];
  if (mayNarrate(undefined, news.includes(true))) {
    const text = playground.description();
    setAttribute(byId("floor"), "aria-label", text);
    // Read aloud only when something comes to an end, not all the time.
    setText(byId("narration"), ["playing", "planning", "seeking"].includes(view.state) ? "" : text);
  }
}

/** The sensors are open for robots that live by them, out of the way otherwise; then it is up to the user. @param {View} view */
export function updateFolds({ kind }) {
  const fold = typed("senses-fold", HTMLDetailsElement);
  if (changed(fold, "kind", kind)) fold.open = kind === "behaviour";
}

/** @param {View} view */
function updatePlanning({ state, plan, can }) {
  const planning = state === "planning";
  const done = planning && plan ? Math.floor(plan.progress * 100) : 0;
  setHidden(byId("planning"), !planning);
  setText(byId("planning-percent"), `${done} %`);
  setAttribute(typed("planning-bar", HTMLProgressElement), "value", String(done));
  setEnabled(button("planning-cancel"), can.cancel);
  const proven = planning ? (plan?.gap ?? null) : null;
  setHidden(byId("planning-gap"), proven === null);
  setText(byId("planning-gap"), proven === null ? "" : proven === 0 ? "Proven optimal" : `Optimality gap ${shareAbove(proven)}`);
  setHidden(byId("planning-keep"), !can.keep);
}

/** So near, pixels, a robot is hidden. */
const NEAR = 16;

/**
 * Messages are above the robot or below it; it must come near before they change places. The captions of a search have room of their
 * own above the floor. Legend, tools and buttons let the robot be seen through them.
 * @param {boolean} isAllShown @param {[number, number]} spot
 */
function keepClear(isAllShown, [right, down]) {
  for (const node of document.querySelectorAll("#legend, #zoom, #tools, #kinds, #selection")) node.classList.toggle("thin", !isAllShown && hides(node, right, down));
  const captions = byId("search-box");
  const notices = captions.parentElement;
  const isLow = notices?.dataset.low === "true";
  if (notices) setAttribute(notices, "data-low", String(!isAllShown && captions.hidden && down < (isLow ? 0.6 : 0.4)));
}

/** Whether something lies over the robot, which is at these shares of the floor's width and height. @param {Element} node @param {number} right @param {number} down */
function hides(node, right, down) {
  const [floor, box] = [byId("floor"), node].map((one) => one.getBoundingClientRect());
  if (!floor || !box) return false;
  const [x, y] = [floor.left + right * floor.width, floor.top + down * floor.height];
  return x > box.left - NEAR && x < box.right + NEAR && y > box.top - NEAR && y < box.bottom + NEAR;
}

/** @param {View} view */
function updateTools({ can, tool, state, speed_factor, speed, is_lifted, is_carried, is_all_shown, robot_spot }) {
  for (const node of byId("tools").querySelectorAll("button[data-tool]")) {
    const name = node.getAttribute("data-tool");
    setAttribute(node, "aria-pressed", String(name === tool && !is_lifted));
    setEnabled(/** @type {HTMLButtonElement} */ (node), name === "view" || can.edit);
  }
  setAttribute(byId("stage"), "data-tool", tool);
  setEnabled(button("lift"), can.lift || is_lifted);
  setAttribute(button("lift"), "aria-pressed", String(is_lifted));
  setText(byId("lift-name"), is_lifted ? "Put down" : "Lift robot");
  setHidden(byId("carry-note"), !is_carried);
  setAttribute(byId("carry-note"), "data-low", String(!is_all_shown && robot_spot[1] < 0.5));
  keepClear(is_all_shown, robot_spot);
  setText(byId("carry-note"), is_carried ? (HAS_KEYS ? "Click where to put the robot down. Arrow keys move it, Enter puts it down, Escape puts it back." : "Tap where to put the robot down, or drag it there.") : "");
  setEnabled(button("undo"), can.undo);
  setEnabled(button("redo"), can.redo);
  const lags = state === "playing" && !is_lifted && speed_factor > 0 && (speed === 0 || speed_factor < 0.9 * speed);
  setText(byId("pace"), lags ? `${pace(speed_factor)} reached` : "");
}
