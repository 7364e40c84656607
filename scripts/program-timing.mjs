// How quickly the tab Program answers: Run, Stop, and looks at other times of a long run. Needs dist/.
import { launchBrowser, serveFolder } from "../tests/e2e/browser.mjs";

const ROUNDS = 11;

const server = await serveFolder("dist");
const browser = await launchBrowser();
const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
page.setDefaultTimeout(120_000);

const shown = (times) => {
  const sorted = times.toSorted((a, b) => a - b).map(Math.round);
  return `median ${sorted[sorted.length >> 1]} ms, longest ${sorted.at(-1)} ms`;
};
const status = (text) => page.waitForFunction((start) => document.getElementById("program-status")?.textContent.startsWith(start), text);
async function open(script, more = "") {
  await page.goto("about:blank");
  await page.goto(`${server.url}#room=flat&robot=roomba600&tab=program&script=${script}${more}`);
  await status("Change a number");
}

/** Presses Run, often: until the robot has the first commands of the new run. */
const restarts = (rounds) =>
  page.evaluate(async (count) => {
    const [button, text] = ["program-run", "program-status"].map((id) => document.getElementById(id));
    const frame = () => new Promise(requestAnimationFrame);
    const took = [];
    for (let round = 0; round < count; round += 1) {
      const began = performance.now();
      button.click();
      await frame();
      do await frame();
      while (!text.textContent.startsWith("Change a number"));
      took.push(performance.now() - began);
    }
    return took;
  }, rounds);

/** Writes a program and runs it. @param {string} source */
async function run(source) {
  await page.locator(".cm-content").click();
  await page.keyboard.press("ControlOrMeta+a");
  await page.keyboard.insertText(source);
  await page.locator("#program-run").click();
}

/** Stops by the mouse: from the press until the page shows it. */
async function stop() {
  const took = page.evaluate(
    () =>
      new Promise((done) => {
        document.getElementById("program-stop").addEventListener("click", (event) => {
          const look = () => (document.getElementById("program-stop").disabled ? done(performance.now() - event.timeStamp) : requestAnimationFrame(look));
          requestAnimationFrame(look);
        }, { once: true });
      }),
  );
  await page.locator("#program-stop").click();
  return took;
}

for (const [language, ending] of [["Python", "python"], ["JavaScript", "javascript"]]) {
  await open(`turn_when_you_bump.${ending}`);
  const [, ...took] = await restarts(ROUNDS + 1);
  console.log(`    ${language}: Run restarts after ${shown(took)}`);
}

await open("turn_when_you_bump.python");
const stops = [];
for (let round = 0; round < ROUNDS; round += 1) {
  await run("def step(robot):\n    robot.go(0.1)\n    if robot.time > 60:\n        while True: pass\n");
  // Until the loop, which is then given a second.
  await page.waitForTimeout(300);
  stops.push(await stop());
}
console.log(`    Stop answers after ${shown(stops)}, in an endless loop`);

for (const [language, ending] of [["Python", "python"], ["JavaScript", "javascript"]]) {
  await open(`follow_the_wall.${ending}`, "&speed=0");
  await page.waitForFunction(() => document.getElementById("n-time").textContent.split(":").reduce((sum, part) => 60 * sum + Number(part), 0) > 1860);
  if ((await page.evaluate(() => document.body.dataset.state)) === "playing") await page.locator("#play").click();
  await page.evaluate(() => (document.getElementById("program-watch").open = true));
  await page.waitForFunction(() => document.getElementById("program-moment").textContent !== "");
  const took = [];
  // Of the time line, whose end the run needn't have reached.
  for (const share of [0.5, 0.1, 0.45, 0.05, 0.3]) {
    const [before, box] = [await page.locator("#program-moment").textContent(), await page.locator("#scrubber").boundingBox()];
    const began = performance.now();
    await page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
    await page.waitForFunction((text) => document.getElementById("program-moment").textContent !== text, before);
    took.push(`${Math.round(100 * share)} % ${Math.round(performance.now() - began)} ms`);
  }
  console.log(`    ${language}: variables at shares of a time line of half an hour and more, one after the other: ${took.join(", ")}`);
}

await browser.close();
await server.close();
