// Cable, wiring and waking in pictures: at each finding of the diagnosis, in their dialog, and in the documentation.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { ROOT, openPage } from "./harness.mjs";

const read = (file) => fs.readFileSync(path.join(ROOT, file), "utf8");
const PICTURES = "www/connection/pictures";
const NAMES = fs.readdirSync(path.join(ROOT, PICTURES)).map((file) => path.basename(file, ".svg"));
/** What a drawing says to those who don't see it. */
const label = (name) => /aria-label="([^"]+)"/.exec(read(`${PICTURES}/${name}.svg`))?.[1];

const PHONE = { viewport: { width: 390, height: 844 } };
const LAPTOP = { viewport: { width: 1440, height: 900 } };

/** The robot's addresses on the test's line, and the picture that belongs to what is found there. */
const FOUND = {
  silence: "asleep",
  stream: "unheard",
  charging: "dock",
  booting: "booting",
  bootloader: "bootloader",
  garbage: "speed",
  text: "unheard",
  no_stream: "older",
  "silence?usb": "usb",
  "no_stream?usb": "usb",
  "silence?unplugged": "unplugged",
};

/** The tab Robot, whose driver is that of serial/fast-worker.js. */
async function openTab(t, options) {
  const { page, screenshot } = await openPage(t, { address: "#room=empty&behaviour=bounce&robot=roomba600", ...options });
  const body = read("tests/e2e/serial/fast-worker.js");
  await page.route("**/connection/worker.js*", (route) => route.fulfill({ contentType: "text/javascript", body }));
  await page.locator("#tab-connection").click();
  await page.locator("body[data-tab=connection][data-boot=ready]").waitFor();
  await page.locator("#connection-welcome").waitFor();
  return { page, screenshot };
}

// A laptop has more room for the same: it is for those who look at the pictures.
for (const [where, options] of Object.entries(process.env.PICTURES ? { phone: PHONE, laptop: LAPTOP } : { phone: PHONE })) {
  test(`each finding shows what to do, in words and as a picture: ${where}`, async (t) => {
    const { page, screenshot } = await openTab(t, options);
    await page.evaluate(() => localStorage.setItem("connection-safety", "read"));
    await page.locator("#connection-bridge summary").click();
    for (const [address, name] of Object.entries(FOUND)) {
      await page.locator("#connection-url").fill(`ws://robot/${address}`);
      await page.locator("#connection-socket button").click();
      const picture = page.locator("#connection-diagnosis").getByRole("img", { name: label(name), exact: true });
      await picture.waitFor();
      const box = await picture.boundingBox();
      assert.ok(box.width > 250 && box.x >= 0 && box.x + box.width <= options.viewport.width, `${address}: ${JSON.stringify(box)}`);
      assert.notEqual(await page.locator("#connection-found").innerText(), "", address);
      // An adapter that was unplugged says what to do in its first sentence.
      if (!address.includes("unplugged")) assert.match(await page.locator("#connection-remedy").innerText(), /\.$/, address);
      await screenshot(`finding-${where}-${address.replace("?", "-")}`);
      if (where === "laptop") {
        await page.emulateMedia({ colorScheme: "dark" });
        await screenshot(`finding-dark-${address.replace("?", "-")}`);
        await page.emulateMedia({ colorScheme: "light" });
      }
      await page.locator("#connection-give-up").click();
      await page.locator("#connection-welcome").waitFor();
    }
  });
}

test("no finding is forgotten", () => {
  const [, union] = /\nfinding: ([^,]+),/.exec(read("www/types.d.ts"));
  const findings = [...union.matchAll(/"(\w+)"/g)].map(([, finding]) => finding);
  // With these two, tests go on or have come to an end.
  assert.deepEqual(findings.filter((finding) => !(finding in FOUND)), ["nothing", "robot"]);
});

test("the dialog explains cable and wiring, and begins where it is asked to", async (t) => {
  const { page, screenshot } = await openTab(t, PHONE);
  await page.locator("#connection-welcome [data-wiring]").click();
  for (const name of ["socket", "levels", "transistor", "waking", "usb"]) {
    const picture = page.locator("#connection-wiring").getByRole("img", { name: label(name), exact: true });
    await picture.waitFor();
    await picture.scrollIntoViewIfNeeded();
    await screenshot(`wiring-phone-${name}`);
    const box = await picture.boundingBox();
    assert.ok(box.width > 300 && box.x + box.width <= 390, `${name}: ${JSON.stringify(box)}`);
  }
  await page.keyboard.press("Escape");
  await page.evaluate(() => localStorage.setItem("connection-safety", "read"));
  await page.locator("#connection-bridge summary").click();
  await page.locator("#connection-url").fill("ws://robot/silence");
  await page.locator("#connection-socket button").click();
  await page.locator("#connection-diagnosis-wiring").click();
  // The words there mean this section.
  await page.waitForFunction(() => {
    const { top } = document.getElementById("wiring-transistor").getBoundingClientRect();
    return top > 0 && top < innerHeight / 2;
  });
  for (const scheme of ["light", "dark"]) {
    await page.setViewportSize(LAPTOP.viewport);
    await page.emulateMedia({ colorScheme: scheme });
    for (const name of ["socket", "transistor", "usb"]) {
      await page.locator(`#wiring-${name}`).scrollIntoViewIfNeeded();
      await screenshot(`wiring-${scheme}-${name}`);
    }
  }
});

test("no text of a drawing is cut or lies on another, and each says what it shows", async (t) => {
  const { page } = await openPage(t, { address: "www/help.html" });
  for (const name of NAMES) {
    assert.ok(label(name)?.length > 20, `${name}: ${label(name)}`);
    const wrong = await page.evaluate((drawing) => {
      document.body.innerHTML = `<div style="width: 318px">${drawing}</div>`;
      const box = (node) => node.getBoundingClientRect();
      const frame = box(document.querySelector("svg"));
      const texts = [...document.querySelectorAll("svg text")];
      const isCut = (node) => box(node).left < frame.left + 3 || box(node).right > frame.right - 3 || box(node).top < frame.top || box(node).bottom > frame.bottom;
      const meets = (a, b) => box(a).left < box(b).right && box(b).left < box(a).right && box(a).top + 2 < box(b).bottom && box(b).top + 2 < box(a).bottom;
      const overlaps = texts.flatMap((a, index) => texts.slice(index + 1).filter((b) => meets(a, b)).map((b) => `"${a.textContent}" on "${b.textContent}"`));
      return [...texts.filter(isCut).map((node) => `"${node.textContent}" is cut`), ...overlaps];
    }, read(`${PICTURES}/${name}.svg`));
    assert.deepEqual(wrong, [], name);
  }
});

test("the documentation shows the same pictures, with the same words for those who don't see them", () => {
  const shown = [...read("docs/real-robot.md").matchAll(/!\[([^\]]+)\]\(\.\.\/www\/connection\/pictures\/(\w+)\.svg\)/g)];
  for (const [, alt, name] of shown) assert.equal(alt, label(name), name);
  assert.deepEqual([...new Set(shown.map(([, , name]) => name))].sort(), NAMES.filter((name) => name !== "listening").sort());
});
