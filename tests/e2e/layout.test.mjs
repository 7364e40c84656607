// The layout on a phone and on a laptop, light and dark. With PICTURES=1 it takes screenshots.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp } from "./app.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };
const LAPTOP = { viewport: { width: 1440, height: 900 } };

/** Controls that are shown, with their sizes. */
const controls = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("button:not(.term), select, input, summary")]
      .filter((node) => node.checkVisibility({ visibilityProperty: true }))
      .map((node) => {
        const label = node.matches("input[type=checkbox]") ? (node.closest("label") ?? node) : node;
        const { x, y, width, height } = label.getBoundingClientRect();
        return { name: node.id || node.dataset.tool || node.dataset.sheet || node.ariaLabel || node.type || node.localName, x, y, width, height };
      })
      .filter(({ x, y, width, height }) => width > 0 && height > 0 && x + width > 0 && y < innerHeight && y + height > 0),
  );

/** Those that a rail has scrolled out of view. */
const hiddenInRail = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll(".rail :is(button, select, input, summary)")]
      .filter((node) => node.getBoundingClientRect().top > node.closest(".rail").getBoundingClientRect().bottom)
      .map((node) => node.getBoundingClientRect().y),
  );

const overflow = (page) =>
  page.evaluate(() => {
    const { scrollWidth, scrollHeight, clientWidth, clientHeight } = document.documentElement;
    return { sideways: scrollWidth - clientWidth, down: scrollHeight - clientHeight };
  });

/** It has dark colours too, for those who prefer them, and a button that turns it light. */
async function turnsDark({ page, app, screenshot }, name) {
  await page.emulateMedia({ colorScheme: "dark" });
  const brightness = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).slice(0, 3).reduce((sum, n) => sum + Number(n), 0));
  const dark = await app.poll(brightness, (sum) => sum < 300);
  await screenshot(`${name}-dark`);
  await page.locator("#theme").click();
  await app.poll(brightness, (sum) => sum > dark + 300, "the button to turn it light");
}

test("fits a phone, with controls for fingers", async (t) => {
  const { page, app, screenshot } = await openApp(t, PHONE);
  await screenshot("phone-light");
  assert.deepEqual(await overflow(page), { sideways: 0, down: 0 });
  const small = ({ width, height }) => height < 40 || width < 32;
  assert.deepEqual((await controls(page)).filter(small), []);

  for (const sheet of ["setup", "facts", "senses", "explainer"]) {
    const opener = page.locator(`button[data-sheet=${sheet}]`);
    await opener.tap();
    await page.locator(`#${sheet}.open`).waitFor();
    assert.equal(await opener.getAttribute("aria-expanded"), "true");
    await screenshot(`phone-${sheet}`);
    assert.equal((await overflow(page)).sideways, 0, sheet);
    assert.deepEqual((await controls(page)).filter(small), [], sheet);
    await page.locator(`#${sheet} .sheet-close`).tap();
    await page.locator(`#${sheet}`).waitFor({ state: "hidden" });
    assert.equal(await opener.getAttribute("aria-expanded"), "false");
  }
  await page.getByRole("button", { name: "Pause" }).tap();
  await app.until("paused");
  await turnsDark({ page, app, screenshot }, "phone");
});

for (const [name, viewport] of Object.entries({ "a phone": { width: 390, height: 844 }, "a small phone": { width: 360, height: 640 }, "a phone on its side": { width: 844, height: 390 }, "a small phone on its side": { width: 667, height: 375 }, "200 %": { width: 720, height: 450 }, "200 % on a small laptop": { width: 640, height: 360 } })) {
  test(`tabs and legend are whole on ${name}, and nothing lies over the floor`, async (t) => {
    const { page, app } = await openApp(t, { ...PHONE, viewport });
    /** Those that aren't wholly within the window, or under something. */
    const cut = (selector) =>
      page.locator(selector).evaluateAll((nodes) =>
        nodes.filter((node) => node.checkVisibility()).flatMap((node) => {
          const { left, top, right, bottom } = node.getBoundingClientRect();
          const isSeen = (x, y) => node.contains(document.elementFromPoint(x, y));
          return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight && isSeen(left + 3, (top + bottom) / 2) && isSeen(right - 3, (top + bottom) / 2) ? [] : [node.textContent.trim()];
        }),
      );
    assert.equal(await page.locator("[id^=tab-]:visible").count(), 6);
    assert.deepEqual(await cut("[id^=tab-]"), []);
    assert.ok((await page.locator("#legend > div:visible").count()) >= 5);
    assert.deepEqual(await cut("#legend > div"), []);
    assert.deepEqual(await cut("#play, #tools button, #numbers > div, .bar-actions button"), []);
    // The room keeps 66 px from the stage's upper and lower edge for tools, legend and zoom buttons.
    const covering = () =>
      page.evaluate(() => {
        const stage = document.querySelector(".tab-panel:not([hidden]) .stage");
        const { top, bottom, left, width } = stage.getBoundingClientRect();
        const found = new Set();
        for (let y = top + 66; y <= bottom - 66; y += 6) for (let x = left + 6; x < left + width; x += 12) {
          const node = document.elementFromPoint(x, y);
          if (!(node instanceof HTMLCanvasElement)) found.add(node.id || node.className);
        }
        return [...found];
      });
    assert.deepEqual(await covering(), []);
    await page.locator("#tab-map").click();
    await page.locator("#map-hint").waitFor();
    await app.poll(covering, (found) => found.length === 0, "nothing over the map");
    assert.deepEqual(await overflow(page), { sideways: 0, down: 0 });
  });
}

test("messages on a phone hide little of the floor, and never the robot", async (t) => {
  const { page, app, screenshot } = await openApp(t, { ...PHONE, address: "#room=empty&speed=1" });
  // Near the lower wall of the room, and near the upper one: the whole room gives way to a message. A part of it can't, so the message
  // makes way for the robot.
  for (const [y, isWhole] of [[0.5, true], [3.5, true], [3.5, false]]) {
    await page.evaluate((at) => (location.hash = `room=empty&speed=1&start=1,${at},0`), y);
    await app.linked("start", (start) => Number(start.split(",")[1]) === y);
    await app.settled();
    await app.pause();
    if (!isWhole) await page.locator("#zoom-in").tap();
    // A link that can't be followed changes nothing.
    await page.evaluate((at) => (location.hash = `planner=no_such_${at}`), `${y}_${isWhole}`);
    await app.says(/There is no algorithm "no_such/);
    const [message, stage] = await page.evaluate(() => ["message", "stage"].map((id) => document.getElementById(id).getBoundingClientRect()));
    await screenshot(`phone-message-${y}-${isWhole}`);
    assert.ok(message.height < 0.3 * stage.height, `${message.height} of ${stage.height} px`);
    const middle = (stage.top + stage.bottom) / 2;
    assert.ok(isWhole ? message.bottom < middle : message.top > middle, `${y} m: ${message.top} to ${message.bottom}`);
    await page.locator("#message-close").tap();
    await page.locator("#message").waitFor({ state: "hidden" });
  }
});

for (const [width, height] of [[390, 844], [360, 640]])
  test(`a game and a run's end leave the floor to the room at ${width} x ${height}`, async (t) => {
    const { page, app, screenshot } = await openApp(t, { ...PHONE, viewport: { width, height }, address: "#room=thesis8&planner=boustrophedon&speed=0" });
    const box = (selector) => page.locator(selector).evaluate((node) => (({ left, top, right, bottom }) => ({ left, top, right, bottom }))(node.getBoundingClientRect()));
    const isClear = async (card) => {
      const [it, stage, play] = [await box(card), await box("#stage"), await box("#play")];
      assert.ok(it.left >= 0 && it.right <= width && it.bottom <= play.top, JSON.stringify({ it, play }));
      assert.ok(it.top > stage.bottom - 66, JSON.stringify({ it, stage }));
    };
    await app.until("finished");
    await page.locator("#ending").waitFor();
    await screenshot(`ending-${width}`);
    // A taller phone has room for it below its palette.
    if (height < 700) await isClear("#ending");
    await page.locator("[data-sheet=try]").tap();
    await page.locator(".ideas button", { hasText: "You against the algorithm" }).tap();
    await page.locator(".game").waitFor();
    await isClear(".game");
    await page.locator(".game").getByRole("button", { name: "Start", exact: true }).tap();
    await page.locator(".game", { hasText: "Your turn" }).waitFor();
    await isClear(".game");
    await screenshot(`game-${width}`);
  });

for (const [width, height] of [[390, 844], [844, 390], [640, 360], [568, 320]])
  test(`beside a lesson the floor is seen at ${width} x ${height}, and the end of a run hides neither it nor the lesson's buttons`, async (t) => {
    const { page, app, screenshot } = await openApp(t, { ...PHONE, viewport: { width, height }, address: "#room=thesis8&robot=roomba600&planner=boustrophedon&speed=0" });
    await page.locator("#learn-open").tap();
    await page.locator("#learn .lessons button").first().tap();
    await page.locator("#learn h3").first().waitFor();
    await app.settled();
    if (["ready", "paused"].includes(await app.state())) await app.press("Play");
    await app.until("finished");
    await page.locator("#ending").waitFor();
    await screenshot(`lesson-${width}`);
    assert.match(await page.locator("#now").innerText(), /Boustrophedon.*Roomba 600/, "the algorithm and the robot are named");
    const box = (selector) => page.locator(selector).evaluate((node) => (({ left, top, right, bottom }) => ({ left, top, right, bottom }))(node.getBoundingClientRect()));
    const [end, floor, head, numbers] = [await box("#ending"), await box("#floor"), await box("#learn .learn-head"), await box("#numbers")];
    const overlap = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    assert.ok(floor.bottom - floor.top > 150 && floor.right - floor.left > 300, JSON.stringify(floor));
    assert.deepEqual([floor, head, numbers].map((one) => overlap(end, one)), [false, false, false]);
    assert.ok(end.bottom <= height && end.left >= 0 && end.right <= width, JSON.stringify(end));
    const cut = await page.locator("#numbers dd").evaluateAll((nodes) => nodes.filter((node) => node.checkVisibility() && node.getBoundingClientRect().right > document.getElementById("floor").getBoundingClientRect().right).length);
    assert.equal(cut, 0, "numbers that run under the lesson");
    assert.equal((await overflow(page)).sideways, 0);
  });

for (const [width, height] of [[390, 844], [360, 640], [844, 390], [640, 360], [568, 320]])
  test(`beside Learn the cards of Floor plan and Robot can be read at ${width} x ${height}, and Map shows the room`, async (t) => {
    const { page, app, screenshot } = await openApp(t, { ...PHONE, viewport: { width, height }, address: "#room=bedroom" });
    await page.locator("#learn-open").tap();
    await page.locator("#learn .lessons button").first().waitFor();
    for (const [tab, card] of [["floor-plan", ".floor-plan-card"], ["connection", "#connection-welcome"]]) {
      await page.locator(`#tab-${tab}`).tap();
      await page.locator(card).waitFor();
      const { left, right } = await page.locator(card).evaluate((node) => (({ left, right }) => ({ left, right }))(node.getBoundingClientRect()));
      assert.ok(right - left > 230, `${tab}: ${right - left} px`);
      const cut = await page.locator(`${card} :is(h2, button)`).evaluateAll((nodes, [from, to]) => nodes.filter((node) => node.checkVisibility()).filter((node) => node.getBoundingClientRect().left < from || node.getBoundingClientRect().right > to).length, [left, right]);
      assert.equal(cut, 0, `${tab}: headings and buttons that run out of the card`);
      await screenshot(`learn-${tab}-${width}`);
    }
    await page.locator("#tab-map").tap();
    await page.locator("#map-hint").waitFor();
    const heightOf = (selector) => page.locator(selector).evaluate((node) => (node.checkVisibility() ? node.getBoundingClientRect().height : 0));
    const [floor, tools, hint] = [await heightOf("#map-floor"), await heightOf(".map .tools"), await heightOf("#map-hint")];
    assert.ok(tools + hint < 0.75 * floor, `${tools} + ${hint} px of ${floor} px are covered`);
    // While it maps, the palette is all that lies over the floor; what the robot does stands below it, what to do on the lesson.
    const over = () =>
      page.evaluate(() => {
        const { left, top, right, bottom } = document.getElementById("map-floor").getBoundingClientRect();
        const found = new Set();
        for (let y = top + 2; y < bottom; y += 4) for (let x = left + 2; x < right; x += 8) {
          const node = document.elementsFromPoint(x, y).find((one) => !(one instanceof HTMLCanvasElement) && !one.matches(".stage, .tab-panel, main, body, html"));
          if (node) found.add(node.closest("#map-tools")?.id ?? (node.id || node.className));
        }
        return [...found];
      });
    await page.locator("#map-hint-play").tap();
    await app.poll(() => page.locator("#map-doing").textContent(), (doing) => doing.length > 0);
    assert.deepEqual(await over(), ["map-tools"]);
    const [doing, below] = await page.evaluate(() => ["map-doing", "map-floor"].map((id) => (({ top, bottom }) => ({ top, bottom }))(document.getElementById(id).getBoundingClientRect())));
    assert.ok(below.bottom <= doing.top && doing.bottom > doing.top, JSON.stringify({ doing, below }));
    await page.locator("#map-lift").tap();
    await page.locator("#map-held").waitFor();
    assert.deepEqual(await over(), ["map-tools"]);
    await screenshot(`learn-map-held-${width}`);
    assert.equal((await overflow(page)).sideways, 0);
  });

test("a finger draws walls on a phone, two fingers don't", async (t) => {
  const { page, app } = await openApp(t, { ...PHONE, address: "#room=empty" });
  const area = await app.reachableArea();
  await page.locator("#tools [data-tool=wall]").tap();
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...points) => client.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const [a, b] = [await app.spot(0.02, 0.5), await app.spot(0.98, 0.5)];
  await touch("touchStart", a);
  await touch("touchMove", b);
  await touch("touchEnd");
  await app.settled();
  const half = await app.reachableArea();
  assert.ok(half < 0.7 * area, `${half} m² of ${area} m²`);
  await page.locator("#tools [data-tool=view]").tap();
  await touch("touchStart", await app.spot(0.4, 0.5));
  await touch("touchStart", await app.spot(0.4, 0.5), await app.spot(0.6, 0.5));
  await touch("touchMove", await app.spot(0.2, 0.5), await app.spot(0.8, 0.5));
  await touch("touchEnd");
  await app.settled();
  assert.equal(await app.reachableArea(), half);
});

test("rails and legend are whole in a small window", async (t) => {
  const { page, app } = await openApp(t, { viewport: { width: 1000, height: 640 }, address: "#room=flat" });
  await app.numbersThat(({ time }) => time > 1);
  const cut = await page.evaluate(() => [...document.querySelectorAll(".explore .rail")].filter((rail) => rail.scrollWidth > rail.clientWidth).map(({ className }) => className));
  assert.deepEqual(cut, []);
  const [legend, stage] = await page.evaluate(() => ["legend", "stage"].map((id) => document.getElementById(id).getBoundingClientRect()));
  assert.ok(legend.top >= stage.bottom - 66, `${stage.bottom - legend.top} px: it covers the floor`);
});

test("fits a laptop without scrolling", async (t) => {
  const { page, app, screenshot } = await openApp(t, LAPTOP);
  await screenshot("laptop-light");
  assert.deepEqual(await overflow(page), { sideways: 0, down: 0 });
  const below = await hiddenInRail(page);
  const inside = ({ x, y, width, height }) => x >= 0 && y >= 0 && x + width <= 1440 && y + height <= 900;
  assert.deepEqual((await controls(page)).filter((control) => !inside(control) && !below.includes(control.y)), []);
  await app.unfold();
  await app.frames(1);
  assert.deepEqual(await overflow(page), { sideways: 0, down: 0 }, "unfolded");
  await screenshot("laptop-unfolded");
  await turnsDark({ page, app, screenshot }, "laptop");
  await page.keyboard.press("?");
  await screenshot("laptop-help");
});
