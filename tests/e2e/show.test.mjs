// What one sends and shows: pictures, films, frames in other pages, paper.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { openPage } from "./harness.mjs";

test("a picture of the floor with its numbers", async (t) => {
  const { app } = await openApp(t, { address: "#room=lshape&planner=snake&speed=64" });
  await app.numbersThat(({ coverage }) => coverage > 10);
  await app.pause();
  const [download] = await app.save("picture");
  assert.equal(download.suggestedFilename(), "l-shaped-room.png");
  const bytes = fs.readFileSync(await download.path());
  assert.equal(bytes.subarray(1, 4).toString(), "PNG");
  const [width, height] = [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
  // Sharp on a slide: more pixels than the canvas of 600 has.
  assert.ok(width > 1200 && bytes.length > 5000, `${width} pixels, ${bytes.length} bytes`);
  // The room of 6 by 5 m with a margin, and the line of numbers below; not what else the canvas has.
  const line = Math.min(56, Math.max(22, 0.032 * width));
  assert.ok(Math.abs(width / (height - line) - 6.36 / 5.36) < 0.02, `${width} × ${height}`);
});

// slow: 3 s, every frame of a film is drawn and encoded.
test("a film of the run plays in any player: its length, its size, and what happens in it", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&planner=snake&speed=1" });
  const before = await app.numbersThat(({ time }) => time >= 2);
  const [download] = await app.save("film");
  assert.match(download.suggestedFilename(), /\.webm$/);
  const film = fs.readFileSync(await download.path()).toString("base64");
  const seen = await page.evaluate(async (text) => {
    const video = document.createElement("video");
    video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], { type: "video/webm" }));
    video.muted = true;
    await new Promise((done, fail) => Object.assign(video, { onloadeddata: done, onerror: () => fail(new Error(video.error?.message)) }));
    const canvas = new OffscreenCanvas(video.videoWidth, video.videoHeight);
    const context = canvas.getContext("2d");
    const look = () => (context.drawImage(video, 0, 0), context.getImageData(0, 0, canvas.width, canvas.height).data);
    const at = async (seconds) => {
      video.currentTime = seconds;
      await new Promise((done) => (video.onseeked = done));
      return look();
    };
    const [first, last] = [await at(0.1), await at(video.duration - 0.2)];
    let changed = 0;
    for (let i = 0; i < first.length; i += 4) changed += Math.abs(first[i] - last[i]) > 40 ? 1 : 0;
    return { seconds: video.duration, width: video.videoWidth, changed: changed / (canvas.width * canvas.height), light: [first, last].map((data) => data.reduce((sum, value) => sum + value, 0) / data.length) };
  }, film);
  // The run, which was going on, goes on where it was.
  await app.until("playing", "finished");
  const after = await app.numbersThat(({ time }) => time >= before.time);
  assert.ok(seen.seconds > Math.min(12, before.time) + 0.4 && seen.seconds < after.time + 2.6, `${seen.seconds} s of a run of ${before.time} to ${after.time} s`);
  assert.ok(seen.width > 300);
  assert.ok(seen.changed > 0.002 && seen.changed < 0.5, JSON.stringify(seen));
});

test("in a frame of another page there are floor and play bar alone, and the way to the whole page", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "?embed#room=lshape&planner=snake", viewport: { width: 720, height: 540 } });
  for (const hidden of [".bar", "#setup", "#facts", "#tools", ".sheet-bar"]) assert.ok(await page.locator(hidden).first().isHidden(), hidden);
  for (const shown of ["#floor", "#play", "#scrubber"]) assert.ok(await page.locator(shown).isVisible(), shown);
  const { width, height } = await page.locator("#stage").boundingBox();
  assert.ok(width === 720 && height > 300, `${width} × ${height}`);
  await app.numbersThat(({ distance }) => distance > 0.1);
  await screenshot("embed");
  const link = page.locator("a.to-page");
  await link.focus();
  assert.match(await link.getAttribute("href"), /\/#room=lshape&planner=snake/);
  // It says what is shown; and its end takes one line, so that the floor stays large.
  assert.match(await link.innerText(), /^L-shaped room: Improved snake, .*Robovac Playground$/s);
  await page.evaluate(() => (location.hash = "room=lshape&planner=snake&speed=0"));
  await app.until("finished");
  await page.locator("#ending", { hasText: /^Done/ }).waitFor();
  await screenshot("embed-end");
  const [end, stage] = [await page.locator("#ending").boundingBox(), await page.locator("#stage").boundingBox()];
  assert.ok(end.height <= 48 && end.y + end.height < stage.y + 0.3 * stage.height, JSON.stringify(end));
});

test("a frame with the tab Compare names the room, and is the way to the whole page", async (t) => {
  const { page } = await openPage(t, { address: "?embed#room=lshape&tab=compare", viewport: { width: 720, height: 540 } });
  await page.locator("#race-play").waitFor();
  const link = page.locator("a.to-page");
  await link.filter({ hasText: /^L-shaped room.*Robovac Playground$/ }).waitFor();
  await link.focus();
  const address = new URL(await link.getAttribute("href"), page.url());
  assert.deepEqual([address.search, new URLSearchParams(address.hash.slice(1)).get("tab")], ["", "compare"]);
});

test("copying a link offers the HTML for a frame, which leads to the same", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=lshape&planner=snake", viewport: { width: 1440, height: 900 }, permissions: ["clipboard-read", "clipboard-write"] });
  await page.getByRole("button", { name: "Copy link" }).click();
  const ways = page.locator("#ways");
  await ways.waitFor();
  await screenshot("ways");
  await ways.getByRole("button", { name: "Copy HTML" }).click();
  const html = await app.poll(() => page.evaluate(() => navigator.clipboard.readText()), (text) => /^<iframe/.test(text));
  const address = /src="([^"]+)"/.exec(html)[1].replaceAll("&amp;", "&");
  assert.equal(new URL(address).search, "?embed");
  assert.match(new URL(address).hash, /^#room=lshape&planner=snake/);
  await page.keyboard.press("Escape");
  await ways.waitFor({ state: "hidden" });
});

test("prints the floor, the numbers and the link, in light colours", async (t) => {
  const { page, app, screenshot } = await openApp(t, { address: "#room=lshape&planner=snake", colorScheme: "dark", viewport: { width: 794, height: 1123 } });
  await page.mouse.move(100, 100);
  await page.locator("link[href*='print.css']").waitFor({ state: "attached" });
  await app.pause();
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await screenshot("print");
  assert.match(await page.locator("#printed").innerText(), /^L-shaped room: .+\nhttp:\/\/.+room=lshape/s);
  for (const shown of ["#floor", "#metrics", "#scrubber"]) assert.ok(await page.locator(shown).isVisible(), shown);
  for (const hidden of ["#setup", "#play", "#tools", ".bar-actions"]) assert.ok(await page.locator(hidden).isHidden(), hidden);
  const paper = await page.evaluate(() => getComputedStyle(document.body).color);
  assert.ok(paper.match(/[\d.]+/g).slice(0, 3).every((part) => Number(part) < 80), `text is ${paper}`);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme ?? ""), "");
});

test("Help tells version, licence and whose algorithms these are; links to the page have a picture", async (t) => {
  const { page, server, screenshot } = await openApp(t, { viewport: { width: 1440, height: 900 } });
  await page.keyboard.press("?");
  await page.locator("#help-about-title").scrollIntoViewIfNeeded();
  assert.match(await page.locator(".about p").innerText(), /Playground \d+\.\d+\.\d+, build [0-9a-f]{12}\. (Source code|Free software) under the MIT licence/);
  await page.locator(".about summary").click();
  await screenshot("about");
  assert.equal(await page.locator("#authors li").count(), await page.locator("#algorithm option").count());
  for (const [name, words] of [["MIT licence", /Permission is hereby granted/], ["Apache License 2.0", /Version 2\.0, January 2004/]]) {
    const licence = await fetch(new URL(await page.locator(".about").getByRole("link", { name }).getAttribute("href"), server.url));
    assert.match(await licence.text(), words);
  }
  const description = (property) => page.locator(`meta[${property}]`).getAttribute("content");
  assert.equal(await description("property='og:description'"), await description("name='description'"));
  const picture = await page.locator("meta[property='og:image']").getAttribute("content");
  const response = await fetch(new URL(picture, server.url));
  assert.equal(response.status, 200);
});
