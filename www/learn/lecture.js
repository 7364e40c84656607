// @ts-check
// Lecture mode: large type, one section at a time, arrow keys or a presenter's buttons. What is longer than the window scrolls first. Answers stay hidden until asked for.

const ON = ["ArrowRight", "PageDown", " "];
const BACK = ["ArrowLeft", "PageUp"];
/** Share of the window that a page key scrolls a section that is longer: some lines are seen twice. */
const PAGE = 0.85;
/** Pixels that an arrow key scrolls. */
const LINE = 60;

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

  /** Scrolls; says whether there was anything left in that direction. @param {number} by */
  const scrolls = (by) => {
    const before = body.scrollTop;
    body.scrollTop += by;
    return Math.abs(body.scrollTop - before) >= 1;
  };
  /** Space and page keys; sideways keys turn at once. @param {string} key @param {number} by */
  const goOn = (key, by) => void ((!key.startsWith("Arrow") && scrolls(by * PAGE * body.clientHeight)) || turn(by));

  document.addEventListener(
    "keydown",
    (event) => {
      if (!isOn || event.altKey || event.ctrlKey || event.metaKey || document.querySelector("dialog[open]")) return;
      const target = event.target instanceof Element ? event.target : document.body;
      if (event.key === "Escape") setOn(false);
      else if (target.matches("input, select, textarea, canvas, [role=slider]")) return;
      else if (event.key === " " && target.matches("button, summary, a")) return;
      else if (event.key === "ArrowDown") scrolls(LINE);
      else if (event.key === "ArrowUp") scrolls(-LINE);
      else if (BACK.includes(event.key) || (event.key === " " && event.shiftKey)) goOn(event.key, -1);
      else if (ON.includes(event.key)) goOn(event.key, 1);
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
