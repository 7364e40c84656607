// How quickly lessons open: Learn with the first one, when nothing of it is loaded, and each from the list after that. Needs dist/.
import { launchBrowser, serveFolder } from "../tests/e2e/browser.mjs";

const server = await serveFolder("dist");
const browser = await launchBrowser();
const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
page.setDefaultTimeout(120_000);
await page.goto(`${server.url}#room=living&behaviour=bounce`);
await page.waitForFunction(() => ["ready", "playing", "paused"].includes(document.body.dataset.state ?? ""));

/** Milliseconds from a click to the frame that shows what comes of it. */
const took = (clicked, shown) =>
  page.evaluate(
    async ([clicked, shown]) => {
      const began = performance.now();
      document.querySelector(clicked).click();
      do await new Promise(requestAnimationFrame);
      while (!document.querySelector(shown));
      await new Promise(requestAnimationFrame);
      return performance.now() - began;
    },
    [clicked, shown],
  );

const list = await took("#learn-open", "#learn .lessons button");
const lesson = (number) => took(`#learn .lessons li:nth-child(${number}) button`, "#learn .outcomes");
const first = await lesson(1);
const times = [];
for (let number = 1; number <= 10; number += 1) {
  await took("#learn [aria-label='All lessons']", "#learn .lessons button");
  times.push(await lesson(number));
}
console.log(`    Learn shows its list after ${Math.round(list)} ms, and the first lesson ${Math.round(first)} ms after a click`);
console.log(`    From the list, lessons open in ${times.map(Math.round).join(", ")} ms`);
await browser.close();
await server.close();
