// @ts-check
// Sheets on a small screen close when they are swiped down by their head. Loaded with the first input.

/** Way after which a sheet closes, px. */
const FAR = 60;

export function startSwipe() {
  /** @type {{ sheet: HTMLElement, y: number } | undefined} */
  let held;
  document.addEventListener("pointerdown", ({ target, clientY, pointerType }) => {
    const head = pointerType !== "mouse" && target instanceof Element && !target.closest("button") ? target.closest(".sheet.open .sheet-head") : null;
    const sheet = head?.closest(".sheet");
    held = sheet instanceof HTMLElement ? { sheet, y: clientY } : undefined;
  });
  document.addEventListener("pointermove", ({ clientY }) => {
    if (held) held.sheet.style.translate = `0 ${Math.max(0, clientY - held.y)}px`;
  });
  for (const end of ["pointerup", "pointercancel"]) {
    document.addEventListener(end, (event) => {
      if (!held) return;
      held.sheet.style.translate = "";
      const way = event instanceof PointerEvent ? event.clientY - held.y : 0;
      if (end === "pointerup" && way > FAR) held.sheet.dispatchEvent(new Event("swiped", { bubbles: true }));
      held = undefined;
    });
  }
}
