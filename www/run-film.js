// @ts-check
// A film of the run so far, frame by frame: smooth on any computer. Loaded when one is saved.
import { hideToast, toast } from "./messages.js";
import { atRest, drawShown, nextFrame, placeOf, sizeOf } from "./show.js";
import { webm } from "./webm.js";

/** @typedef {import("./main.js").App} App */

/** Frames a second, greatest width in pixels, bits a second. */
const [FPS, WIDTH, BITS] = [25, 1280, 4_000_000];
/** Longest film of a run, and how long its end is shown, s. */
const [LONGEST, HOLD] = [12, 1.5];
/** Every so many frames there is one that needs no other. */
const KEY = 50;
/** Frames that may wait for the encoder. */
const QUEUE = 8;

/** @type {[codec: string, id: "V_VP8" | "V_VP9"][]} */
const CODECS = [["vp09.00.31.08", "V_VP9"], ["vp8", "V_VP8"]];

/** Milliseconds of a film of a run of so many seconds. @param {number} end */
export const lengthOf = (end) => 1000 * (Math.min(LONGEST, end) + HOLD);

/** @param {App} app @returns {Promise<Blob | undefined>} `undefined` if it was given up. */
export async function film(app) {
  const floor = /** @type {HTMLCanvasElement} */ (document.getElementById("floor"));
  const size = sizeOf(app, floor, WIDTH);
  const { width, height } = size;
  const found = await supported(width, height);
  const { time_s: back, run_end_s: end, state } = app.view;
  // Before the first frame: a run that goes on ends the film.
  app.act((p) => p.pause());
  const [moving, all] = [Math.max(1, Math.round(FPS * Math.min(LONGEST, end))), Math.round((FPS * lengthOf(end)) / 1000)];

  /** @type {import("./webm.js").Chunk[]} */
  const chunks = [];
  /** @type {unknown} */
  let fault;
  const encoder = new VideoEncoder({
    output: (chunk) => {
      const bytes = new Uint8Array(chunk.byteLength);
      chunk.copyTo(bytes);
      chunks.push({ bytes, ms: Math.round(chunk.timestamp / 1000), isKey: chunk.type === "key" });
    },
    error: (error) => (fault = error),
  });
  encoder.configure({ codec: found[0], width, height, bitrate: BITS, framerate: FPS });
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { alpha: false });
  if (!context) throw new Error("this browser can't draw it");
  let isGivenUp = false;
  let place = "";
  const stop = (/** @type {KeyboardEvent} */ event) => event.key === "Escape" && (isGivenUp = true);
  addEventListener("keydown", stop);
  try {
    for (let i = 0; i < all && !isGivenUp; i += 1) {
      if (i <= moving) {
        const time = (end * i) / moving;
        if (!(await shown(app, time))) isGivenUp = true;
        if (placeOf(app) !== place) await atRest(app);
        place = placeOf(app);
        drawShown(app, floor, context, size);
      }
      const frame = new VideoFrame(canvas, { timestamp: (1e6 * i) / FPS, duration: 1e6 / FPS });
      encoder.encode(frame, { keyFrame: i % KEY === 0 });
      frame.close();
      while (encoder.encodeQueueSize > QUEUE && !fault) await nextFrame();
      if (fault) throw fault;
      if (i % FPS === 0) toast(`Making the film: ${Math.round((100 * i) / all)} %. Escape stops it.`, true);
    }
    if (isGivenUp) return undefined;
    await encoder.flush();
  } finally {
    removeEventListener("keydown", stop);
    if (encoder.state !== "closed") encoder.close();
    hideToast();
    app.act((p) => p.seek(back));
    if (state === "playing") app.act((p) => p.play());
  }
  return webm(chunks, { codec: found[1], width, height, ms: lengthOf(end) });
}

/** The first codec that this browser can write. @param {number} width @param {number} height */
async function supported(width, height) {
  if (typeof VideoEncoder === "function") {
    for (const codec of CODECS) {
      const { supported: can } = await VideoEncoder.isConfigSupported({ codec: codec[0], width, height, bitrate: BITS, framerate: FPS }).catch(() => ({ supported: false }));
      if (can) return codec;
    }
  }
  throw new Error("this browser can't write films; recent versions of Chrome, Edge, Firefox and Safari can");
}

/** Waits until that moment of the run is drawn; says whether it is. @param {App} app @param {number} time */
async function shown(app, time) {
  if (!app.act((p) => p.seek(time))) return false;
  do {
    await nextFrame();
    // Somebody goes on with the run, or begins another.
    if (["playing", "planning", "failed"].includes(app.view.state)) return false;
  } while (app.view.state === "seeking");
  return true;
}
