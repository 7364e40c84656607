// @ts-check
// The place Map: a robot explores a room that it has never seen, and what it believes is drawn beside what is true.
import { Guest, Survey } from "../../survey.js";
import { byId, changed, setAttribute, setHidden, setText, typed } from "../dom.js";
import { complain, textOf } from "../messages.js";
import { startSheets } from "../sheets.js";
import { startCanvas } from "./canvas.js";
import { startKeeping } from "./keep.js";
import { startNumbers } from "./numbers.js";
import { startPlaybar } from "./playbar.js";
import { startSetup } from "./setup.js";
import { startUses } from "./uses.js";

/**
 * @typedef {import("./types").SurveyView} SurveyView
 * @typedef {object} Surveying What the modules of this place share.
 * @property {import("../main.js").App} app
 * @property {Survey} survey
 * @property {SurveyView} view The latest view.
 * @property {import("../types").AlgorithmEntry[]} explorers
 * @property {[string, string][]} cleaners Planners of what is left.
 * @property {(what: (survey: Survey) => void) => boolean} act Does something that may fail; says whether it worked.
 * @property {(key: string, value: string) => boolean} set Chooses.
 * @property {(layer: string) => void} toggle Shows a layer, or no longer.
 */

/** Name of what is stored of choices. */
const CHOICES = "map-choices";
/** Milliseconds between descriptions in words. */
const TOLD_EVERY = 4000;

/** @param {import("../main.js").App} app */
export function startSurvey(app) {
  const canvas = typed("survey-floor", HTMLCanvasElement);
  const survey = new Survey(canvas);
  const follow = startGuest(app);
  follow((guest) => survey.take(guest));
  recall(survey);
  /** @type {Surveying} */
  const it = {
    app,
    survey,
    view: survey.view(),
    explorers: Survey.explorers(),
    cleaners: Survey.cleaners(),
    act: (what) => app.act(() => what(survey)),
    set: (key, value) => {
      // Another choice begins another run; what was reached stays with the choices that led there.
      keeping.save();
      return it.act((s) => s.set(key, value));
    },
    toggle: (layer) => void it.act((s) => s.show(layer, !it.view.layers.includes(layer))),
  };
  const keeping = startKeeping(it);
  const picture = startCanvas(it, canvas);
  const updates = [startSetup, startPlaybar, startNumbers].map((begin) => begin(it));
  const uses = startUses(it, keeping);
  startSheets(byId("place-map"), canvas);
  let told = 0;
  let last = 0;

  return {
    /** Once a frame while the place is shown. @param {number} now */
    frame(now) {
      if (now - last > 500) survey.rest();
      last = now;
      follow((guest) => survey.take(guest));
      keeping.tend();
      picture.resized();
      survey.frame(now);
      const view = (it.view = survey.view());
      for (const update of updates) update(view);
      uses.update(view);
      picture.update(view);
      show(view);
      if (changed(canvas, "phase", view.phase) || now - told > TOLD_EVERY) {
        told = now;
        const words = survey.description();
        setAttribute(canvas, "aria-label", words);
        // A live region: while it drives, not more often than someone listens.
        if (view.phase !== "playing" || changed(canvas, "minute", Math.floor(view.time_s / 300))) setText(byId("survey-said"), words);
      }
      return { message: view.complaint, message_kind: view.complaint ? "error" : "" };
    },
    /** @param {string} key */
    key: (key) => picture.key(key),
    link() {
      const link = survey.link();
      remember(link);
      return `place=map&${link}`;
    },
    /** @param {string} link */
    restore(link) {
      keeping.save();
      try {
        survey.restore(link);
      } catch (error) {
        complain(textOf(error));
      }
    },
    /** @param {boolean} dark */
    setDark: (dark) => survey.set_dark(dark),
  };
}

/** Takes the choices that were made last in this browser: with them comes what was mapped. @param {Survey} survey */
function recall(survey) {
  try {
    survey.restore(localStorage.getItem(CHOICES) ?? "");
  } catch {
    // There is no storage, or they were made by another version.
  }
}

/** @param {string} link */
function remember(link) {
  try {
    localStorage.setItem(CHOICES, link);
  } catch {
    // Without storage they last as long as the page.
  }
}

/** What is neither number nor choice. @param {SurveyView} view */
function show(view) {
  const root = byId("place-map");
  setAttribute(root, "data-phase", view.phase);
  setAttribute(root, "data-cleaning", String(view.is_cleaning));
  const goals = view.layers.includes("goals") ? [view.frontiers > 0 && "frontiers", view.has_route && "route"] : [];
  setAttribute(root, "data-goals", goals.filter(Boolean).join(" "));
  setHidden(byId("survey-hint"), view.phase !== "ready");
  setHidden(byId("survey-return"), view.returned === null);
  if (view.returned !== null) {
    const done = Math.floor(100 * view.returned);
    setText(byId("survey-returned"), `${done} %`);
    if (changed(byId("survey-return"), "done", done)) typed("survey-return-bar", HTMLProgressElement).value = done;
  }
  setText(byId("survey-room"), view.title);
  // A robot that has come to its end would look as if it hung; one that is lost has explored less, and says so itself.
  const isDone = view.phase === "finished" && view.is_sure !== false;
  const next = view.can.clean ? " Next: clean with this map." : "";
  const activity = isDone && !view.is_cleaning ? `Done: nothing is left that it can explore.${next}` : view.activity;
  setText(byId("survey-activity"), activity ? `${activity.charAt(0).toUpperCase()}${activity.slice(1)}` : "");
  setHidden(byId("survey-activity"), !activity || !["playing", "paused", "finished"].includes(view.phase));
  setHidden(byId("survey-held"), !view.is_carried);
  setHidden(byId("survey-hint-new"), view.known !== null);
  setHidden(byId("survey-hint-lost"), view.known === null);
  setHidden(byId("survey-known"), view.known === null);
  setText(byId("survey-known-name"), view.known ?? "");
  const sure = view.is_sure === null ? "" : view.is_sure ? "Sure where it is" : view.figures?.position_m === null ? "Lost" : "Guesses where it is";
  setHidden(byId("survey-sure"), !sure || view.phase === "ready");
  setText(byId("survey-sure"), sure);
  setAttribute(byId("survey-sure"), "data-sure", String(view.is_sure));
}

/**
 * The playground's session as this module sees it: it has a memory of its own.
 * @param {import("../main.js").App} app
 */
function startGuest({ playground }) {
  const guest = new Guest();
  /** @param {(guest: Guest) => void} take */
  return (take) => {
    const [link, version] = [playground.link(), playground.room_version()];
    if (guest.is_behind(link, version)) {
      const isOwn = new URLSearchParams(link).get("room") === "own";
      guest.follow(link, version, isOwn ? playground.scenario_json() : "");
    }
    take(guest);
  };
}
