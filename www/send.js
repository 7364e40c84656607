// @ts-check
// Beside "Copy link": other ways to send and to show what is on the floor. Loaded when a link is copied.
import { button, byId, make } from "./dom.js";
import { clock } from "./format.js";
import { complain, textOf, toast } from "./messages.js";
import { style } from "./parts.js";
import { without } from "./settings-link.js";
import { currentTab, isOnFloor } from "./tabs.js";

/** Size of the frame in another page, px. */
const [WIDTH, HEIGHT] = [720, 540];

/** @type {Promise<(link: URL, done: string, moment?: string) => void> | undefined} */
let made;

/** @param {import("./main.js").App} app @param {URL} link @param {string} done What was done with it. @param {string} [moment] */
export async function showWays(app, link, done, moment) {
  made ??= build(app);
  (await made)(link, done, moment);
}

/** Where a link leads in what goes on: some of it isn't in links. @param {import("./main.js").App} app @param {string | undefined} moment Of the run in Explore. */
function whereTo({ view }, moment) {
  const tab = currentTab();
  if (tab === "program") return "The link contains the program. Whoever opens it can read the program and run it from the start.";
  if (tab === "map") return "It opens with these settings and shows the whole map. Mapping starts again there.";
  if (tab === "compare") return "It opens with these settings. Results are computed again there, and a race starts at 0:00.";
  if (tab === "connection") return "It opens this tab. It doesn't connect a robot.";
  // The drawing's files may be large, and aren't for everybody.
  if (tab === "floor-plan" && !byId("floor-plan-settings").hidden) return "The drawing isn't in it. Press Use this room, then copy the link again.";
  if (!isOnFloor()) return "";
  const zoomed = view.is_all_shown ? "" : " It shows the whole room.";
  if (view.program) return `The program isn't in it: copy the link in the tab Program.${zoomed}`;
  if (moment === undefined) return `The run starts again there: a link doesn't carry what was done by hand during a run.${zoomed}`;
  const time = /=([\d.]+)/.exec(moment)?.[1];
  return time ? `It opens at ${clock(Number(time))}, as here.${zoomed}` : zoomed.trim();
}

/** The link of the floor and play bar alone, from the start of the run. @param {URL} link */
function embedded(link) {
  const own = new URL(link);
  own.search = "?embed";
  own.hash = without(own.hash, "moment");
  return own.href;
}

/** @param {import("./main.js").App} app */
async function build(app) {
  await style(new URL("./send.css", import.meta.url).href);
  const snippet = make("textarea", { id: "snippet", readOnly: true, rows: 3, spellcheck: false, "aria-label": "HTML of the frame" });
  snippet.addEventListener("focus", () => snippet.select());
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(snippet.value);
      toast("HTML copied");
    } catch {
      snippet.focus();
      toast("Press Ctrl+C to copy the HTML");
    }
  };
  const save = async () => {
    close();
    const { openSave } = await import("./save.js");
    await openSave(app, "picture");
  };
  const print = () => {
    close();
    window.print();
  };
  const act = (/** @type {string} */ label, /** @type {() => unknown} */ what) =>
    make("button", { type: "button", onclick: () => Promise.resolve(what()).catch((error) => complain(`This could not be loaded (${textOf(error)}). Check the connection, then try again.`)) }, label);
  const show = act("Picture or film…", save);
  const title = make("h2", { id: "ways-title", tabIndex: -1 });
  const where = make("p", { className: "note" });
  const framed = make("div", { className: "framed" }, make("h3", {}, "In your own web page"), snippet, act("Copy HTML", copy));
  const node = make(
    "section",
    { id: "ways", className: "ways", role: "dialog", "aria-labelledby": "ways-title", hidden: true },
    title,
    where,
    make("div", { className: "row" }, show, act("Print…", print)),
    framed,
  );
  byId("share").after(node);

  const close = () => {
    if (node.hidden) return;
    const hadFocus = node.contains(document.activeElement);
    node.hidden = true;
    if (hadFocus) button("share").focus();
  };
  document.addEventListener("pointerdown", ({ target }) => target instanceof Node && !node.contains(target) && close());
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || node.hidden) return;
    event.preventDefault();
    close();
  });
  node.addEventListener("focusout", ({ relatedTarget }) => relatedTarget instanceof Node && !node.contains(relatedTarget) && close());

  return (/** @type {URL} */ link, /** @type {string} */ done, /** @type {string | undefined} */ moment) => {
    title.textContent = done;
    where.textContent = whereTo(app, moment);
    where.hidden = where.textContent === "";
    // It is of the floor in Explore.
    show.hidden = !isOnFloor();
    // Other tabs are more than a floor and a play bar, and some show what only this browser has.
    framed.hidden = !isOnFloor() && currentTab() !== "compare";
    snippet.value = `<iframe src="${embedded(link).replaceAll("&", "&amp;")}" width="${WIDTH}" height="${HEIGHT}" style="border: 0" title="Robovac Playground" allow="fullscreen"></iframe>`;
    node.hidden = false;
  };
}
