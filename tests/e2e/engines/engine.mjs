// A browser of any make, by the few things that its users do. Firefox and WebKit differ only in how they are started.
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import { ROOT } from "../browser.mjs";

/** Keys as WebDriver names them; others are their own names. */
const KEYS = { Space: " ", Tab: "\uE004", Enter: "\uE007", Shift: "\uE008", Control: "\uE009", Escape: "\uE00C", PageDown: "\uE00F", End: "\uE010", ArrowRight: "\uE014" };
const ELEMENT = "element-6066-11e4-a52e-4f735466cecf";

/** How long a condition is waited for, ms. */
const PATIENCE_MS = 30_000;

/** Where the first of these programs is. */
export function findProgram(...names) {
  const { status, stdout } = spawnSync("sh", ["-c", 'for name; do command -v "$name" && exit; done; exit 1', "sh", ...names], { encoding: "utf8" });
  if (status !== 0) throw new Error(`${names[0]} is missing: ./dev tools installs it`);
  return stdout.trim();
}

export class Engine {
  /**
   * @param {(name: string, parameters?: object) => Promise<any>} send Sends a WebDriver command.
   * @param {() => Promise<void>} close
   */
  constructor(send, close) {
    Object.assign(this, { send, close });
  }

  async open(url) {
    await this.send("SetTimeouts", { script: 2 * PATIENCE_MS });
    await this.send("Navigate", { url });
    // A busy WebKit may still show the page before, which must not be asked anything.
    await this.until((origin) => location.origin === origin, new URL(url).origin);
  }

  reload() {
    return this.send("Refresh");
  }

  /** What a function, called in the page, returns or promises. */
  async evaluate(what, ...args) {
    const script = `const [args, done] = arguments;
      new Promise((resolve) => resolve((${what})(...args))).then((value) => done({ value }), (error) => done({ error: \`\${error} \${error?.stack}\` }));`;
    const { value, error } = await this.send("ExecuteAsyncScript", { script, args: [args] });
    if (error) throw new Error(error);
    return value;
  }

  /** Waits until what a function returns in the page is true, and returns it. */
  async until(fits, ...args) {
    const wait = `async (...args) => {
      const patience = performance.now() + ${PATIENCE_MS};
      for (;;) {
        const value = await (${fits})(...args);
        if (value) return value;
        if (performance.now() > patience) throw new Error("waited in vain for " + ${JSON.stringify(String(fits))} + " with " + JSON.stringify(args));
        await new Promise((later) => setTimeout(later, 20));
      }
    }`;
    try {
      return await this.evaluate(wait, ...args);
    } catch (error) {
      // WebKit may have asked the page that was about to be left.
      if (!/before the unload event/.test(String(error))) throw error;
      return this.evaluate(wait, ...args);
    }
  }

  async #find(selector) {
    return (await this.send("FindElement", { using: "css selector", value: selector }))[ELEMENT];
  }

  async click(selector) {
    await this.send("ElementClick", { id: await this.#find(selector) });
  }

  /** Chooses from a menu. */
  async choose(menu, value) {
    await this.evaluate((selector, wanted) => {
      const node = document.querySelector(selector);
      node.value = wanted;
      node.dispatchEvent(new Event("change", { bubbles: true }));
    }, menu, value);
  }

  /** Presses keys one after the other, such as "w" or "Control+z". */
  async press(...chords) {
    const actions = chords.flatMap((chord) => {
      const keys = chord.split("+").map((name) => KEYS[name] ?? name);
      return [...keys.map((value) => ({ type: "keyDown", value })), ...keys.reverse().map((value) => ({ type: "keyUp", value }))];
    });
    await this.send("PerformActions", { actions: [{ type: "key", id: "keyboard", actions }] });
  }

  /** Chooses a file of this computer for a file input. */
  async pick(selector, file) {
    await this.send("ElementSendKeys", { id: await this.#find(selector), text: file });
  }

  async screenshot(name) {
    const folder = path.join(ROOT, "target/e2e");
    fs.mkdirSync(folder, { recursive: true });
    fs.writeFileSync(path.join(folder, `${name}.png`), Buffer.from(await this.send("TakeScreenshot", { full: false }), "base64"));
  }
}
