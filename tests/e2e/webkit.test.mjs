// What must work everywhere, in the engine of Safari.
import assert from "node:assert/strict";
import { checkIn } from "./engines/suite.mjs";
import { startWebKit } from "./engines/webkit.mjs";

checkIn("WebKit", startWebKit, {
  "Robot: there are no serial ports, and it says what works instead": async (page, url) => {
    await page.open(`${url}#room=empty&tab=connection`);
    await page.until(() => document.getElementById("connection-unsupported")?.checkVisibility());
    const told = await page.evaluate(() => document.getElementById("connection-unsupported").textContent);
    assert.match(told, /can't use serial ports.*Firefox 151.*bridge.*virtual robot/);
  },
});
