// @ts-check
// The tab Map: a robot explores a room that it has never seen, and its map is drawn next to the truth.
import { MapSession, SessionMirror } from "../../workshop.js";
import { byId, changed, setAttribute, setHidden, setText, typed } from "../dom.js";
import { complain, sentence, textOf } from "../messages.js";
import { settingsOf, without } from "../settings-link.js";
import { startMirror } from "../session-mirror.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { startSheets } from "../sheets.js";
import { startCanvas } from "./canvas.js";
import { startClear } from "./clear.js";
import { startEnding } from "./ending.js";
import { startKeeping } from "./keep.js";
import { startNumbers } from "./numbers.js";
import { startPlaybar } from "./playbar.js";
import { startProgram } from "./program.js";
import { startSetup } from "./setup.js";
import { startUses } from "./uses.js";

/**
 * @typedef {import("../types").MapView} MapView
 * @typedef {object} MapTab What the modules of this tab share.
 * @property {import("../main.js").App} app
 * @property {MapSession} session
 * @property {MapView} view The latest view.
 * @property {import("../types").CatalogueEntry[]} explorers
 * @property {[string, string][]} cleaners Planners for the remaining floor.
 * @property {(what: (session: MapSession) => void) => boolean} act Runs an action that can fail; returns whether it
 * succeeded.
 * @property {(key: string, value: string) => boolean} set Chooses.
 * @property {(layer: string) => void} toggle Shows a layer, or no longer.
 */

/** Storage key of the choices. */
const CHOICES = "map-choices";
/** Length of a run whose map is missed, s. */
const WORTH = 10;
/** Milliseconds between descriptions in words. */
const PAUSE = 4000;

/** @param {import("../main.js").App} app */
export function startMap(app) {
  const canvas = typed("map-floor", HTMLCanvasElement);
  const session = new MapSession(canvas);
  const mirror = startMirror(app, new SessionMirror());
  session.take(mirror());
  recall(session);
  /** @type {MapTab} */
  const it = {
    app,
    session,
    view: session.view(),
    explorers: MapSession.explorers(),
    cleaners: MapSession.cleaners(),
    act: (what) => app.act(() => what(session)),
    set: (key, value) => {
      // Another choice begins another run; the result stays with the choices that led to it.
      keeping.save();
      const before = session.view().end_s;
      const worked = it.act((s) => s.set(key, value));
      if (before > WORTH && session.view().end_s === 0) keeping.parted();
      return worked;
    },
    toggle: (layer) => void it.act((s) => s.show(layer, !it.view.layers.includes(layer))),
  };
  const keeping = startKeeping(it);
  const picture = startCanvas(it, canvas);
  const playbar = startPlaybar(it);
  const program = startProgram(it, () => session.program_job(mirror()));
  const updates = [startSetup(it), playbar.update, startNumbers(it), program.update, startEnding(), startClear(it)];
  const uses = startUses(it, keeping);
  startSheets(byId("panel-map"), canvas);
  const isDue = atMostEvery(PAUSE);
  let last = 0;

  return {
    /** Once a frame while the tab is shown. @param {number} now */
    frame(now) {
      if (now - last > 500) session.rest();
      last = now;
      session.take(mirror());
      keeping.tend();
      picture.resized();
      session.frame(now);
      const view = (it.view = session.view());
      for (const update of updates) update(view);
      uses.update(view);
      picture.update(view);
      show(view);
      const isNew = changed(canvas, "phase", view.phase);
      if (isDue(undefined, isNew)) {
        const words = session.description();
        setAttribute(canvas, "aria-label", words);
        // A live region: while it drives, not more often than someone listens.
        if (isNew || view.phase !== "playing" || changed(canvas, "minute", Math.floor(view.time_s / 300))) setText(byId("map-said"), words);
      }
      return { message: view.complaint, message_kind: view.complaint ? "error" : "" };
    },
    /** @param {string} key */
    key: (key) => picture.key(key) || playbar.key(key),
    link() {
      const link = session.link();
      remember(link);
      return `tab=map&${link}`;
    },
    /** @param {string} link */
    restore(link) {
      keeping.save();
      // A link that was made here leads to what is here.
      const settings = settingsOf(link);
      const isProgram = settings.get("explorer") === "program" && (settings.has("code") || !app.playground.program());
      void (isProgram ? program.hold(link) : Promise.resolve()).then(() => it.act((s) => s.restore(link)));
    },
    /** A program that drives goes with the link. */
    async share() {
      const driver = it.view.program?.drives && app.playground.program();
      return driver ? (await import("../program/link.js")).shareProgram(driver) : "";
    },
    /** @param {boolean} dark */
    setDark: (dark) => session.set_dark(dark),
  };
}

/** Takes the last choices made in this browser, and with them the stored run. @param {MapSession} session */
function recall(session) {
  try {
    // The program is the one that is here, whichever it was then.
    session.restore(without(localStorage.getItem(CHOICES) ?? "", "program"));
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

/** Why the run has ended. @param {MapView} view @param {string} next */
function ended({ program, activity, known, is_sure: isSure }, next) {
  if (program) return activity || `The program has ended.${next}`;
  if (isSure === false && known === null) return "Done, but the robot is lost: its map shows too little of the room. Go back to the start.";
  if (isSure === false) return "Done, but the robot is lost. Test it again from another place, or go back to mapping.";
  if (activity === "battery empty") return `The battery is empty.${next}`;
  return `Done: the robot found nothing more to explore.${next}`;
}

/** Values that are neither numbers nor choices. @param {MapView} view */
function show(view) {
  const root = byId("panel-map");
  setAttribute(root, "data-phase", view.phase);
  setAttribute(root, "data-cleaning", String(view.is_cleaning));
  const goals = view.layers.includes("goals") && view.is_sure !== false ? [view.frontiers > 0 && "frontiers", view.has_route && "route"] : [];
  // A lost robot has many possible poses.
  const particles = (view.layers.includes("particles") || view.is_sure === false) && "particles";
  setAttribute(root, "data-drawn", [...goals, particles].filter(Boolean).join(" "));
  setHidden(byId("map-hint"), view.phase !== "ready");
  setHidden(byId("map-return"), view.returned === null);
  if (view.returned !== null) {
    const done = Math.floor(100 * view.returned);
    setText(byId("map-returned"), `${done} %`);
    if (changed(byId("map-return"), "done", done)) typed("map-return-bar", HTMLProgressElement).value = done;
  }
  setText(byId("map-room"), view.title);
  // A robot that has come to its end would look as if it hung.
  const isDone = view.phase === "finished" && view.time_s > 0;
  const next = view.can.clean ? " Next: clean with this map." : "";
  const done = ended(view, next);
  const activity = isDone && !view.is_cleaning ? done : view.activity;
  setText(byId("map-activity"), sentence(activity));
  const sure = view.is_sure === null ? "" : view.is_sure ? "Relocalised" : isDone || view.figures?.position_m === null ? "Lost" : "Relocalising";
  // The other badge says it.
  const isTwice = sure === "Relocalising" && view.activity.startsWith("relocalising");
  setHidden(byId("map-activity"), !activity || isTwice || !["playing", "paused", "finished"].includes(view.phase));
  setHidden(byId("map-held"), !view.is_carried);
  setHidden(byId("map-hint-new"), view.known !== null);
  setHidden(byId("map-hint-lost"), view.known === null);
  setHidden(byId("map-known"), view.known === null);
  setText(byId("map-known-name"), view.known ?? "");
  // At the end the other badge says it.
  setHidden(byId("map-sure"), !sure || view.phase === "ready" || activity.includes("robot is lost"));
  setText(byId("map-sure"), sure);
  // Beside the names there is room for one.
  setText(byId("map-doing"), view.phase === "ready" ? "" : sure || (isDone ? "" : sentence(activity)));
  setAttribute(byId("map-sure"), "data-sure", String(view.is_sure));
}
