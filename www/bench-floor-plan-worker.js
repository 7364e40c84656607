// @ts-check
// The tab Floor plan's share of the benchmark, in a fresh instance of its module: what it measures itself, then how long a
// large drawing takes from its file to the picture.
import init, { FloorPlanSession, bench_drawings, office_drawing } from "../floor_plan.js";

/** How many entities the drawing has; fewer if each case runs only once. */
const ENTITIES = { measured: 100_000, once: 10_000 };
/** The picture's size, px: that of a laptop's screen. */
const [WIDTH, HEIGHT] = [1280, 800];

/** @param {import("./worker-types").FromBench} message */
const answer = (message) => self.postMessage(message);

/** @param {number} entities @returns {import("./types").BenchResult} */
function draw(entities) {
  const files = [{ name: "office.dxf", bytes: office_drawing(entities) }];
  const canvas = new OffscreenCanvas(WIDTH, HEIGHT);
  const began = performance.now();
  const session = new FloorPlanSession(canvas);
  session.open(files, true);
  session.resize(WIDTH, HEIGHT, 1);
  session.draw(false);
  // Cached drawing commands have been executed by now.
  canvas.getContext("2d")?.getImageData(0, 0, 1, 1);
  const ms = performance.now() - began;
  session.free();
  return { name: `read, trace and draw ${entities.toLocaleString("en")} entities`, ms, times_real_time: null, memory_mb: null };
}

self.addEventListener("message", async (/** @type {MessageEvent<{ module: WebAssembly.Module, once: boolean }>} */ event) => {
  try {
    await init({ module_or_path: event.data.module });
    const results = bench_drawings(event.data.once, (/** @type {import("./types").BenchResult} */ result) => answer({ type: "result", result }));
    const drawn = draw(event.data.once ? ENTITIES.once : ENTITIES.measured);
    answer({ type: "result", result: drawn });
    answer({ type: "finished", results: [...results, drawn] });
  } catch (error) {
    answer({ type: "failed", message: error instanceof Error ? error.message : String(error) });
  }
});
