// The tab Robot as its users know it, with the virtual robot.
import assert from "node:assert/strict";
import { App } from "./app.mjs";
import { openPage } from "./harness.mjs";

/** For what drives: the page must not be slow to paint, or else its robot is stopped. */
const SMALL = { viewport: { width: 1000, height: 640 } };

/** Opens the tab Robot, nothing connected. */
export async function openRobot(t, { link = "room=empty&behaviour=bounce", ...options } = {}) {
  const opened = await openPage(t, { address: `#${link}&robot=roomba600&tab=connection`, allFrames: true, ...SMALL, ...options });
  const { page } = opened;
  const app = new App(page);
  await page.locator("body[data-tab=connection][data-boot=ready]").waitFor();
  return { ...opened, app, robot: new Robot(page, app) };
}

export class Robot {
  constructor(page, app) {
    Object.assign(this, { page, app });
  }

  phase(name) {
    return this.page.locator(`#connection-setup[data-phase=${name}]`).waitFor({ state: "attached" });
  }

  mode(name) {
    return this.page.locator(`#connection-modes .in[data-mode=${name}]`).waitFor({ state: "attached" });
  }

  async connect() {
    await this.page.locator("#connection-virtual").click();
    await this.phase("connected");
    await this.mode("Passive");
  }

  async arm() {
    await this.page.locator("#connection-arm").click();
    await this.mode("Safe");
    await this.page.locator("#connection-pad").waitFor();
  }

  /** Metres driven since it was connected. */
  async distance() {
    return Number(await this.page.locator("#connection-distance").textContent());
  }

  drives(than) {
    return this.app.poll(() => this.distance(), (metres) => metres > than);
  }

  /** It comes to rest, and stays there. */
  async rests() {
    await this.app.still(() => this.distance());
    const before = await this.distance();
    await this.page.waitForTimeout(700);
    assert.equal(await this.distance(), before, "it moves after the stop");
  }
}
