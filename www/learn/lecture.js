// @ts-check
// Lecture mode: large type, one section at a time, arrow keys or a presenter's buttons. Answers stay hidden until asked for.

const ON = ["ArrowRight", "PageDown"];
const BACK = ["ArrowLeft", "PageUp"];

/** @param {HTMLElement} panel @param {HTMLElement} body @param {() => void} again Shows the lesson again. */
export function startLecture(panel, body, again) {
  let isOn = false;
  let at = 0;
  /** Elements of each section: it begins with a heading. @type {HTMLElement[][]} */
  let sections = [];

  const show = () => {
    sections.forEach((parts, index) => parts.forEach((part) => (part.hidden = isOn && index !== at)));
    panel.dataset.page = isOn ? `${at + 1} of ${sections.length}` : "";
    body.scrollTop = 0;
  };
  const turn = (/** @type {number} */ by) => {
    at = Math.max(0, Math.min(sections.length - 1, at + by));
    show();
  };

  document.addEventListener(
    "keydown",
    (event) => {
      if (!isOn || event.altKey || event.ctrlKey || event.metaKey || document.querySelector("dialog[open]")) return;
      const target = event.target instanceof Element ? event.target : document.body;
      if (event.key === "Escape") setOn(false);
      else if (target.matches("input, select, textarea, canvas, [role=slider]")) return;
      else if (ON.includes(event.key)) turn(1);
      else if (BACK.includes(event.key)) turn(-1);
      else return;
      event.preventDefault();
      event.stopPropagation();
    },
    { capture: true },
  );

  /** @param {boolean} next */
  function setOn(next) {
    if (isOn === next) return;
    isOn = next;
    at = 0;
    panel.classList.toggle("lecture", isOn);
    document.body.classList.toggle("lecturing", isOn);
    again();
  }

  return {
    isOn: () => isOn,
    toggle: () => setOn(!isOn),
    stop() {
      isOn = false;
      panel.classList.remove("lecture");
      document.body.classList.remove("lecturing");
      show();
    },
    /** A lesson was rendered. */
    began() {
      sections = [];
      for (const child of /** @type {HTMLCollectionOf<HTMLElement>} */ (body.children)) {
        split(child);
        if (sections.length === 0 || child.querySelector(":scope > h3") || child.tagName === "FOOTER") sections.push([]);
        sections.at(-1)?.push(child);
      }
      show();
    },
  };
}

/** Text in which a heading isn't first becomes two texts. @param {HTMLElement} prose */
function split(prose) {
  if (!prose.classList.contains("prose")) return;
  const heading = [...prose.children].findIndex(({ tagName }, index) => index > 0 && tagName === "H3");
  if (heading < 0) return;
  const rest = /** @type {HTMLElement} */ (prose.cloneNode(false));
  rest.append(...[...prose.children].slice(heading));
  prose.after(rest);
}
