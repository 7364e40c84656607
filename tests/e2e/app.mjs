// The page as its users know it: what they can do with it, and what they read on it.
import assert from "node:assert/strict";
import { openPage } from "./harness.mjs";

/** States in which nothing is left to wait for. */
const SETTLED = ["ready", "playing", "paused", "finished", "failed"];

/** How long a condition is waited for: three browsers on a slow machine with two cores take long. */
const PATIENCE_MS = 90_000;

/** "1:02" as seconds. */
export const seconds = (text) => text.split(":").reduce((sum, part) => 60 * sum + Number(part), 0);

/** The options of a menu, by its id. */
export const values = (page, menu) => page.locator(`#${menu} option`).evaluateAll((options) => options.map(({ value }) => value));

/** The `count` downloads that doing something brings. */
export async function taken(page, count, what) {
  const downloads = [];
  const all = new Promise((resolve) => {
    const take = (download) => {
      if (downloads.push(download) < count) return;
      page.off("download", take);
      resolve(downloads);
    };
    page.on("download", take);
  });
  await what();
  return all;
}

/** Opens the page for the test `t` and waits for its first picture. Options are those of `openPage`. */
export async function openApp(t, options = {}) {
  const opened = await openPage(t, options);
  const app = new App(opened.page);
  await app.until(...SETTLED);
  return { ...opened, app };
}

export class App {
  constructor(page) {
    this.page = page;
    page.setDefaultTimeout(PATIENCE_MS);
  }

  // ---- what is seen

  /** "planning", "ready", "playing", "paused", "finished", "seeking" or "failed". */
  state() {
    return this.page.evaluate(() => document.body.dataset.state ?? "");
  }

  /** Waits until the page is in one of these states. */
  async until(...states) {
    const reached = await this.page.waitForFunction((wanted) => wanted.includes(document.body.dataset.state ?? "") && document.body.dataset.state, states);
    return reached.jsonValue();
  }

  /** Waits until what was done has been drawn, and planning and seeking that came of it are over; says the state. */
  async settled() {
    await this.frames(2);
    return this.until(...SETTLED);
  }

  /** Waits until so many more frames were drawn. */
  frames(count) {
    return this.page.evaluate(
      (left) =>
        new Promise((done) => {
          const next = () => (left-- > 0 ? requestAnimationFrame(next) : done());
          next();
        }),
      count,
    );
  }

  text(selector) {
    return this.page.locator(selector).innerText();
  }

  /** One of the three large numbers: "coverage" in percent, "time" in seconds, "distance" in metres. All at one moment. */
  numbers() {
    const texts = this.page.evaluate(() => ["coverage", "time", "distance"].map((name) => document.getElementById(`n-${name}`).textContent));
    return texts.then(([coverage, time, distance]) => ({ coverage: Number(coverage), time: seconds(time), distance: Number(distance.replace(/,/g, "")) }));
  }

  /** Reads until two readings, so many frames apart, are the same: for what comes to rest without a sign. */
  async still(read, frames = 20) {
    let last;
    return this.poll(async () => {
      await this.frames(frames);
      const now = JSON.stringify(await read());
      const isSame = now === last;
      last = now;
      return isSame;
    }, Boolean, `${read} to stand still`);
  }

  /** Waits until `holds(numbers, than)`; returns them. */
  async numbersThat(holds, than) {
    return this.poll(() => this.numbers(), (numbers) => holds(numbers, than));
  }

  /** Reads until what is read fits; `what` says in words what was waited for. */
  async poll(read, fits, what = fits) {
    const patience = performance.now() + PATIENCE_MS;
    for (;;) {
      const value = await read();
      if (fits(value)) return value;
      assert.ok(performance.now() < patience, `waited in vain for ${what}: ${JSON.stringify(value)}`);
      await this.frames(2);
    }
  }

  /** A cell of the table of numbers, by the name of its row: what is planned, and what was done so far. */
  async metric(name) {
    const row = this.page.locator("#metrics tr").filter({ has: this.page.getByRole("button", { name, exact: true, includeHidden: true }) });
    const [plan, soFar] = await row.locator("td").allTextContents();
    return { plan, soFar };
  }

  /** Square metres of floor that the robot reaches, as the note under the menu of rooms says. */
  async reachableArea() {
    const note = (await this.page.locator("#room-note").textContent()) ?? "";
    return Number(/([\d.]+)\sm² reachable/.exec(note)?.[1]);
  }

  /** The name of the room, as the menu shows it. */
  room() {
    return this.page.locator("#room").evaluate((menu) => menu.selectedOptions[0]?.textContent ?? "");
  }

  /** The message over the floor; "" if there is none. */
  async message() {
    await this.frames(1);
    const bar = this.page.locator("#message");
    return (await bar.isVisible()) ? bar.locator("p").innerText() : "";
  }

  /** Waits for a message over the floor that fits the pattern; returns it. */
  says(pattern) {
    return this.poll(() => this.message(), (text) => pattern.test(text), pattern);
  }

  /** The session as the address has it. */
  link() {
    return this.page.evaluate(() => Object.fromEntries(new URLSearchParams(location.hash.slice(1))));
  }

  /** Waits until the address has `key` such that `fits(value)`, and returns that value. */
  async linked(key, fits = Boolean) {
    return this.poll(async () => (await this.link())[key], fits);
  }

  // ---- what is done

  press(name) {
    return this.page.getByRole("button", { name, exact: true }).click();
  }

  /** Chooses from a menu by its id: a value, as in links. */
  async choose(menu, value) {
    await this.page.locator(`#${menu}`).selectOption(value);
    return this.settled();
  }

  /** Opens what is folded in the setup, where some of the menus are. */
  async unfold() {
    await this.page.evaluate(() => document.querySelectorAll("#setup details").forEach((fold) => (fold.open = true)));
  }

  async pause() {
    if ((await this.state()) === "playing") await this.press("Pause");
    return this.until("ready", "paused", "finished");
  }

  async tool(name) {
    await this.page.locator(`#tools [data-tool=${name}]`).click();
    await this.page.locator(`#tools [data-tool=${name}][aria-pressed=true]`).waitFor();
  }

  /** The point of the page at these shares of the width and height of what the room has of the canvas. */
  async spot(x, y) {
    const box = await this.page.locator("#floor").boundingBox();
    // Below it, a narrow canvas has the scale bar over the zoom buttons.
    const height = box.height - (box.width < 626 ? 32 : 0);
    return [box.x + x * box.width, box.y + y * height];
  }

  /** Drags with the mouse over the floor, between points given as shares of its width and height. */
  async drag(from, to) {
    const { mouse } = this.page;
    await mouse.move(...(await this.spot(...from)));
    await mouse.down();
    await mouse.move(...(await this.spot(...to)), { steps: 8 });
    await mouse.up();
    return this.settled();
  }

  /** Goes to a share of the time line. */
  async scrub(share) {
    const box = await this.page.locator("#scrubber").boundingBox();
    await this.page.mouse.click(box.x + share * box.width, box.y + box.height / 2);
    return this.settled();
  }

  /** Saves as the kind of file with this id; `choose` may set more in the dialog. Returns the `count` downloads. */
  async save(kind, count = 1, choose = async () => {}) {
    await this.page.locator("#save").click();
    await this.page.locator(`#save-as input[value=${kind}]`).check();
    await choose();
    return taken(this.page, count, () => this.page.locator("#save-now").click());
  }

  /** Brings files of maps.mjs by the file picker, and makes them the room. */
  async pick(...files) {
    const [chooser] = await Promise.all([this.page.waitForEvent("filechooser"), this.page.locator("#load").click()]);
    await this.#use(() => chooser.setFiles(files.map(({ name, bytes }) => ({ name, mimeType: "application/octet-stream", buffer: bytes }))));
  }

  /** Drops files of maps.mjs onto the page, and makes them the room. */
  async drop(...files) {
    await this.#use(() => this.bring(...files));
  }

  /** Drops files of maps.mjs as if they were dragged over the page; says whether they could be read. */
  async bring(...files) {
    const encoded = files.map(({ name, bytes }) => ({ name, text: bytes.toString("base64") }));
    const before = await this.#taken();
    await this.page.evaluate((list) => {
      const dataTransfer = new DataTransfer();
      for (const { name, text } of list) {
        dataTransfer.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], name));
      }
      const fire = (type) => document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      fire("dragenter");
      fire("dragover");
      const shown = !document.getElementById("drop").hidden;
      fire("drop");
      if (!shown) throw new Error("the page does not say that files can be dropped");
    }, encoded);
    assert.ok(await this.page.locator("#drop").isHidden(), "the page says that something can be dropped");
    return (await this.poll(() => this.#taken(), (taken) => taken !== before)).endsWith("open");
  }

  /** How often files were brought to the tab Floor plan, and what came of the last. */
  #taken() {
    return this.page.evaluate(() => document.getElementById("panel-floor-plan").dataset.taken ?? "");
  }

  /** Does something that brings files. They are looked at first; if they could be read they are made the room. */
  async #use(what) {
    const before = await this.#taken();
    await what();
    const taken = await this.poll(() => this.#taken(), (now) => now !== before);
    if (taken.endsWith("open")) await this.answered(() => this.page.locator("#floor-plan-use").click());
    else await this.settled();
  }

  /** Does something with files, and waits until the page confirms or complains, and what it started is settled. */
  async answered(what) {
    // Observed rather than looked for: what confirms goes away by itself.
    await this.page.evaluate(() => {
      const [toast, message, text] = ["toast", "message", "message-text"].map((id) => document.getElementById(id));
      const before = message.hidden ? "" : text.textContent;
      toast.hidden = true;
      window.isAnswered = false;
      const observer = new MutationObserver(() => {
        window.isAnswered = (!message.hidden && text.textContent !== before) || (!toast.hidden && toast.ariaBusy !== "true");
        if (window.isAnswered) observer.disconnect();
      });
      for (const node of [toast, message]) observer.observe(node, { attributes: true, childList: true, characterData: true, subtree: true });
    });
    await what();
    await this.page.waitForFunction(() => window.isAnswered);
    await this.settled();
  }
}
