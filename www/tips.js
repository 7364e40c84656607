// @ts-check
// Definitions, one hover, tap or focus away: every element with `data-tip` has one.
import { byId } from "./dom.js";

/** Starts listening for the whole page. */
export function startTips() {
  const tip = byId("tip");
  /** @type {Element | null} */
  let owner = null;

  const hide = () => {
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
    tip.textContent = text;
    tip.hidden = false;
    next.querySelector("button, input, select")?.setAttribute("aria-describedby", "tip");
    const [at, size, gap] = [next.getBoundingClientRect(), tip.getBoundingClientRect(), 8];
    const above = at.top - size.height - gap;
    const left = Math.min(Math.max(at.left + at.width / 2 - size.width / 2, gap), innerWidth - size.width - gap);
    tip.style.left = `${Math.max(left, gap)}px`;
    tip.style.top = `${above > gap ? above : Math.min(at.bottom + gap, innerHeight - size.height - gap)}px`;
  };

  document.addEventListener("pointerover", (event) => {
    if (event.pointerType === "mouse") show(event.target);
  });
  document.addEventListener("focusin", (event) => {
    if (event.target instanceof Element && event.target.matches(":focus-visible")) show(event.target);
    else hide();
  });
  // A tap on a term opens its definition, the next tap closes it.
  document.addEventListener("click", (event) => {
    if (!(event instanceof PointerEvent) || event.pointerType === "mouse") return;
    const term = event.target instanceof Element ? event.target.closest(".term, .legend, .label") : null;
    if (term && term.closest("[data-tip]") !== owner) show(term);
    else hide();
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
  });
  document.addEventListener("scroll", hide, true);
}
