// @ts-check
// The floor for others: on the full screen, in a frame of another page (`?embed`), on paper. Loaded with the first input.
import { byId, make, setText } from "./dom.js";
import { toast } from "./messages.js";
import { style } from "./parts.js";
import { currentTab, isOnFloor } from "./tabs.js";
import { caption } from "./show.js";

/** Set by the head of the page, too. */
const ALONE = "embed";
/** Letters of a link that is printed at most: more lines are of no use. */
const LONGEST = 700;
/** How often other tabs name their room, ms. */
const NAMED = 500;

/** @param {import("./main.js").App} app @returns {Promise<() => void>} */
export async function startFrame(app) {
  await style(new URL("./frame.css", import.meta.url).href);
  const root = document.documentElement;
  const isEmbedded = root.classList.contains(ALONE);
  const name = isEmbedded ? linkToPage(app) : () => {};
  if (document.fullscreenEnabled) startFullScreen(root, isEmbedded);
  startPrint(app, root);
  return name;
}

/** From a frame to the page with all its menus: says what is shown, too. @param {import("./main.js").App} app */
function linkToPage(app) {
  const what = make("b", {});
  const link = make("a", { className: "to-page", target: "_blank", rel: "noopener" }, what, "Robovac Playground");
  const lead = () => {
    const page = new URL(location.href);
    page.search = "";
    page.hash = app.link();
    link.href = page.href;
  };
  lead();
  for (const sign of ["pointerdown", "focus"]) link.addEventListener(sign, lead);
  // Other tabs have room for it above them.
  const place = () => {
    if (isOnFloor()) byId("stage").append(link);
    else document.body.prepend(link);
  };
  place();
  // No frame of Explore's calls what is returned there.
  setInterval(() => isOnFloor() || setText(what, app.view.room.title), NAMED);
  document.addEventListener("tab", place);
  return () => setText(what, caption(app)[0] ?? "");
}

/** @param {HTMLElement} root @param {boolean} isEmbedded */
function startFullScreen(root, isEmbedded) {
  const toggle = make("button", { type: "button", id: "full-screen", className: "quiet square" });
  toggle.innerHTML = '<svg class="icon" viewBox="0 0 24 24" aria-hidden="true"><path d="M14.5 4H20v5.5M9.5 20H4v-5.5M20 4l-6.5 6.5M4 20l6.5-6.5" /></svg>';
  const show = () => {
    const isFull = document.fullscreenElement !== null;
    root.classList.toggle(ALONE, isFull || isEmbedded);
    const name = isFull ? "Leave full screen" : "Full screen";
    toggle.setAttribute("aria-label", name);
    toggle.title = name;
    toggle.setAttribute("aria-pressed", String(isFull));
  };
  toggle.addEventListener("click", () => {
    const done = document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen();
    done.catch(() => toast("This browser doesn't allow full screen here"));
  });
  document.addEventListener("fullscreenchange", () => {
    show();
    toggle.focus();
  });
  show();
  byId("stage").append(toggle);
}

/** Light colours on paper, and a line that says what it shows and where it is. @param {import("./main.js").App} app @param {HTMLElement} root */
function startPrint(app, root) {
  const sheet = make("link", { rel: "stylesheet", media: "print", href: new URL("./print.css", import.meta.url).href });
  document.head.append(sheet);
  const line = make("p", { id: "printed", className: "printed" });
  byId("stage").after(line);
  /** @type {string | undefined} */
  let theme;
  addEventListener("beforeprint", () => {
    theme = root.dataset.theme ?? "";
    const isDark = theme === "dark" || (!theme && matchMedia("(prefers-color-scheme: dark)").matches);
    // Compare has a line of its own.
    (document.querySelector(".tab-panel:not([hidden], .compare) .stage") ?? byId("stage")).after(line);
    // The planner is no part of a map, nor the room of a drawing.
    const [what] = isOnFloor() || currentTab() === "compare" ? caption(app) : currentTab() === "map" ? [app.view.room.title] : [];
    const where = location.href.length < LONGEST ? location.href : `${location.origin}${location.pathname} The link to this room is too long for paper. Use Copy link.`;
    line.replaceChildren(make("b", {}, what ?? ""), make("br"), where);
    const compare = document.getElementById("compare-link");
    if (compare) compare.textContent = where;
    if (!isDark) return void (theme = undefined);
    root.dataset.theme = "light";
    redraw(false);
  });
  addEventListener("afterprint", () => {
    if (theme === undefined) return;
    if (theme) root.dataset.theme = theme;
    else delete root.dataset.theme;
    redraw(true);
  });
  const redraw = (/** @type {boolean} */ isDark) =>
    app.act((p) => {
      app.setDark(isDark);
      p.frame(performance.now());
    });
}
