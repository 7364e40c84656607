// @ts-check
// The panel Learn: the list of lessons, a lesson, and what can be done with it.
import { make } from "../dom.js";
import { press, prose } from "./blocks.js";
import { showList } from "./list.js";
import { startLecture } from "./lecture.js";
import { readLesson } from "./reader.js";
import { addressOf, isFar, ofFile, ofPlace, ofSite } from "./source.js";

/** Milliseconds between updates of what the run on the floor has reached. */
const TICK = 300;

/** @param {import("../main.js").App} app */
export function startPanel(app) {
  const opener = document.getElementById("learn-open");
  const title = make("h2", { id: "learn-title" }, "Learn");
  const body = make("div", { className: "learn-body", tabIndex: -1 });
  const icon = (/** @type {string} */ sign, /** @type {string} */ name, /** @type {() => void} */ what) => make("button", { type: "button", className: "quiet square", "aria-label": name, title: name, onclick: what }, sign);
  const back = icon("‹", "All lessons", () => void show(""));
  const large = icon("A", "Lecture mode: large type, arrow keys", () => lecture.toggle());
  const panel = make("aside", { id: "learn", className: "learn", "aria-labelledby": "learn-title" }, make("header", { className: "learn-head" }, back, title, large, icon("✕", "Close Learn", () => setOpen(false))), body);
  document.body.append(panel);

  /** Ends what belongs to the lesson that is shown. */
  let ends = new AbortController();
  /** @type {(() => void)[]} */
  let ticks = [];
  /** The lesson that is shown, to be shown again in another way. @type {import("./source.js").Source | undefined} */
  let source;
  /** What the address says, also if it couldn't be opened: a reload tries again. */
  let address = "";
  const lecture = startLecture(panel, body, () => source && render(source));

  /** @param {boolean} isOpen */
  function setOpen(isOpen) {
    document.body.classList.toggle("learning", isOpen);
    panel.hidden = !isOpen;
    opener?.setAttribute("aria-expanded", String(isOpen));
    app.lesson = isOpen ? address : "";
    if (!isOpen) {
      lecture.stop();
      opener?.focus();
    }
  }

  /** @param {string} head @param {...HTMLElement} content */
  function fill(head, ...content) {
    ends.abort();
    ends = new AbortController();
    ticks = [];
    title.textContent = head;
    body.replaceChildren(...content);
    body.scrollTop = 0;
  }

  /** @param {import("./source.js").Source} lesson */
  function render(lesson) {
    fill("");
    const read = readLesson(app, lesson, { isLecture: lecture.isOn(), signal: ends.signal, ticks, open: (id) => void show(id) });
    title.textContent = read.title;
    body.replaceChildren(...read.parts);
    source = lesson;
    back.hidden = large.hidden = false;
    app.lesson = address = lesson.place;
    lecture.began();
    body.focus();
  }

  /** @param {unknown} error @param {string} what */
  function failed(error, what) {
    source = undefined;
    app.lesson = address;
    const why = error instanceof Error ? error.message : String(error);
    fill("Learn", make("div", { className: "part wrong", role: "alert" }, make("b", {}, `${what} can't be opened.`), make("p", {}, /[.?!]$/.test(why) ? why : `${why}.`)), make("p", { className: "act" }, ...(address ? [press("Try again", () => void show(address))] : []), press("All lessons", () => void show(""))));
  }

  /** Asks before anything is fetched from another site. @param {string} place */
  function ask(place) {
    let url;
    address = place;
    try {
      url = addressOf(place);
    } catch (error) {
      return failed(error, "This lesson");
    }
    source = undefined;
    app.lesson = address;
    const fetchIt = press("Fetch the lesson", () => void ofSite(url).then(render).catch((error) => failed(error, "This lesson")), "primary");
    fill(
      "A lesson from elsewhere",
      make("div", { className: "part" }, make("p", {}, "This link leads to a lesson on ", make("b", {}, url.host), "."), prose(""), make("p", { className: "note far" }, url.href), make("p", {}, `If you agree, your browser fetches it from there, and ${url.host} learns your internet address. The page shows it without scripts or pictures, and sends nothing else.`), make("p", { className: "act" }, fetchIt, press("No, show the lessons here", () => void show("")))),
    );
    fetchIt.focus();
  }

  /** @param {string} place "" for the list. */
  async function show(place) {
    if (isFar(place)) return ask(place);
    try {
      address = place;
      if (place) return render(await ofPlace(place));
      source = undefined;
      app.lesson = "";
      lecture.stop();
      back.hidden = large.hidden = true;
      fill("Learn", await showList(app, (next) => (next instanceof File ? take(next) : void show(next)), () => void show("")));
    } catch (error) {
      failed(error, place ? "This lesson" : "The list of lessons");
    }
  }

  /** @param {File} file */
  async function take(file) {
    try {
      address = "";
      render(await ofFile(file));
    } catch (error) {
      failed(error, `"${file.name}"`);
    }
  }

  setInterval(() => document.body.classList.contains("learning") && ticks.forEach((tick) => tick()), TICK);
  panel.hidden = true;

  return {
    /** @param {string | File} [what] Nothing opens and closes the panel. */
    async open(what) {
      if (what === undefined && document.body.classList.contains("learning")) return setOpen(false);
      const isShown = source !== undefined || (what === undefined && body.childElementCount > 0);
      if (what instanceof File) await take(what);
      else if (what !== undefined && what !== source?.place) await show(decodeURIComponent(what));
      else if (!isShown) await show("");
      setOpen(true);
    },
  };
}
