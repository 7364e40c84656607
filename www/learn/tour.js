// @ts-check
// "Show me": what the page can do, in four steps of about 20 seconds. Esc or Skip ends it.
import { make } from "../dom.js";
import { style } from "../parts.js";
import { press } from "./blocks.js";

/** What is pointed at, what is said, and what is done. @type {{ at: string, head: string, text: string, act?: (app: import("../main.js").App) => void }[]} */
const STEPS = [
  { at: "#stage", head: "What the robot does", text: "A simulated Roomba follows a plan to sweep a furnished flat. Blue floor has been swept once, yellow floor often. The time line below goes back and forth.", act: (app) => void app.act((p) => p.play()) },
  { at: "#tools", head: "Change the room", text: "Draw walls, place furniture, stairs or a cat, or lift the robot and put it down somewhere else. It copes, or it doesn't: watch." },
  { at: "#tab-compare", head: "Compare", text: "Race planners and behaviours in the same room, or run each a hundred times with different seeds and look at the spread." },
  { at: "#learn-open", head: "Where to go next", text: "Ten lessons explain what you see, from your first prediction to a real Roomba. They stay beside the floor. In each you try, measure and are marked." },
];

/** @param {import("../main.js").App} app */
export async function startTour(app) {
  await style(new URL("./learn.css", import.meta.url).href);
  document.getElementById("tour")?.remove();
  let at = 0;
  const head = make("h2", {});
  const text = make("p", {});
  const count = make("span", { className: "note" });
  const next = press("Next", () => (at + 1 < STEPS.length ? show(at + 1) : end()), "primary");
  const card = make("section", { id: "tour", className: "tour", role: "dialog", "aria-label": "Show me" }, head, text, make("p", { className: "act" }, next, press("Skip", () => end()), count));
  const key = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    end();
  };
  function end() {
    document.removeEventListener("keydown", key, true);
    removeEventListener("resize", place);
    document.querySelector(".toured")?.classList.remove("toured");
    card.remove();
    try {
      localStorage.setItem("toured", "yes");
    } catch {
      // Then it is offered again.
    }
  }
  /** @param {number} index */
  function show(index) {
    at = index;
    const step = STEPS[at];
    if (!step) return end();
    head.textContent = step.head;
    text.textContent = step.text;
    count.textContent = `${at + 1} of ${STEPS.length}`;
    next.textContent = at + 1 < STEPS.length ? "Next" : "Done";
    step.act?.(app);
    document.querySelector(".toured")?.classList.remove("toured");
    document.querySelector(step.at)?.classList.add("toured");
    place();
  }
  /** Below what it explains, inside the window; beside the floor, or over it where there is no place: the room gives way then. */
  function place() {
    const shown = document.querySelector(".toured")?.getBoundingClientRect();
    if (!shown) return;
    const size = card.getBoundingClientRect();
    const isFloor = shown.height > innerHeight / 3;
    const isBeside = isFloor && shown.right + size.width + 18 < innerWidth;
    card.classList.toggle("over-floor", isFloor && !isBeside);
    const top = isFloor ? shown.top + 72 : shown.bottom + 10;
    const left = isBeside ? shown.right + 10 : isFloor ? shown.left + shown.width / 2 - size.width / 2 : shown.left;
    card.style.top = `${Math.max(8, Math.min(top, innerHeight - size.height - 8))}px`;
    card.style.left = `${Math.max(8, Math.min(left, innerWidth - size.width - 8))}px`;
  }
  document.getElementById("tab-explore")?.click();
  document.body.append(card);
  document.addEventListener("keydown", key, true);
  addEventListener("resize", place);
  show(0);
  next.focus();
}
