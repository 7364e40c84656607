// Photographs and other pictures in the tab Floor plan: decoded by the browser, read as is best, turned and cut.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { anyFile } from "./maps.mjs";

/**
 * A picture of a house with two rooms and an open front door, turned on its sheet; as the browser encodes it. On a `sheet` it
 * has names, and stands within a garden wall in a frame with a title block.
 */
const photograph = (page, name, type, degrees, sheet = false) =>
  page.evaluate(
    async ([type, degrees, sheet]) => {
      const [width, height] = sheet ? [720, 600] : [520, 420];
      const canvas = new OffscreenCanvas(width, height);
      const context = canvas.getContext("2d");
      context.fillStyle = "#e8e4da";
      context.fillRect(0, 0, width, height);
      if (sheet) {
        context.strokeRect(6, 6, 708, 588);
        context.strokeRect(564, 534, 150, 60);
      }
      context.translate(width / 2, height / 2);
      context.rotate((-degrees * Math.PI) / 180);
      context.fillStyle = "#222";
      // 8 x 6 m at 2.5 cm a pixel, with walls of 20 cm.
      context.fillRect(-168, -128, 336, 256);
      context.fillStyle = "#e8e4da";
      context.fillRect(-160, -120, 156, 240);
      context.fillRect(4, -120, 156, 240);
      context.fillRect(-4, 20, 8, 36);
      context.fillRect(-168, -100, 8, 40);
      if (sheet) {
        context.strokeStyle = context.fillStyle = "#222";
        context.lineWidth = 5;
        context.strokeRect(-250, -200, 500, 400);
        context.font = "12px sans-serif";
        context.fillText("Kitchen 23.4", -130, 0);
        context.fillText("Bedroom 23.4", 50, 0);
      }
      const blob = await canvas.convertToBlob({ type, quality: 0.9 });
      if (blob.type !== type) throw new Error(`this browser encodes no ${type}`);
      return [...new Uint8Array(await blob.arrayBuffer())];
    },
    [type, degrees, sheet],
  ).then((bytes) => ({ name, bytes: Buffer.from(bytes) }));

const result = async (app) => {
  await app.frames(2);
  await app.page.waitForFunction(() => document.getElementById("panel-floor-plan").ariaBusy !== "true");
  return (await app.page.locator("#floor-plan-result").textContent()) ?? "";
};
const floor = async (app) => Number(/([\d.]+) m² of floor/.exec(await result(app))?.[1]);
/** 2 rooms of 3.9 x 6 m, and the doors in the walls: the outer one is closed along the face of its wall. */
const FLOOR = 2 * 3.9 * 6 + 0.2 * 0.9 + 0.2 * 1;

test("a photograph becomes a floor plan: indoors, straightened, at its size", async (t) => {
  const { page, app, screenshot } = await openApp(t);
  assert.ok(await app.bring(await photograph(page, "flat.jpg", "image/jpeg", 7)));
  assert.equal(await page.locator("#floor-plan-method").inputValue(), "level");
  assert.equal(await page.locator("[data-part=indoors]").getAttribute("aria-pressed"), "true");
  await page.locator("#floor-plan-pixel").fill("2.5");
  await page.keyboard.press("Tab");
  const askew = await app.poll(() => floor(app), (area) => area < 60);
  assert.ok(Math.abs(askew / FLOOR - 1) < 0.05, `${askew} of ${FLOOR} m²`);
  await screenshot("floor-plan-photograph");
  const offered = await page.locator("#floor-plan-straighten").textContent();
  assert.match(offered, /walls are (6\.[89]|7\.[0-2])° askew/);
  await page.locator("#floor-plan-straighten").click();
  await page.locator("#floor-plan-straighten").waitFor({ state: "hidden" });
  assert.match(await result(app), /Room 8\.[0-5] × 6\.[0-5] m/);
  // Whole has the paper around the house, too.
  await page.locator("[data-part=whole]").click();
  assert.ok((await app.poll(() => floor(app), (area) => area > FLOOR + 20)) > 0);
  await page.locator("[data-part=indoors]").click();
  await app.poll(() => floor(app), (area) => Math.abs(area / FLOOR - 1) < 0.05);
  await screenshot("floor-plan-straightened");
  await app.answered(() => page.locator("#floor-plan-use").click());
  assert.equal(await app.room(), "flat");
});

test("a garden, a page within its frame, and words are neither floor nor walls", async (t) => {
  const { page, app, screenshot } = await openApp(t);
  assert.ok(await app.bring(await photograph(page, "sheet.png", "image/png", 0, true)));
  await page.locator("#floor-plan-pixel").fill("2.5");
  await page.keyboard.press("Tab");
  const area = await app.poll(() => floor(app), (area) => area < 60);
  // Letters would be 0.3 m² of walls.
  assert.ok(Math.abs(area - FLOOR) < 0.2, `${area} of ${FLOOR} m²`);
  assert.match(await result(app), /[\d.]+ m² round the building left out/);
  await screenshot("floor-plan-sheet");
  await page.locator("#floor-plan-specks").fill("0");
  await app.poll(() => floor(app), (now) => now < area - 0.1);
});

test("WebP is read, an unusual size is asked about, and other files are told how to be converted", async (t) => {
  const { page, app } = await openApp(t);
  assert.ok(await app.bring(await photograph(page, "flat.webp", "image/webp", 0)));
  await page.locator("#floor-plan-pixel").fill("50");
  await page.keyboard.press("Tab");
  await app.poll(() => page.locator("#floor-plan-asks-text").textContent(), (text) => /260\.0 × 210\.0 m\. Is that its size\?/.test(text ?? ""));
  await page.locator("#floor-plan-asks-yes").click();
  await page.locator("#floor-plan-asks").waitFor({ state: "hidden" });
  const before = await floor(app);
  const heic = Buffer.concat([Buffer.from([0, 0, 0, 24]), Buffer.from("ftypheic")]);
  for (const [file, remedy] of [
    [anyFile("plan.pdf", "%PDF-1.7\n"), /plan\.pdf.*PDF document: export its page as SVG/],
    [{ name: "plan.heic", bytes: heic }, /plan\.heic.*HEIC photograph: export it as JPEG/],
    [anyFile("plan.docx", "PK\u0003\u0004[Content_Types].xml word/document.xml"), /plan\.docx.*Word document: save the picture in it as PNG/],
    [anyFile("plan.zip", "PK\u0003\u0004"), /plan\.zip.*ZIP archive: unpack it/],
    [{ name: "cut.jpg", bytes: Buffer.from([0xff, 0xd8, 0xff, 0xe0]) }, /cut\.jpg.*damaged/],
  ]) {
    assert.equal(await app.bring(file), false);
    const message = await app.says(remedy);
    assert.doesNotMatch(message, /Floor plan tab/);
    if (!/damaged/.test(message)) for (const format of ["DXF", "SVG", "GeoJSON", "PNG", "JPEG", "WebP", "PGM", "YAML", "text", "JSON"]) assert.ok(message.includes(format), `${format}: ${message}`);
    assert.equal(await floor(app), before, "what was open stays");
  }
});

test("before a room is used it is told what a robot can't get to, which scale a plan on paper has, and how large it would be", async (t) => {
  const { page, app, screenshot } = await openApp(t);
  // Two rooms with the usual symbol of a door between them, a leaf and an arc, on a sheet as wide as A4.
  const wall = (x, y, width, height) => `<rect x="${x}" y="${y}" width="${width}" height="${height}"/>`;
  const walls = [wall(0, 0, 400, 10), wall(0, 290, 400, 10), wall(0, 0, 10, 300), wall(390, 0, 10, 300), wall(195, 0, 10, 110), wall(195, 200, 10, 100)].join("");
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="481" height="340" viewBox="-20 -20 481 340"><rect x="-20" y="-20" width="481" height="340" fill="#fff"/>${walls}<path d="M200 110 A90 90 0 0 0 110 200 H200" fill="none" stroke="#333" stroke-width="3"/></svg>`;
  const bytes = await page.evaluate(async (svg) => {
    const image = new Image();
    image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`;
    await image.decode();
    const canvas = new OffscreenCanvas(481, 340);
    canvas.getContext("2d").drawImage(image, 0, 0);
    return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())];
  }, svg);
  assert.ok(await app.bring({ name: "door.png", bytes: Buffer.from(bytes) }));
  await page.locator("#floor-plan-pixel").fill("1");
  await page.keyboard.press("Tab");
  // At the assumed scale, it was other floor.
  await app.poll(() => result(app), (text) => /^Room [34]\.\d × [23]\.\d m/.test(text ?? ""));
  // The symbol is no wall, unless all marks are to stay.
  assert.ok(await page.locator("#floor-plan-cut").isHidden());
  await page.locator("#floor-plan-specks").fill("0");
  await page.locator("#floor-plan-cut").waitFor();
  const cut = Number(/can't get to ([\d.]+) m² of this floor\..*If furniture stands there, there is nothing to do\. .*door.*erase/.exec(await page.locator("#floor-plan-cut-text").textContent())?.[1]);
  assert.ok(cut > 4 && cut < 5.5, `half of 1.85 x 2.8 m twice: ${cut}`);
  const [, all, reached] = /([\d.]+) m² of floor, ([\d.]+) m² of it reachable by a Roomba's brush/.exec(await result(app)) ?? [];
  assert.ok(Number(reached) > 3 && Number(reached) < Number(all) - cut, `${reached} of ${all} m², ${cut} cut off`);
  assert.equal(await page.locator("#floor-plan-mark-key").innerText(), "out of reach");
  await screenshot("floor-plan-cut-off");
  await page.setViewportSize({ width: 390, height: 844 });
  await screenshot("floor-plan-cut-off-phone");
  await page.setViewportSize({ width: 1440, height: 900 });
  // 52 x 39 m would be a usual size, but not 2,000 m².
  await page.locator("#floor-plan-pixel").fill("13");
  await page.keyboard.press("Tab");
  await app.poll(() => page.locator("#floor-plan-asks-text").textContent(), (text) => /m, with \d,\d{3} m² of floor\. Is that its size\?$/.test(text ?? ""));
  // The question comes first; what a robot can't get to stays.
  assert.deepEqual(await page.locator(".floor-plan-doors:visible").evaluateAll((nodes) => nodes.map((node) => node.id)), ["floor-plan-asks", "floor-plan-cut"]);
  // However many scales are offered, the question is hardly higher than its text.
  assert.ok((await page.locator("#floor-plan-asks-papers button").count()) >= 5);
  const { height } = await page.locator("#floor-plan-asks").boundingBox();
  assert.ok(height < 85, `${height} px`);
  await screenshot("floor-plan-papers");
  const paper = '<svg xmlns="http://www.w3.org/2000/svg" width="420mm" height="297mm" viewBox="0 0 420 297"><path id="walls" d="M30 40 H210 V160 H30 Z M110 40 V100" fill="none" stroke="black"/></svg>';
  assert.ok(await app.bring(anyFile("paper.svg", paper)));
  assert.match(await result(app), /^Whole drawing: 180 × 120 mm\. Choose its size first\.$/);
  for (const id of ["use", "play", "drive"]) assert.ok(await page.locator(`#floor-plan-${id}`).isDisabled(), id);
  await screenshot("floor-plan-paper");
  await page.locator("#floor-plan-asks-papers").getByRole("button", { name: "1:50", exact: true }).click();
  await page.locator("#floor-plan-asks").waitFor({ state: "hidden" });
  const area = await app.poll(() => floor(app), (area) => area > 0);
  assert.ok(Math.abs(area / 54 - 1) < 0.05, `9 x 6 m: ${area}`);
  // The name of a file stays as it is.
  await page.evaluate(() => {
    const files = new DataTransfer();
    files.items.add(new File([new Uint8Array(65 * 2 ** 20)], "huge.dxf"));
    const field = document.getElementById("files");
    field.files = files.files;
    field.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await app.says(/^huge\.dxf is larger than 64 MB/);
});
