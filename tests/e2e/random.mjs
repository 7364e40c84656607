// Random actions over all tabs of the built page: buttons, menus, fields, keys, hands on the floor, back and forward. What
// goes wrong is told with the actions before it.
//   node tests/e2e/random.mjs [ACTIONS [SEED]]      10,000 actions in all, at three sizes
// The same seed chooses the same actions as long as the page shows the same when they are chosen.
import path from "node:path";
import { fileURLToPath } from "node:url";
import { DIST, launchBrowser, serveFolder, withoutServiceWorkers } from "./browser.mjs";

/** A laptop, a tablet, a phone. */
export const SIZES = [
  { viewport: { width: 1440, height: 900 } },
  { viewport: { width: 820, height: 1180 }, hasTouch: true },
  { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
];
const KEYS = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Enter", "Escape", "Tab", " ", "Delete", ".", "+", "-", "0", "?", ..."rvwesonpltdabcm"];
/** Most of what follows a tab's choice happens in it. */
const TABS = ["explore", "program", "compare", "map", "floor-plan", "connection"];
/** How many actions are told when something goes wrong. */
const TOLD = 25;
/** Actions after which the page is opened afresh: people do so, too, and what is kept is read again. */
const RELOAD = 400;

/** Numbers from 0 to 1 (mulberry32). */
function seeded(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** In the page: everything that a hand reaches now. */
function withinReach() {
  const found = [];
  const root = document.querySelector("dialog[open]") ?? document.body;
  for (const node of root.querySelectorAll("button, select, input, summary, textarea, canvas, a[href^='#'], [role=slider]")) {
    if (node.disabled || node.closest("[inert]") || ["update", "cover-reload"].includes(node.id)) continue;
    const { left, top, width, height } = node.getBoundingClientRect();
    const [x, y] = [left + width / 2, top + height / 2];
    if (width < 4 || height < 4 || x < 0 || y < 0 || x >= innerWidth || y >= innerHeight) continue;
    const top_ = document.elementFromPoint(x, y);
    if (!top_ || (node !== top_ && !node.contains(top_) && !top_.closest("label")?.contains(node))) continue;
    const kind = node.localName === "input" ? node.type : node.localName;
    const name = node.id || node.ariaLabel || node.textContent?.trim().slice(0, 30) || node.className;
    const options = node.localName === "select" ? [...node.options].filter((option) => !option.disabled).length : 0;
    found.push({ kind, name, x, y, left, top, width, height, options, index: found.length, min: node.min, max: node.max });
    window.reached ??= [];
    window.reached[found.length - 1] = node;
  }
  return found;
}

/**
 * Does `count` random things on `page`, which shows the playground at `url`. Stops at the first problem in `problems`.
 * @returns {Promise<string[]>} What was done last.
 */
export async function actAtRandom(page, url, { count, seed, problems, progress = () => {} }) {
  const random = seeded(seed);
  const pick = (list) => list[Math.floor(random() * list.length)];
  const done = [];
  const act = async (what, how) => {
    done.push(what);
    // What has gone away meanwhile can't be used: that is no fault.
    await how().catch((error) => done.push(`  (${String(error.message).split("\n")[0]})`));
  };
  for (let i = 0; i < count && problems.length === 0; i += 1) {
    if (i % RELOAD === RELOAD - 1) await act("reload", () => page.reload());
    const dice = random();
    const spots = await page.evaluate(withinReach).catch(() => []);
    const floor = spots.find(({ kind }) => kind === "canvas");
    if (dice < 0.04) {
      const tab = pick(TABS);
      await act(`tab ${tab}`, () => page.evaluate((name) => document.querySelector("dialog[open]") ?? document.getElementById(`tab-${name}`).click(), tab));
    } else if (dice < 0.06) {
      const way = pick(["goBack", "goForward"]);
      // Never back to where the page wasn't yet.
      await act(way, () => page.evaluate((by) => history.length > 3 && history.go(by), way === "goBack" ? -1 : 1));
    } else if (dice < 0.16) {
      const key = pick(KEYS);
      const modifier = random() < 0.15 ? pick(["Shift+", "Control+z|"]) : "";
      const press = modifier === "Control+z|" ? "Control+z" : modifier + key;
      await act(`key ${press}`, () => page.keyboard.press(press));
    } else if (dice < 0.3 && floor) {
      const spot = () => [floor.left + random() * floor.width, floor.top + random() * floor.height];
      const [from, to] = [spot(), spot()];
      if (random() < 0.2) {
        const turns = Math.round(600 * (random() - 0.5));
        await act(`wheel ${turns}`, () => page.mouse.move(...from).then(() => page.mouse.wheel(0, turns)));
      } else {
        await act(`drag ${from.map(Math.round)} to ${to.map(Math.round)}`, async () => {
          await page.mouse.move(...from);
          await page.mouse.down();
          if (random() < 0.6) await page.mouse.move(...to, { steps: 3 });
          await page.mouse.up();
        });
      }
    } else {
      const at = pick(spots.filter(({ kind }) => kind !== "canvas"));
      if (!at) {
        await act("key Escape", () => page.keyboard.press("Escape"));
        continue;
      }
      const choose = random();
      if (at.kind === "select") {
        const which = Math.floor(choose * at.options);
        await act(`${at.name}: option ${which}`, () => page.evaluate(([index, option]) => {
          const menu = window.reached[index];
          menu.selectedIndex = option;
          menu.dispatchEvent(new Event("input", { bubbles: true }));
          menu.dispatchEvent(new Event("change", { bubbles: true }));
        }, [at.index, which]));
      } else if (["number", "text", "search", "range", "textarea", "time"].includes(at.kind)) {
        const [low, high] = [Number(at.min || 0), Number(at.max || 100)];
        const value = at.kind === "time" ? "07:30" : random() < 0.15 ? pick(["", "-1", "1e9", "0"]) : String(+(low + choose * (high - low)).toFixed(2));
        await act(`${at.name} = ${value}`, () => page.evaluate(([index, text]) => {
          const field = window.reached[index];
          if (field.readOnly) return;
          field.value = text;
          field.dispatchEvent(new Event("input", { bubbles: true }));
          field.dispatchEvent(new Event("change", { bubbles: true }));
        }, [at.index, value]));
      } else await act(`click ${at.name}`, () => page.mouse.click(at.x, at.y));
    }
    // A frame, so that what was done is drawn.
    await page.evaluate(() => new Promise((next) => requestAnimationFrame(next))).catch(() => {});
    const boot = await page.evaluate(() => document.body?.dataset.boot).catch(() => "ready");
    if (boot === "failed") problems.push("the simulator has stopped");
    progress(i + 1);
  }
  return done.slice(-TOLD);
}

/** Reports what goes wrong on the pages of a context. @param {import("playwright-core").BrowserContext} context @param {string[]} problems */
export function watch(context, problems) {
  context.on("console", (message) => message.type() === "error" && problems.push(`console: ${message.text()} (${message.location().url})`));
  context.on("weberror", (error) => problems.push(`uncaught: ${error.error().stack || String(error.error())}`));
}

/** Nothing that a page can't take back: no printer, no download. */
export const QUIET = () => {
  window.print = () => {};
};

async function main() {
  const [count = 10_000, seed = Math.floor(Math.random() * 1e6)] = process.argv.slice(2).map(Number);
  const server = await serveFolder(DIST);
  const browser = await launchBrowser();
  console.log(`${count} actions with seed ${seed}`);
  for (const [index, size] of SIZES.entries()) {
    const context = await browser.newContext({ ...size, acceptDownloads: false });
    await withoutServiceWorkers(context);
    await context.addInitScript(QUIET);
    const problems = [];
    watch(context, problems);
    const page = await context.newPage();
    page.setDefaultTimeout(30_000);
    page.on("dialog", (dialog) => void dialog.dismiss());
    context.on("page", (other) => other !== page && void other.close());
    await page.goto(server.url);
    const each = Math.ceil(count / SIZES.length);
    const last = await actAtRandom(page, server.url, { count: each, seed: seed + index, problems, progress: (n) => n % 500 === 0 && console.log(`    ${size.viewport.width} × ${size.viewport.height}: ${n}`) });
    await context.close();
    if (problems.length === 0) continue;
    console.error(`error: at ${size.viewport.width} × ${size.viewport.height}:\n${problems.join("\n")}\nafter\n  ${last.join("\n  ")}`);
    process.exitCode = 1;
  }
  await browser.close();
  await server.close();
  if (!process.exitCode) console.log(`${count} actions, no error`);
}

if (process.argv[1] && path.resolve(process.argv[1]) === fileURLToPath(import.meta.url)) await main();
