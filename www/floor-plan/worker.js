// @ts-check
// The Floor plan tab's session, separate from the page: reads, traces, plans and draws. To cancel, the page ends this
// worker.
import init, { FloorPlanSession } from "../../floor_plan.js";
import { PANS } from "../shared/pan-zoom.js";
import { readable, TAKEN } from "../shared/pictures.js";

/** How long a stage of the sweep takes to be shown, ms. */
const STAGE_MS = 1600;
/** From when on the view stands still, ms. */
const REST_MS = 120;

/** @type {FloorPlanSession} */
let session;
/** The queue of tasks. */
let doing = Promise.resolve();
let isDrawing = false;
let isBroken = false;
/** Whether the code of a sweep has been compiled in advance. */
let isWarm = false;
let moved = -Infinity;
/** Stages that are still to be shown, and when the first of them began. @type {number[]} */
let stages = [];
let began = 0;

/** @param {import("./types").FromFloorPlan} message @param {Transferable[]} [transfer] */
const tell = (message, transfer = []) => self.postMessage(message, { transfer });
/** @type {(what: (now: number) => void) => void} */
const nextFrame = self.requestAnimationFrame ? (what) => void self.requestAnimationFrame(what) : (what) => void setTimeout(() => what(performance.now()), 16);

/** @param {unknown} error */
function broke(error) {
  isBroken = true;
  tell({ type: "broken", message: error instanceof Error ? error.message : String(error) });
}

function draw() {
  if (isDrawing || isBroken) return;
  isDrawing = true;
  nextFrame((now) => {
    isDrawing = false;
    try {
      animate(now);
      const hurries = performance.now() - moved < REST_MS;
      if (session.draw(hurries)) setTimeout(draw, REST_MS);
    } catch (error) {
      broke(error);
    }
  });
}

/** @param {number} now */
function animate(now) {
  const [stage] = stages;
  if (stage === undefined) return;
  if (!began) {
    began = now;
    session.show_stage(stage, 0);
    // Its button is pressed while one sees it, not afterwards.
    show();
  }
  const share = (now - began) / STAGE_MS;
  session.show_stage(stage, share);
  if (share >= 1) {
    stages.shift();
    began = 0;
    show();
  }
  setTimeout(draw);
}

const show = () => tell({ type: "view", view: session.view() });

/** @param {File[]} files */
async function read(files) {
  try {
    return await readable(files, Infinity);
  } catch (error) {
    if (typeof error === "string") throw error;
    // Files that the browser can't read: folders, deleted files.
    throw `The file could not be read (${error instanceof Error ? error.message : error}). Choose a file rather than a folder. ${TAKEN}`;
  }
}

/** @param {import("./types").Request} request @returns {Promise<unknown>} */
async function answer(request) {
  switch (request.type) {
    case "restore":
    case "open":
      session.open(await read(request.files), request.type === "open");
      stages = [];
      return request.type === "restore" && session.set({ ...session.view()?.settings, ...request.settings });
    case "set":
      // On top of what the hand has chosen on the canvas meanwhile.
      return session.set({ ...session.view()?.settings, ...request.settings });
    case "scale":
      return session.scale_to(request.metres);
    case "turn":
      return session.turn_to(request.degrees);
    case "sweep":
      return session.sweep((/** @type {number} */ done) => tell({ type: "progress", done }));
    case "slice":
      return session.show_slice(request.heading);
    case "export":
      return session.export(request.format);
    case "room":
      return session.room(request.sweeps);
  }
}

/** Executes a message of the page; returns whether more than the picture can have changed. @param {import("./types").Said} said */
function hear(said) {
  if (["pan", "zoom", "pointer", "key"].includes(said.type)) moved = performance.now();
  switch (said.type) {
    case "tool":
      session.set_tool(said.tool);
      return true;
    case "stages":
      [stages, began] = [said.moves ? said.stages : [], 0];
      if (!said.moves) session.show_stage(said.stages.at(-1) ?? 0, 1);
      return true;
    case "pointer":
      return session.pointer(said.kind, said.x, said.y);
    case "key": {
      const isUsed = session.key(said.action, said.fine);
      const pan = PANS[said.action];
      if (!isUsed && pan) session.pan(...pan);
      return isUsed;
    }
    case "pan":
      return void session.pan(said.dx, said.dy);
    case "zoom":
      return void session.zoom(said.x, said.y, said.factor);
    case "fit":
      return void session.fit();
    case "clear":
      return void session.keep_clear(said.height);
    case "resize":
      return void session.resize(said.width, said.height, said.ratio);
    case "dark":
      return void session.set_dark(said.dark);
  }
}

/** @param {import("./types").ToFloorPlan} message */
async function take(message) {
  if (isBroken) return;
  if (message.type === "init") {
    await init({ module_or_path: message.module });
    session = new FloorPlanSession(message.canvas);
  } else if ("id" in message) {
    const { id } = message;
    try {
      const result = await answer(message);
      tell({ type: "answer", id, result, view: session.view() });
      if (!isWarm) setTimeout(() => FloorPlanSession.warm_up(), REST_MS);
      isWarm = true;
    } catch (error) {
      // Rust throws messages for users; anything else is a mistake of ours.
      if (error instanceof Error) throw error;
      tell({ type: "refusal", id, message: String(error), view: session.view() });
    }
  } else if (hear(message)) show();
  draw();
}

self.addEventListener("message", (/** @type {MessageEvent<import("./types").ToFloorPlan>} */ { data }) => {
  doing = doing.then(() => take(data)).catch(broke);
});
