// What must work everywhere, in the engine of Safari.
import assert from "node:assert/strict";
import { checkIn } from "./engines/suite.mjs";
import { startWebKit } from "./engines/webkit.mjs";

checkIn("WebKit", startWebKit, {
  "there are no serial ports, and it is said what works instead": async ({ page, url }) => {
    await page.open(`${url}desk.html`);
    const { serial, why, instead } = await page.until(() => window.support?.());
    assert.equal(serial, false);
    assert.match(why, /can't use serial ports/);
    assert.match(instead, /Firefox 151.*bridge.*virtual robot/);
  },
});
