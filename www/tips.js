// @ts-check
// Definitions, one hover, tap or focus away: every element with `data-tip` has one. Many lead on to a lesson.
import { byId, make } from "./dom.js";

/** Time to get from what is explained to its definition, ms. */
const WAY = 200;

/** Starts listening for the whole page. @param {import("./main.js").App} app */
export function startTips(app) {
  const tip = byId("tip");
  /** @type {Element | null} */
  let owner = null;

  let leaving = 0;
  /** Counts what was shown: what is looked up for one is of no use to the next. */
  let turn = 0;
  /** Opens the lesson of what is shown. @type {(() => void) | undefined} */
  let lesson;

  const hide = () => {
    clearTimeout(leaving);
    lesson = undefined;
    tip.style.pointerEvents = "";
    owner?.querySelector("[aria-describedby=tip]")?.removeAttribute("aria-describedby");
    owner = null;
    tip.hidden = true;
  };

  /** @param {EventTarget | null} target */
  const show = (target) => {
    const next = target instanceof Element ? target.closest("[data-tip]") : null;
    if (next === owner) return;
    hide();
    const text = next?.getAttribute("data-tip");
    if (!next || !text) return;
    owner = next;
    turn++;
    tip.textContent = text;
    // Elements outside an open dialog are behind it.
    (next.closest("dialog") ?? document.body).append(tip);
    tip.hidden = false;
    next.querySelector("button, input, select")?.setAttribute("aria-describedby", "tip");
    place(tip, next);
    void leadOn(next);
  };

  /** Adds the lesson that explains it. @param {Element} next */
  const leadOn = async (next) => {
    const mine = turn;
    const { lessonOf } = await import("./learn/explains.js");
    const found = await lessonOf(next).catch(() => undefined);
    if (!found || owner !== next || turn !== mine) return;
    lesson = () => {
      hide();
      import("./learn/enter.js").then(({ enterLearn }) => enterLearn(app, found.id)).catch(console.warn);
    };
    const keys = matchMedia("(hover: none)").matches ? "" : " (F1)";
    const link = make("button", { type: "button", className: "link", tabIndex: -1, onclick: lesson }, `Explained in lesson ${found.number}, “${found.title}”${keys}`);
    link.style.color = "inherit";
    const line = make("div", {}, link);
    line.style.marginTop = "0.3rem";
    tip.append(line);
    tip.style.pointerEvents = "auto";
    place(tip, next);
  };

  // Loaded with the first input, which may have come to one already.
  show([...document.querySelectorAll(":hover")].at(-1) ?? null);
  /** Where the pointer was last, and whether the page moved under it since: nobody asked for what came there. */
  let [lastAt, isUnasked] = ["", false];
  const isStill = (/** @type {PointerEvent} */ { clientX, clientY }) => lastAt === (lastAt = `${clientX} ${clientY}`);
  document.addEventListener("pointermove", (event) => {
    if (!isStill(event) && isUnasked && event.pointerType === "mouse") show(event.target);
    isUnasked = false;
  });
  document.addEventListener("pointerover", (event) => {
    if (event.pointerType !== "mouse") return;
    clearTimeout(leaving);
    if (!(event.target instanceof Node) || tip.contains(event.target)) return;
    if (isStill(event)) {
      isUnasked = true;
      if (!owner?.contains(event.target)) hide();
      return;
    }
    // On the way to a link in the definition, there may be something else for a moment.
    const { target } = event;
    if (lesson && !(target instanceof Element && target.closest("[data-tip]"))) leaving = setTimeout(() => show(target), WAY);
    else show(target);
  });
  document.addEventListener("focusin", (event) => {
    if (event.target instanceof Node && tip.contains(event.target)) return;
    if (event.target instanceof Element && event.target.matches(":focus-visible")) show(event.target);
    // A click gives a term the focus without a mark, and is no reason to take its own definition away.
    else if (!(event.target instanceof Node && owner?.contains(event.target))) hide();
  });
  // A tap on a term opens its definition, the next tap closes it.
  document.addEventListener("click", (event) => {
    if (!(event instanceof PointerEvent) || (event.target instanceof Node && tip.contains(event.target))) return;
    if (event.pointerType === "mouse") {
      // What was set in motion is to be seen; a term is clicked to be read.
      if (!(event.target instanceof Element && event.target.closest(".term"))) hide();
      return;
    }
    const term = event.target instanceof Element ? event.target.closest(".term, .legend, .label") : null;
    if (term && term.closest("[data-tip]") !== owner) show(term);
    else hide();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
    if (event.key === "F1" && lesson) {
      event.preventDefault();
      lesson();
    }
  });
  document.addEventListener("scroll", hide, true);
  // A finger that is lifted leaves, too.
  document.documentElement.addEventListener("pointerleave", ({ pointerType }) => pointerType === "mouse" && hide());
  // The explained element can disappear by itself.
  setInterval(() => owner && !owner.checkVisibility({ visibilityProperty: true }) && hide(), 250);
}

/** Beside a panel, or else above or below what it explains, such that it hides no neighbour it needn't. @param {HTMLElement} tip @param {Element} owner */
function place(tip, owner) {
  tip.style.left = tip.style.top = "0";
  const [at, size, gap] = [owner.getBoundingClientRect(), tip.getBoundingClientRect(), 8];
  const rail = owner.closest(".rail")?.getBoundingClientRect();
  let left = at.left + at.width / 2 - size.width / 2;
  let top = at.top - size.height - gap;
  if (rail && rail.width > 0 && rail.width < innerWidth / 2) {
    left = rail.left > innerWidth / 2 ? rail.left - size.width - gap : rail.right + gap;
    top = at.top + at.height / 2 - size.height / 2;
  } else if (top < gap) top = at.bottom + gap;
  const inside = (/** @type {number} */ value, /** @type {number} */ most) => Math.max(gap, Math.min(value, most - gap));
  tip.style.left = `${inside(left, innerWidth - size.width)}px`;
  tip.style.top = `${inside(top, innerHeight - size.height)}px`;
}
