// What must work everywhere, in Firefox.
import assert from "node:assert/strict";
import { startFirefox } from "./engines/firefox.mjs";
import { checkIn } from "./engines/suite.mjs";

/** Opens the tab Robot; what it says of serial ports, "" if they work. */
async function told(page, url, isEnabled) {
  await page.send("Marionette:SetContext", { value: "chrome" });
  await page.evaluate((on) => Services.prefs.setBoolPref("dom.webserial.enabled", on), isEnabled);
  await page.send("Marionette:SetContext", { value: "content" });
  await page.open("about:blank");
  await page.open(`${url}#room=empty&tab=connection`);
  await page.until(() => document.getElementById("connection-virtual")?.checkVisibility());
  return page.evaluate(() => (document.getElementById("connection-unsupported").hidden ? "" : document.getElementById("connection-unsupported").textContent));
}

checkIn("Firefox", startFirefox, {
  "Robot: serial ports can be used, and if they are switched off, it says so": async (page, url) => {
    assert.match(await told(page, url, false), /switched off in this Firefox.*dom\.webserial\.enabled.*bridge.*virtual robot/);
    assert.equal(await told(page, url, true), "");
  },
});
