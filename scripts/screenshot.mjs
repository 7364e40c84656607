// Takes docs/screenshot.png, the picture of the README and of links to the page, from the built page (./dev build):
//   node scripts/screenshot.mjs
import path from "node:path";
import { DIST, ROOT, launchBrowser, serveFolder } from "../tests/e2e/browser.mjs";

const server = await serveFolder(DIST);
const browser = await launchBrowser();
const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, colorScheme: "light" });
await page.goto(server.url);
// What comes with the first input belongs to the picture; the opening scene goes on until the robot has swept a good part.
await page.mouse.move(720, 450);
await page.waitForLoadState("networkidle");
const speed = await page.locator("#speed").inputValue();
await page.locator("#speed").selectOption("256");
await page.waitForFunction(() => Number(document.getElementById("n-coverage")?.textContent) >= 60);
await page.locator("#play").click();
await page.locator("#speed").selectOption(speed);
await page.mouse.move(0, 0);
await page.screenshot({ path: path.join(ROOT, "docs/screenshot.png") });
await browser.close();
await server.close();
