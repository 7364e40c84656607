// What a stream of all sensor readings at full rate costs the page: processor time of its threads with a robot connected
// through a bridge and standing still, less that of the same page with nothing connected. Linux; needs dist/.
import fs from "node:fs";
import { launchBrowser, serveFolder } from "../tests/e2e/browser.mjs";
import { startBus } from "../tests/e2e/serial/bus.mjs";
import { Robot } from "../tests/e2e/serial/robot.mjs";

const SECONDS = 20;
/** Length of a tick of /proc/*\/stat, s. */
const TICK = 0.01;

const ends = [];
const t = { after: (end) => ends.push(end) };
const robot = await Robot.start(t);
const bus = await startBus(t, [robot]);
const server = await serveFolder("dist");
const browser = await launchBrowser();
const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
await page.goto(`${server.url}#tab=connection&room=flat`);
await page.waitForSelector("#panel-connection:not([hidden])");

/** Processor time of the browser's renderers so far, s. */
function used() {
  let ticks = 0;
  for (const pid of fs.readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      if (!fs.readFileSync(`/proc/${pid}/cmdline`, "utf8").includes("--type=renderer")) continue;
      const stat = fs.readFileSync(`/proc/${pid}/stat`, "utf8");
      const fields = stat.slice(stat.lastIndexOf(")") + 2).split(" ");
      ticks += Number(fields[11]) + Number(fields[12]);
    } catch {
      // It has ended meanwhile.
    }
  }
  return ticks * TICK;
}

/** Share of a core, in percent. */
async function share() {
  await page.waitForTimeout(2000);
  const [before, began] = [used(), performance.now()];
  await page.waitForTimeout(1000 * SECONDS);
  return (1e5 * (used() - before)) / (performance.now() - began);
}

const without = await share();
await page.click(".connection-bridge summary");
await page.fill("#connection-url", `${bus.url}/0`);
await page.press("#connection-url", "Enter");
await page.waitForFunction(() => document.querySelector("#panel-connection")?.textContent?.includes("connected"));
const connected = await share();
console.log(`    page with nothing connected  ${without.toFixed(1)} % of a core`);
console.log(`    page with a robot streaming  ${connected.toFixed(1)} % of a core`);
console.log(`    so the stream costs          ${(connected - without).toFixed(1)} % of a core`);

await browser.close();
for (const end of ends.reverse()) await end();
await server.close();
