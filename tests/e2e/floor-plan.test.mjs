// The tab Floor plan: files are looked at, scaled, traced and swept before they become the room.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { anyFile, openRoom, png, textMap } from "./maps.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** Opens the page and goes to the tab Floor plan. */
async function openFloorPlan(t, options = {}) {
  const opened = await openApp(t, options);
  await opened.page.locator("#tab-floor-plan").click();
  await opened.page.locator("#floor-plan-empty").waitFor();
  return opened;
}

/** A DXF of lines, each `[layer, x1, y1, x2, y2]`; `units` is its $INSUNITS. */
function dxf(name, lines, { units, end = true } = {}) {
  const rows = ["0", "SECTION", "2", "HEADER", "9", "$ACADVER", "1", "AC1009"];
  if (units !== undefined) rows.push("9", "$INSUNITS", "70", units);
  rows.push("0", "ENDSEC", "0", "SECTION", "2", "ENTITIES");
  for (const [layer, ...at] of lines) rows.push("0", "LINE", "8", layer, ...["10", "20", "11", "21"].flatMap((code, i) => [code, at[i]]));
  if (end) rows.push("0", "ENDSEC", "0", "EOF");
  return anyFile(name, `${rows.join("\n")}\n`);
}

/** The four sides of a rectangle. */
const box = (layer, x, y, w, h) => [[layer, x, y, x + w, y], [layer, x + w, y, x + w, y + h], [layer, x + w, y + h, x, y + h], [layer, x, y + h, x, y]];
/** Two rooms, 4 x 3 and 3 x 3 in its unit, the second with a table. */
const TWO_ROOMS = [...box("WALLS", 0, 0, 4, 3), ...box("WALLS", 4, 0, 3, 3), ...box("FURNITURE", 5, 1, 1, 1)];

/** Waits until the floor plan is at rest; returns the text of an element. */
async function text(app, selector) {
  await app.frames(2);
  await app.page.waitForFunction(() => document.getElementById("panel-floor-plan").ariaBusy !== "true");
  return (await app.page.locator(selector).textContent()) ?? "";
}

/** The free floor of the floor plan, m². */
const floor = async (app) => Number(/([\d.]+) m² of floor/.exec(await text(app, "#floor-plan-result"))?.[1]);

/** Clicks on the canvas, at shares of its size. */
async function click(app, x, y) {
  const size = await app.page.locator("#floor-plan-floor").boundingBox();
  await app.page.mouse.click(size.x + x * size.width, size.y + y * size.height);
  await app.frames(3);
}

/** The tool is in the hand. */
const holds = (app, tool) => app.page.locator(`#floor-plan-stage[data-tool=${tool}]`).waitFor();
/** The tool is laid down, which is seen together with what it did. */
const isDone = (app) => holds(app, "view");

async function sample(app) {
  await app.page.locator("#floor-plan-sample").click();
  await app.page.locator("#floor-plan-empty").waitFor({ state: "hidden" });
  return floor(app);
}

test("the sample is traced, cut, swept, exported, used and undone", async (t) => {
  const { page, app, screenshot } = await openFloorPlan(t);
  assert.ok(await page.locator("#floor-plan-use").isDisabled());
  const whole = await sample(app);
  assert.ok(whole > 30 && whole < 60, `${whole} m²`);
  assert.match(await text(app, "#floor-plan-facts"), /strokes on \d+ layers/);
  assert.equal(await page.locator("#floor-plan-unit").inputValue(), "0.001");
  const layers = await page.locator("#floor-plan-layers tr").count();
  assert.ok(layers >= 5, `${layers} layers`);

  // Furniture that isn't there leaves more floor.
  await page.getByLabel("What FURNITURE is").selectOption("ignored");
  const empty = await floor(app);
  assert.ok(empty > whole + 3, `${empty} m² without furniture, ${whole} with`);
  await page.getByLabel("What FURNITURE is").selectOption("obstacle");
  assert.equal(await floor(app), whole);

  // A room by a click inside, where doors count as walls.
  await page.getByLabel("What DOORS is").selectOption("wall");
  // What changes with it moves the buttons below.
  await floor(app);
  await page.getByRole("button", { name: "This room", exact: true }).click();
  await holds(app, "room");
  assert.match(await text(app, "#floor-plan-hint"), /Click into the room/);
  await click(app, 0.38, 0.3);
  await isDone(app);
  const one = await floor(app);
  assert.ok(one > 5 && one < whole / 2, `${one} of ${whole} m²`);
  await page.getByRole("button", { name: "Whole", exact: true }).click();
  await page.getByLabel("What DOORS is").selectOption("ignored");
  assert.equal(await floor(app), whole);

  await page.locator("[data-stage='1']").click();
  await page.locator("#floor-plan-numbers").waitFor();
  const number = async (name) => Number((await text(app, `#floor-plan-n-${name}`)).replace(/[^\d.]/g, ""));
  const all = await number("subgoals");
  const kinds = await Promise.all(["left-wall", "right-wall", "left-obstacle", "right-obstacle"].map(number));
  assert.ok(all > 20 && kinds.every((count) => count > 0), `${all}: ${kinds}`);
  assert.equal(kinds.reduce((sum, count) => sum + count), all);
  assert.ok((await number("collisions")) > 0 && (await number("resolved")) === (await number("collisions")));
  for (const stage of ["2", "3"]) {
    await page.locator(`[data-stage='${stage}']`).click();
    await page.locator(`[data-stage='${stage}'][aria-pressed=true]`).waitFor();
  }
  await screenshot("floor-plan-sweep");
  assert.match(await page.locator("#floor-plan-floor").getAttribute("aria-label"), /sweep of [\d.]+ metres/);

  const starts = { dxf: /^\s*0\r?\n\s*SECTION|^\s*999/, program: /^; planned   for an octagon, 0\.400 m wide\n; robot     moves as the Omnidirectional octagon/, commands: /^# planned   for an octagon, 0\.400 m wide\n# runs on   Roomba 600/, csv: /^x/, poses: /./, bag: /^\x89MCAP0/ };
  for (const [format, start] of Object.entries(starts)) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`[data-format=${format}]`).click()]);
    const content = fs.readFileSync(await download.path(), "latin1");
    assert.match(content, start, download.suggestedFilename());
    if (format === "dxf") assert.ok(["WALLS", "FURNITURE", "SWEEP_SUBGOALS", "SWEEP_LINKS", "SWEEP_PATH"].every((layer) => content.includes(layer)), "the path beside the drawing");
  }

  await page.locator("#tab-explore").click();
  const before = await app.room();
  await page.locator("#tab-floor-plan").click();
  await page.locator("#floor-plan-use").click();
  await app.settled();
  assert.ok(await page.locator("#panel-explore").isVisible());
  assert.equal(await app.room(), "sample flat");
  await app.press("Undo");
  await app.settled();
  assert.equal(await app.room(), before);
});

test("a room that continues through doors offers to close them", async (t) => {
  const { page, app } = await openFloorPlan(t);
  const whole = await sample(app);
  assert.match(await text(app, "#floor-plan-facts"), /whole drawing: 10\.4 × 8\.0 m/);
  assert.match(await text(app, "#floor-plan-result"), /Room 9\.0 × 6\.6 m, without walls/);
  assert.ok(await page.locator("#floor-plan-doors").isHidden(), "nobody has marked a room");
  await page.getByRole("button", { name: "This room", exact: true }).click();
  await holds(app, "room");
  await click(app, 0.42, 0.42);
  await page.locator("#floor-plan-doors").waitFor();
  const open = await floor(app);
  assert.ok(open > 0.8 * whole, `${open} of ${whole} m²`);
  const [, told] = /through 3 openings as wide as a door, where the rings are\. Closing them leaves ([\d.]+) m²/.exec(await text(app, "#floor-plan-doors-text"));
  await page.getByRole("button", { name: "Close gaps up to 0.85 m" }).click();
  await app.poll(() => floor(app), (area) => area === Number(told));
  assert.ok(await page.locator("#floor-plan-doors").isHidden());
  assert.equal(await page.locator("#floor-plan-gap").inputValue(), "0.85");
  assert.match(await text(app, "#floor-plan-result"), /3 gaps closed/);
});

test("a drawing without unit asks for it, with the size of each answer", async (t) => {
  const { page, app } = await openFloorPlan(t);
  assert.ok(await app.bring(dxf("rooms.dxf", TWO_ROOMS)));
  assert.ok(await page.locator("#floor-plan-use").isDisabled(), "nothing is guessed");
  assert.match(await text(app, "#floor-plan-result"), /Choose the drawing's unit/);
  const offered = await page.locator("#floor-plan-unit option").allTextContents();
  assert.ok(offered.some((label) => label === "metres: 7.0 × 3.0 m") && offered.some((label) => label === "feet: 2.1 × 0.9 m"), `${offered}`);
  await page.locator("#floor-plan-unit").selectOption({ label: "metres: 7.0 × 3.0 m" });
  const metres = await floor(app);
  assert.ok(metres > 17 && metres < 21, `${metres} m²`);
  assert.equal(await app.message(), "");
});

test("choices that follow quickly all count, and none counts for a file that was opened since", async (t) => {
  const { page, app } = await openFloorPlan(t);
  const whole = await sample(app);
  const choose = (...roles) =>
    page.evaluate((list) => {
      for (const [layer, role] of list) {
        const menu = document.querySelector(`[aria-label="What ${layer} is"]`);
        menu.value = role;
        menu.dispatchEvent(new Event("change", { bubbles: true }));
      }
    }, roles);
  await choose(["FURNITURE", "ignored"], ["DOORS", "wall"]);
  const changed = await floor(app);
  assert.notEqual(changed, whole);
  assert.equal(await page.getByLabel("What FURNITURE is").inputValue(), "ignored");
  assert.equal(await page.getByLabel("What DOORS is").inputValue(), "wall");

  // Between the opening of a file and its picture.
  await page.evaluate(() => {
    const observer = new MutationObserver(() => {
      observer.disconnect();
      const gap = document.getElementById("floor-plan-gap");
      gap.value = "0.5";
      gap.dispatchEvent(new Event("change", { bubbles: true }));
    });
    observer.observe(document.getElementById("panel-floor-plan"), { attributeFilter: ["aria-busy"] });
  });
  assert.ok(await app.bring(png("image.png", openRoom(40, 30))));
  assert.equal(await floor(app), 3, "40 by 30 cells of 5 cm");
  assert.equal(await page.locator("#floor-plan-pixel").inputValue(), "5");
  assert.equal(await page.locator("#floor-plan-gap").inputValue(), "0.1");
});

test("two points and their distance set the scale, by pointer and by keys alone", async (t) => {
  const { page, app } = await openFloorPlan(t);
  await app.bring(dxf("rooms.dxf", TWO_ROOMS));
  await page.getByRole("button", { name: "Scale by two points" }).click();
  await holds(app, "scale");
  // The wall is as wide as the canvas but for its margins of 24 pixels.
  const canvas = await page.locator("#floor-plan-floor").boundingBox();
  const share = 24 / canvas.width;
  await click(app, share, 0.5);
  await click(app, 1 - share, 0.5);
  await page.locator("#floor-plan-distance").fill("14");
  await page.keyboard.press("Enter");
  const by = await floor(app);
  assert.ok(by > 68 && by < 84, `twice as long, four times the floor: ${by} m²`);

  // An image, without a mouse.
  assert.ok(await app.bring(png("image.png", openRoom(40, 30))));
  const before = await floor(app);
  assert.equal(before, 3, "40 by 30 cells of 5 cm");
  await page.locator("#floor-plan-scale").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Enter");
  for (let i = 0; i < 20; i += 1) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await page.locator("#floor-plan-distance").waitFor();
  const was = Number(await page.locator("#floor-plan-distance").inputValue());
  await page.keyboard.type(String(2 * was));
  await page.keyboard.press("Enter");
  const after = await floor(app);
  assert.ok(Math.abs(after - 4 * before) < 0.3, `${after} m²`);
  assert.ok(Math.abs(Number(await page.locator("#floor-plan-pixel").inputValue()) - 10) < 0.1);
});

test("rectangle and polygon cut the drawing, by pointer and by keys", async (t) => {
  const { page, app } = await openFloorPlan(t, { viewport: { width: 1366, height: 768 } });
  await app.bring(dxf("rooms.dxf", TWO_ROOMS, { units: 6 }));
  const whole = await floor(app);
  const canvas = await page.locator("#floor-plan-floor").boundingBox();
  const at = (x, y) => [canvas.x + x * canvas.width, canvas.y + y * canvas.height];
  await page.getByRole("button", { name: "Rectangle" }).click();
  await holds(app, "rectangle");
  await page.mouse.move(...at(0.1, 0.2));
  await page.mouse.down();
  await page.mouse.move(...at(0.4, 0.8), { steps: 4 });
  await page.mouse.up();
  await isDone(app);
  const part = await floor(app);
  assert.ok(part > 2 && part < 0.6 * whole, `${part} of ${whole} m²`);

  await page.getByRole("button", { name: "Polygon" }).click();
  await holds(app, "polygon");
  await click(app, 0.1, 0.4);
  await click(app, 0.4, 0.4);
  await click(app, 0.4, 0.6);
  await page.keyboard.press("Enter");
  await isDone(app);
  const triangle = await floor(app);
  assert.ok(triangle > 0.5 && triangle < part, `${triangle} m²`);

  // Escape takes the corner back, then lays the tool down.
  await page.getByRole("button", { name: "Polygon" }).focus();
  await page.keyboard.press("Enter");
  await holds(app, "polygon");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await isDone(app);
  assert.equal(await floor(app), triangle);
});

test("choices and other files are undone and redone by their keys, and a comma in a number is a point", async (t) => {
  const { page, app } = await openFloorPlan(t);
  await app.bring(dxf("two.dxf", TWO_ROOMS, { units: 6 }));
  const all = await floor(app);
  const part = (name) => page.locator(`#floor-plan-parts [data-part=${name}]`);
  await part("room").click();
  await holds(app, "room");
  await click(app, 0.3, 0.5);
  await isDone(app);
  const one = await floor(app);
  assert.ok(one < 0.7 * all, `${one} of ${all}`);
  await page.keyboard.press("ControlOrMeta+z");
  await part("indoors").and(page.locator("[aria-pressed=true]")).waitFor();
  assert.equal(await floor(app), all);
  await page.keyboard.press("ControlOrMeta+Shift+z");
  await part("room").and(page.locator("[aria-pressed=true]")).waitFor();
  assert.equal(await floor(app), one);
  await page.keyboard.press("ControlOrMeta+z");
  await part("indoors").and(page.locator("[aria-pressed=true]")).waitFor();
  await page.keyboard.press("ControlOrMeta+z");
  await page.getByText("Nothing to undo").waitFor();

  // Opening another file is undone, too.
  await part("room").click();
  await holds(app, "room");
  await click(app, 0.3, 0.5);
  await isDone(app);
  await app.bring(dxf("square.dxf", [["WALLS", 0, 0, 2, 0], ["WALLS", 2, 0, 2, 2], ["WALLS", 2, 2, 0, 2], ["WALLS", 0, 2, 0, 0]], { units: 6 }));
  const square = await floor(app);
  assert.ok(square < 0.8 * one, `${square} of ${one}`);
  await page.locator("#floor-plan-floor").focus();
  await page.keyboard.press("ControlOrMeta+z");
  await page.getByText("Back to two.dxf").waitFor();
  assert.equal(await floor(app), one);
  await page.keyboard.press("ControlOrMeta+y");
  await page.getByText("Back to square.dxf").waitFor();
  assert.equal(await floor(app), square);

  await page.locator("#floor-plan-distance").evaluate((field) => {
    field.form.hidden = false;
    field.value = "";
    field.focus();
  });
  await page.keyboard.type("8,60");
  assert.equal(await page.locator("#floor-plan-distance").inputValue(), "8.60");
});

test("gaps between walls are closed as far as one likes", async (t) => {
  const { page, app } = await openFloorPlan(t);
  const side = [["WALLS", 0, 0, 4, 0], ["WALLS", 4, 0, 4, 3], ["WALLS", 4, 3, 0, 3], ["WALLS", 0, 3, 0, 2], ["WALLS", 0, 1.2, 0, 0]];
  await app.bring(dxf("open.dxf", side, { units: 6 }));
  await page.locator("#floor-plan-gap").fill("0");
  await page.getByRole("button", { name: "This room", exact: true }).click();
  await holds(app, "room");
  await click(app, 0.5, 0.5);
  await isDone(app);
  const leak = await text(app, "#floor-plan-result");
  assert.doesNotMatch(leak, /m² of floor/);
  assert.ok(leak.length > 20 && (await page.locator("#floor-plan-use").isDisabled()), leak);
  await page.locator("#floor-plan-gap").fill("1");
  const closed = await floor(app);
  assert.ok(closed > 11 && closed < 12.5, `${closed} m²`);
  assert.match(await text(app, "#floor-plan-result"), /1 gap closed/);
  assert.ok(await page.locator("#floor-plan-use").isEnabled());
});

test("a terrace door is told with its width, and one press closes it and leaves the inner door open", async (t) => {
  const { page, app, screenshot } = await openFloorPlan(t);
  const outer = [["WALLS", 0, 0, 8, 0], ["WALLS", 8, 0, 8, 6], ["WALLS", 8, 6, 0, 6], ["WALLS", 0, 6, 0, 4.3], ["WALLS", 0, 2, 0, 0]];
  await app.bring(dxf("terrace.dxf", [...outer, ["WALLS", 4, 0, 4, 2], ["WALLS", 4, 2.9, 4, 6]], { units: 6 }));
  const told = await app.poll(() => page.locator("#floor-plan-notice-text").textContent(), (words) => (words ?? "").includes("open to the outside"));
  const width = Number(/^About 2\d m² .* about ([\d.]+) m wide/.exec(told ?? "")?.[1]);
  assert.ok(Math.abs(width - 2.3) < 0.06, `${told}`);
  const half = await floor(app);
  assert.ok(half > 22 && half < 24, `${half} m²`);
  await screenshot("floor-plan-terrace-door");
  await page.getByRole("button", { name: "Close it", exact: true }).click();
  await page.locator("#floor-plan-notice").waitFor({ state: "hidden" });
  const all = await floor(app);
  assert.ok(all > 45 && all < 48, `${all} m²`);
  assert.match(await text(app, "#floor-plan-result"), /1 opening to the outside closed/);
  assert.equal(Number(await page.locator("#floor-plan-outer").inputValue()), width);
  assert.ok(await page.locator("#floor-plan-cut").isHidden(), "both rooms are within reach");
  // All of it has the garden, too: the robot stays indoors until it is let out.
  await page.locator("[data-part=whole]").click();
  const notice = (/** @type {RegExp} */ words) => app.poll(() => text(app, "#floor-plan-notice-text"), (told) => words.test(told));
  await notice(/Outer doors are closed/);
  await page.getByRole("button", { name: "Open them", exact: true }).click();
  await notice(/a robot gets out/);
  await page.getByRole("button", { name: "Close it", exact: true }).click();
  await notice(/open to the outside/);
});

test("what can't be read is refused, and what was there before stays", async (t) => {
  const { page, app } = await openFloorPlan(t);
  await app.bring(dxf("rooms.dxf", TWO_ROOMS, { units: 6 }));
  // What the page reads can be chosen, and what it only explains how to convert.
  const offered = (await page.locator("#files").getAttribute("accept")).split(",");
  for (const kind of [".dxf", ".svg", ".geojson", ".png", ".jpg", ".jpeg", ".webp", ".heic", ".pdf"]) assert.ok(offered.includes(kind), kind);
  const [before, room] = [await floor(app), await app.room()];
  const block = (name, inside) => ["0", "BLOCK", "8", "0", "2", name, "70", "0", "10", "0", "20", "0", "0", "INSERT", "8", "0", "2", inside, "10", "0", "20", "0", "0", "ENDBLK", "8", "0"];
  const cyclic = ["0", "SECTION", "2", "BLOCKS", ...block("A", "B"), ...block("B", "A"), "0", "ENDSEC", "0", "SECTION", "2", "ENTITIES", "0", "INSERT", "8", "0", "2", "A", "10", "0", "20", "0", "0", "ENDSEC", "0", "EOF"];
  const cases = [
    [anyFile("cut.dxf", dxf("", TWO_ROOMS, { units: 6 }).bytes.subarray(0, 300)), /cut\.dxf/],
    [anyFile("plan.dxf", "AC1027\0\0\0\0binary"), /plan\.dxf.*DWG/],
    [anyFile("cyclic.dxf", `${cyclic.join("\n")}\n`), /cyclic\.dxf/],
    [anyFile("letter.txt", "Dear reader,\nthis is no map.\n"), /letter\.txt.*unknown format/],
    [anyFile("empty.svg", "<svg xmlns='http://www.w3.org/2000/svg'></svg>"), /empty\.svg/],
  ];
  for (const [file, reason] of cases) {
    assert.ok(!(await app.bring(file)), file.name);
    await app.says(reason);
    await app.says(/Accepted formats: drawings \(DXF, SVG, GeoJSON\), images/);
    assert.equal(await text(app, "#floor-plan-name"), "rooms");
    assert.equal(await floor(app), before);
    assert.equal(await app.room(), room);
  }
});

test("Explore's room can be swept, and taken back with the planner", async (t) => {
  const { page, app } = await openFloorPlan(t, { address: "#room=hall20" });
  await page.locator("#floor-plan-empty [data-floor-plan=explore]").click();
  assert.ok((await floor(app)) > 100);
  await page.locator("#floor-plan-drive").click();
  await page.locator("#panel-explore").waitFor();
  assert.equal(await page.locator("#algorithm").inputValue(), "path");
  assert.equal(await page.locator("#robot").inputValue(), "own");
  await app.settled();
  assert.equal(await app.message(), "");
});

test("the slice of the obstacle map and the robot's outline", async (t) => {
  const { page, app } = await openFloorPlan(t);
  await app.bring(textMap("room.txt", openRoom(40, 30)));
  await page.locator("#floor-plan-body").selectOption("rectangle");
  await text(app, "#floor-plan-name");
  await page.locator("#floor-plan-first").fill("1");
  await page.locator("#floor-plan-second").fill("0.5");
  await page.keyboard.press("Tab");
  await text(app, "#floor-plan-name");
  assert.equal(await page.locator("#floor-plan-scan").getAttribute("placeholder"), "0.25", "half the width");
  await page.getByText("Connections, clearance, obstacle map").click();
  await page.locator("#floor-plan-slice").check();
  await page.locator("#floor-plan-slice-key").waitFor();
  await page.locator("#floor-plan-body").selectOption("polygon");
  await text(app, "#floor-plan-name");
  await page.locator("#floor-plan-corners").fill("0 0; 1 x");
  await page.keyboard.press("Tab");
  assert.match(await text(app, "#floor-plan-body-fault"), /corner 2/);
  assert.ok(await page.locator("#floor-plan-play").isDisabled());
  await page.locator("#floor-plan-corners").fill("0.2 -0.2; 0.2 0.2; -0.2 0.2; -0.2 -0.2");
  await page.keyboard.press("Tab");
  assert.equal(await text(app, "#floor-plan-body-fault"), "");
});

test("100,000 lines are drawn while the page answers", async (t) => {
  const { page, app } = await openFloorPlan(t);
  const lines = box("WALLS", 0, 0, 100, 100);
  for (let i = 0; i < 100_000; i += 1) lines.push(["HATCH", (i % 400) / 4, Math.floor(i / 400) * 0.4, (i % 400) / 4 + 0.2, Math.floor(i / 400) * 0.4 + 0.3]);
  const file = dxf("large.dxf", lines, { units: 6 });
  // Without the time that the test itself takes to hand the file over.
  await page.evaluate((content) => (window.largeFile = new File([content], "large.dxf")), file.bytes.toString());
  await page.context().browser().startTracing(page, { categories: ["-*", "toplevel"] });
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(window.largeFile);
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  });
  await page.locator("#floor-plan-empty").waitFor({ state: "hidden" });
  assert.match(await text(app, "#floor-plan-facts"), /100,004 strokes/);
  await page.mouse.move(683, 384);
  for (let i = 0; i < 10; i += 1) await page.mouse.wheel(0, i < 5 ? -200 : 200);
  await page.mouse.down();
  await page.mouse.move(500, 300, { steps: 10 });
  await page.mouse.up();
  await app.frames(10);
  // The longest task of the page's thread: in CPU time, however busy the machine is otherwise.
  const { traceEvents } = JSON.parse(await page.context().browser().stopTracing());
  const threads = new Set(traceEvents.filter(({ args }) => args.name === "CrRendererMain").map(({ pid, tid }) => `${pid} ${tid}`));
  const tasks = traceEvents.filter(({ tdur, pid, tid }) => tdur !== undefined && threads.has(`${pid} ${tid}`));
  assert.ok(tasks.length > 100, `${tasks.length} tasks`);
  const busy = Math.max(...tasks.map(({ tdur }) => tdur)) / 1000;
  t.diagnostic(`the page was busy for ${busy.toFixed(0)} ms at most`);
  assert.ok(busy < 100, `${busy} ms`);
});

test("cancelling brings back what was there before", async (t) => {
  const { page, app } = await openFloorPlan(t);
  await app.bring(dxf("rooms.dxf", TWO_ROOMS, { units: 6 }));
  await page.locator("#floor-plan-gap").fill("0.5");
  const before = await floor(app);
  const rows = Array.from({ length: 4096 }, () => ".".repeat(4096));
  await page.evaluate((content) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], "huge.txt"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, rows.join("\n"));
  // As soon as it may be pressed: a fast machine is done before a person could.
  await page.evaluate(() => new Promise((done) => {
    const look = () => (document.getElementById("panel-floor-plan").ariaBusy === "true" ? done(document.getElementById("floor-plan-cancel").click()) : requestAnimationFrame(look));
    look();
  }));
  // Again while it is brought back, which takes its time too.
  const busy = await page.evaluate(async () => {
    document.getElementById("floor-plan-cancel").click();
    document.getElementById("floor-plan-cancel").click();
    await new Promise((done) => setTimeout(done));
    return document.getElementById("panel-floor-plan").ariaBusy;
  });
  assert.equal(busy, "true");
  assert.equal(await text(app, "#floor-plan-name"), "rooms");
  await app.poll(() => floor(app), (area) => area === before);
  assert.equal(await page.locator("#floor-plan-gap").inputValue(), "0.5");
  assert.equal(await app.message(), "");
});

test("a board that breaks comes back, but not for ever", async (t) => {
  const { page, app } = await openApp(t);
  // It breaks where gaps of 1.5 m are closed, and again where those of 1 m were before.
  await page.route("**/floor-plan/worker.js*", async (route) => {
    const response = await route.fetch();
    const breaks = `self.addEventListener("message", (event) => {
      const { type, settings } = event.data;
      if (!settings || settings.gap !== { set: 1.5, restore: 1 }[type]) return;
      event.stopImmediatePropagation();
      for (const message of [{ type: "progress", done: 0 }, { type: "broken", message: "made to break" }]) self.postMessage(message);
    });`;
    await route.fulfill({ response, body: `${breaks}\n${await response.text()}` });
  });
  let workers = 0;
  page.on("worker", () => (workers += 1));
  await page.locator("#tab-floor-plan").click();
  await page.locator("#floor-plan-empty").waitFor();
  await app.bring(dxf("rooms.dxf", TWO_ROOMS, { units: 6 }));
  const before = await floor(app);
  await page.locator("#floor-plan-gap").fill("1.5");
  await app.says(/made to break.*being restored/);
  assert.equal(await floor(app), before);
  assert.match(await app.message(), /made to break/, "still to be read");
  await page.locator("#floor-plan-gap").fill("1");
  await text(app, "#floor-plan-name");
  assert.equal(workers, 2);
  await page.locator("#floor-plan-gap").fill("1.5");
  await app.says(/made to break.*Open the file again/);
  assert.equal(await text(app, "#floor-plan-name"), "No floor plan yet");
  assert.equal(workers, 3, "no more of them");
  await app.bring(dxf("rooms.dxf", TWO_ROOMS, { units: 6 }));
  assert.equal(await floor(app), before);
});

test("a pinch with the rectangle in the hand leaves no corner behind", async (t) => {
  const { page, app } = await openFloorPlan(t, PHONE);
  await app.bring(dxf("rooms.dxf", TWO_ROOMS, { units: 6 }));
  const whole = await floor(app);
  await page.locator("button[data-sheet=floor-plan-setup]").tap();
  await page.getByRole("button", { name: "Rectangle" }).tap();
  await page.locator("#floor-plan-setup").waitFor({ state: "hidden" });
  const { x, y, width, height } = await page.locator("#floor-plan-floor").boundingBox();
  const browser = await page.context().newCDPSession(page);
  const touch = (type, ...shares) => browser.send("Input.dispatchTouchEvent", { type, touchPoints: shares.map(([u, v], id) => ({ x: x + u * width, y: y + v * height, id })) });
  await touch("touchStart", [0.4, 0.5]);
  await touch("touchStart", [0.4, 0.5], [0.6, 0.5]);
  await touch("touchMove", [0.39, 0.5], [0.61, 0.5]);
  await touch("touchEnd");
  await app.frames(3);
  assert.equal(await floor(app), whole);
  await touch("touchStart", [0.3, 0.42]);
  await touch("touchMove", [0.5, 0.5]);
  await touch("touchMove", [0.6, 0.58]);
  await touch("touchEnd");
  await app.poll(() => floor(app), (part) => part > 0 && part < whole);
});

test("a cell without a width is refused, and the map stays", async (t) => {
  const { page, app } = await openFloorPlan(t);
  await app.bring(png("image.png", openRoom(40, 30)));
  await page.locator("#floor-plan-pixel").fill("0");
  await page.keyboard.press("Tab");
  await app.says(/0 cm wide.*0\.1 to 10000 cm/);
  assert.equal(await floor(app), 3);
  assert.equal(await page.locator("#floor-plan-pixel").inputValue(), "5");
});

test("fits a phone, with sheets under the drawing", async (t) => {
  const { page, app, screenshot } = await openFloorPlan(t, PHONE);
  await sample(app);
  await screenshot("floor-plan-phone");
  const small = () =>
    page.evaluate(() =>
      [...document.querySelectorAll("#panel-floor-plan :is(button:not(.term), select, input:not([type=checkbox]), summary), header button")]
        .filter((node) => node.checkVisibility({ visibilityProperty: true }))
        .map((node) => [node.id || node.textContent.trim(), node.getBoundingClientRect()])
        .filter(([, { width, height, right }]) => height < 39.9 || width < 32 || right > innerWidth + 1)
        .map(([name, { width, height }]) => `${name} ${width} x ${height}`),
    );
  assert.deepEqual(await small(), []);
  for (const sheet of ["floor-plan-setup", "floor-plan-sweep"]) {
    await page.locator(`button[data-sheet=${sheet}]`).tap();
    await page.locator(`#${sheet}.open`).waitFor();
    await screenshot(`floor-plan-phone-${sheet}`);
    assert.deepEqual(await small(), [], sheet);
    const sideways = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.equal(sideways, 0);
  }
  // A tool makes way for the drawing.
  await page.locator("button[data-sheet=floor-plan-setup]").tap();
  await page.getByRole("button", { name: "Scale by two points" }).tap();
  await page.locator("#floor-plan-setup").waitFor({ state: "hidden" });
  // The drawing begins 66 pixels below the top.
  await page.locator("#floor-plan-hint", { hasText: /^Tap two points/ }).waitFor();
  const [hint, stage] = await page.evaluate(() => ["hint", "stage"].map((name) => document.getElementById(`floor-plan-${name}`).getBoundingClientRect().toJSON()));
  assert.ok(hint.bottom - stage.top < 66, `${hint.bottom - stage.top} px`);
  await screenshot("floor-plan-phone-hint");
  // Their distance is asked for where one sees it.
  for (const x of [120, 260]) await page.touchscreen.tap(stage.left + x, stage.top + 150);
  await page.locator("#floor-plan-distance:focus").waitFor();
  await page.locator("#floor-plan-distance").fill("4");
  await page.getByRole("button", { name: "Set scale" }).tap();
  await page.locator("#floor-plan-setup").waitFor({ state: "hidden" });
});

test("a message lay on the walls of the drawing", async (t) => {
  const { page, app, screenshot } = await openFloorPlan(t);
  await app.bring(textMap("walls.txt", openRoom(100, 88)));
  /** Where the walls begin, the darkest that there is, CSS pixels from the upper edge of the stage. */
  const walls = () =>
    page.evaluate(() => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("floor-plan-floor"));
      const copy = new OffscreenCanvas(canvas.clientWidth, canvas.clientHeight).getContext("2d");
      copy.drawImage(canvas, 0, 0, canvas.clientWidth, canvas.clientHeight);
      const { data } = copy.getImageData(0, 0, canvas.clientWidth, canvas.clientHeight);
      const first = data.findIndex((red, at) => at % 4 === 0 && red < 120 && data[at + 3] === 255);
      return first / 4 / canvas.clientWidth;
    });
  const before = await app.poll(walls, (top) => top > 0);
  await app.drop(anyFile("broken.dxf", "  0\nSECTION\n  2\nENTITIES\n  0\nLINE\n  8\nWALLS\n 10\nabc\n"));
  await app.says(/"broken\.dxf".*needs a number/);
  const end = await page.evaluate(() => document.getElementById("message").getBoundingClientRect().bottom - document.getElementById("floor-plan-stage").getBoundingClientRect().top);
  assert.ok(before < end, `the message is high enough to lie on them: ${before} px, ${end} px`);
  await app.poll(walls, (top) => top >= end, "the walls begin below the message");
  await screenshot("floor-plan-message");
  await app.press("Dismiss");
  await app.poll(walls, (top) => Math.abs(top - before) < 1, "the drawing takes its place again");
});

test("one screen on a laptop, in words too", async (t) => {
  const { page, app } = await openFloorPlan(t, { viewport: { width: 1366, height: 768 } });
  await sample(app);
  const rails = await page.evaluate(() => [...document.querySelectorAll("#panel-floor-plan .rail")].map((rail) => rail.scrollHeight - rail.clientHeight));
  assert.deepEqual(rails, [0, 0], "nothing to be scrolled");
  assert.match(await page.locator("#floor-plan-floor").getAttribute("aria-label"), /^Floor plan sample flat, \d+ strokes .* square metres/);
  // The link opens the same tab again, whether or not the drawing was kept by then.
  await app.linked("tab");
  await page.reload();
  await page.locator("#floor-plan-empty").waitFor({ state: "attached" });
  assert.equal(await page.locator("#tab-floor-plan").getAttribute("aria-current"), "page");
});
