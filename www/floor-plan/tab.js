// @ts-check
// The tab Floor plan: an opened file is viewed, scaled, traced and swept before it becomes the room of Explore.
import { button, byId, input, setAttribute, setHidden, setText, typed } from "../dom.js";
import { fileName } from "../files.js";
import { complain, forgive, textOf, toast } from "../messages.js";
import { startSheets } from "../sheets.js";
import { startBody } from "./body.js";
import { startCanvas } from "./canvas.js";
import { CANCELLED, FloorPlanClient } from "./client.js";
import { startFacts } from "./facts.js";
import { takeCommas } from "./fields.js";
import { startKeeping } from "./keep.js";
import { startLayers } from "./layers.js";
import { startScale } from "./scale.js";
import { startSweep } from "./sweep.js";
import { startTurn } from "./turn.js";
import { startUndo } from "./undo.js";
import { startWalls } from "./walls.js";

/**
 * @typedef {import("./types").FloorPlanView} FloorPlanView
 * @typedef {object} FloorPlanTab What the modules of this tab share.
 * @property {import("../main.js").App} app
 * @property {FloorPlanClient} client
 * @property {FloorPlanView | undefined} view The latest view; `undefined` without a file.
 * @property {(request: import("./types").Request, doing: string, refused?: (why: string) => void) => Promise<{ result: unknown } | undefined>} ask `undefined` if it was refused, which is reported, or cancelled.
 * @property {() => import("./types").FloorPlanSettings | undefined} wanted The settings, with those not yet applied by
 * the worker.
 * @property {(change: Partial<import("./types").FloorPlanSettings>) => Promise<unknown>} set Chooses.
 * @property {(sweeps: boolean) => Promise<void>} use Makes the floor plan the room of Explore.
 * @property {(withFocus: boolean) => void} toCanvas Closes the sheet over the canvas; may go there by keyboard too.
 */

/** Larger files can't be a floor plan that is taken. */
const MOST_BYTES = 64 * 2 ** 20;
/** Tasks up to this duration aren't announced, ms. */
const PATIENCE_MS = 250;

/** @param {import("../main.js").App} app @param {WebAssembly.Module} module */
export function startFloorPlan(app, module) {
  const client = new FloorPlanClient(module);
  const root = byId("panel-floor-plan");
  let isDark = false;
  /** Names of current tasks, the oldest first. @type {string[]} */
  const doing = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;

  const showDoing = () => {
    clearTimeout(waiting);
    setAttribute(root, "aria-busy", String(doing.length > 0));
    if (doing.length === 0) return setHidden(byId("floor-plan-busy"), true);
    waiting = setTimeout(() => {
      setText(byId("floor-plan-doing"), `${doing[0]}…`);
      typed("floor-plan-progress", HTMLProgressElement).removeAttribute("value");
      setHidden(byId("floor-plan-busy"), false);
    }, PATIENCE_MS);
  };

  /** Settings sent and not yet applied. @type {Partial<import("./types").FloorPlanSettings>} */
  let chosen = {};
  /** Files being opened: settings changed meanwhile belong to the earlier ones. */
  let opening = 0;

  /** @type {FloorPlanTab} */
  const it = {
    app,
    client,
    view: undefined,
    ask: async (request, what, refused = complain) => {
      doing.push(what);
      if (doing.length === 1) showDoing();
      try {
        const result = await client.ask(request);
        // An earlier error is still to be read.
        if (request.type !== "restore") forgive();
        return { result };
      } catch (error) {
        if (error !== CANCELLED) refused(textOf(error));
        return undefined;
      } finally {
        doing.shift();
        showDoing();
      }
    },
    wanted: () => it.view && { ...it.view.settings, ...chosen },
    set: async (change) => {
      if (!it.view || opening > 0) return;
      const mine = (chosen = { ...chosen, ...change });
      await it.ask({ type: "set", settings: change }, it.view.kind === "drawing" ? "Tracing the room" : "Reading the map");
      if (chosen === mine) chosen = {};
    },
    use: async (sweeps) => {
      const answer = await it.ask({ type: "room", sweeps }, "Making the room");
      if (!answer || !app.act((p) => p.take_map(/** @type {Uint8Array} */ (answer.result)))) return;
      const isAssumed = it.view?.assumes_size === true;
      toast(`Loaded ${client.files.map((file) => file.name).join(" and ")}${isAssumed ? ". Its size is only assumed: set it in Floor plan" : ""}`);
      byId("tab-explore").click();
    },
    toCanvas: (withFocus) => {
      /** @type {HTMLElement | null} */ (root.querySelector("[data-sheet][aria-expanded=true]"))?.click();
      if (withFocus) byId("floor-plan-floor").focus();
    },
  };

  let taken = 0;
  /** Opens files; says whether it worked. @param {File[]} files */
  const take = async (files) => {
    if (files.length === 0) return true;
    const names = files.map((file) => file.name).join(" and ");
    const large = files.find((file) => file.size > MOST_BYTES);
    if (large) complain(`${large.name} is larger than 64 MB. Save a smaller picture, or a map of at most 4096 cells a side.`);
    else [opening, chosen] = [opening + 1, {}];
    byId("floor-plan-settings").inert = opening > 0;
    const isOpen = !large && (await it.ask({ type: "open", files }, `Reading ${names}`));
    if (!large) opening -= 1;
    byId("floor-plan-settings").inert = opening > 0;
    // Tests wait for this.
    root.dataset.taken = `${++taken} ${isOpen ? "open" : "refused"}`;
    return Boolean(isOpen);
  };

  takeCommas(root);
  const updates = [startFacts, startScale, startTurn, startLayers, startWalls, startBody, startSweep, startUndo].map((begin) => begin(it));
  const picture = startCanvas(it);
  const keeping = startKeeping(it);
  client.onstart = (canvas) => {
    picture.onStage(canvas);
    client.say({ type: "dark", dark: isDark });
  };
  client.onview = (view) => {
    it.view = view;
    for (const update of updates) update(view);
    keeping.saw();
  };
  client.onprogress = (done) => setAttribute(byId("floor-plan-progress"), "value", String(Math.floor(100 * done)));
  client.onrestore = (request) => void it.ask(request, "Restoring the floor plan");
  client.onbroken = (message, returns) => keeping.broke(message) || complain(`Internal error in Floor plan (${message}). ${returns ? "Your floor plan is being restored" : "Open the file again, or another one"}; Explore is not affected.`);
  client.start();
  client.onview(undefined);
  void keeping.bring(() => opening === 0 && taken === 0);

  button("floor-plan-cancel").addEventListener("click", () => client.cancel());
  button("floor-plan-use").addEventListener("click", () => void it.use(false));
  for (const node of root.querySelectorAll("[data-floor-plan=choose]")) node.addEventListener("click", () => input("files").click());
  for (const node of root.querySelectorAll("[data-floor-plan=explore]")) {
    node.addEventListener("click", () => {
      app.act((p) => void take([new File([p.scenario_json()], `${fileName(app.view.room.title)}.json`)]));
    });
  }
  byId("floor-plan-sample").addEventListener("click", async () => {
    const response = await fetch(new URL("./sample.dxf", import.meta.url)).catch(() => undefined);
    if (response?.ok) await take([new File([await response.blob()], "sample flat.dxf")]);
    else complain("The sample could not be loaded. Check the connection, then try again.");
  });
  startSheets(root, byId("floor-plan-stage"));

  return {
    take,
    frame() {
      picture.clear();
      return { message: "", message_kind: "" };
    },
    key: picture.key,
    link: () => "tab=floor-plan",
    restore() {},
    /** @param {boolean} dark */
    setDark(dark) {
      isDark = dark;
      client.say({ type: "dark", dark });
    },
  };
}
