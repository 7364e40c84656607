// What a frame of the page costs: processor time of the main thread a frame, at every speed, and its longest tasks.
//   node scripts/frames.mjs [FRAMES [ROOM]]
// Processor time doesn't count what other programs do meanwhile; frames a second and longest tasks do.
import { DIST, launchBrowser, serveFolder } from "../tests/e2e/browser.mjs";

const [frames = 300, room = "flat"] = [Number(process.argv[2] ?? 300), process.argv[3]];
/** Speeds of the menu; 0 is as fast as possible. */
const SPEEDS = [1, 16, 64, 0];

const server = await serveFolder(DIST);
const browser = await launchBrowser();
console.log(`Room ${room}, 1440 × 900, ${frames} frames at each speed`);
console.log("speed   frames/s   ms a frame: all  script  style  layout   tasks over 50 ms (longest)");
for (const speed of SPEEDS) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, serviceWorkers: "block" });
  const page = await context.newPage();
  const client = await context.newCDPSession(page);
  await client.send("Performance.setTimeDomain", { timeDomain: "threadTicks" });
  await client.send("Performance.enable");
  await page.goto(`${server.url}#room=${room}&planner=boustrophedon&speed=${speed || 64}`);
  await page.waitForFunction(() => document.body.dataset.state === "playing");
  // What is loaded with the first input is there before anything is counted.
  await page.mouse.move(300, 300);
  await page.waitForLoadState("networkidle");
  await page.evaluate(() => {
    window.long = [];
    new PerformanceObserver((list) => window.long.push(...list.getEntries().map(({ duration }) => duration))).observe({ type: "longtask" });
  });
  if (speed === 0) await page.locator("#speed").selectOption("0");
  const metrics = async () => Object.fromEntries((await client.send("Performance.getMetrics")).metrics.map(({ name, value }) => [name, value]));
  const before = await metrics();
  const { drawn, seconds } = await page.evaluate(async (most) => {
    const start = performance.now();
    let drawn = 0;
    while (drawn < most && document.body.dataset.state === "playing") {
      await new Promise((done) => requestAnimationFrame(done));
      drawn += 1;
    }
    return { drawn, seconds: (performance.now() - start) / 1000 };
  }, frames);
  const after = await metrics();
  const long = await page.evaluate(() => window.long);
  const each = (name) => ((1000 * (after[name] - before[name])) / drawn).toFixed(2);
  const columns = [String(speed || "max").padEnd(5), (drawn / seconds).toFixed(1).padStart(8), each("TaskDuration").padStart(16), each("ScriptDuration").padStart(7), each("RecalcStyleDuration").padStart(6), each("LayoutDuration").padStart(7)];
  console.log(`${columns.join(" ")}   ${long.length} (${long.length > 0 ? `${Math.max(...long)} ms` : "none"})`);
  await context.close();
}
await browser.close();
await server.close();
