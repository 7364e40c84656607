// The floor plan survives a reload; what another version of the page has kept is explained and not lost.
import assert from "node:assert/strict";
import fs from "node:fs";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { anyFile } from "./maps.mjs";

/** A room of 4 m x 3 m with a table, in metres. */
function room(name) {
  const box = (layer, x, y, w, h) => [[layer, x, y, x + w, y], [layer, x + w, y, x + w, y + h], [layer, x + w, y + h, x, y + h], [layer, x, y + h, x, y]];
  const rows = ["0", "SECTION", "2", "HEADER", "9", "$INSUNITS", "70", "6", "0", "ENDSEC", "0", "SECTION", "2", "ENTITIES"];
  for (const [layer, ...at] of [...box("WALLS", 0, 0, 4, 3), ...box("FURNITURE", 1, 1, 1, 1)]) rows.push("0", "LINE", "8", layer, ...["10", "20", "11", "21"].flatMap((code, i) => [code, at[i]]));
  return anyFile(name, `${rows.join("\n")}\n0\nENDSEC\n0\nEOF\n`);
}

const at = (app, selector) => app.page.locator(selector);

/** Waits until the floor plan is at rest; returns the text about the room. */
async function result(app) {
  await app.frames(2);
  await app.page.waitForFunction(() => document.getElementById("panel-floor-plan").ariaBusy !== "true");
  return at(app, "#floor-plan-result").textContent();
}

/** Waits until the browser has kept what is shown: file, gap and stage of the sweep. */
const kept = (app) =>
  app.poll(
    () =>
      app.page.evaluate(
        () =>
          new Promise((resolve, reject) => {
            const request = indexedDB.open("robovac-drafts");
            request.onerror = () => reject(request.error);
            request.onsuccess = () => {
              const all = request.result.transaction("board").objectStore("board").getAll();
              all.onsuccess = () => {
                request.result.close();
                const [choices, files] = all.result;
                const stage = Number(document.querySelector("#panel-floor-plan [data-stage][aria-pressed=true]")?.dataset.stage ?? 0);
                resolve(
                  files?.files[0]?.name === `${document.getElementById("floor-plan-name").textContent}.dxf` &&
                    choices.settings.gap === Number(document.getElementById("floor-plan-gap").value) &&
                    choices.stage === stage,
                );
              };
            };
          }),
      ),
    Boolean,
    "what is shown to be kept",
  );

/** Waits until all choices are stored, and opens the page again. */
async function reload(app) {
  await kept(app);
  await app.page.reload();
  await app.page.locator("#panel-floor-plan #floor-plan-empty").waitFor({ state: "attached" });
}

/** Changes what is kept under a key. */
const edit = (app, key, change) =>
  app.page.evaluate(
    ([key, source]) =>
      new Promise((resolve, reject) => {
        const change = new Function(`return ${source}`)();
        const request = indexedDB.open("robovac-drafts");
        request.onsuccess = () => {
          const board = request.result.transaction("board", "readwrite").objectStore("board");
          const kept = board.get(key);
          kept.onsuccess = () => board.put(change(kept.result), key);
          board.transaction.oncomplete = () => {
            request.result.close();
            resolve(undefined);
          };
          board.transaction.onerror = () => reject(board.transaction.error);
        };
      }),
    [key, change.toString()],
  );

async function openSample(t) {
  const opened = await openApp(t);
  await opened.app.bring(room("cellar.dxf"));
  await at(opened.app, "#floor-plan-gap").fill("0.5");
  await opened.page.getByLabel("What FURNITURE is").selectOption("ignored");
  await opened.page.locator("[data-stage='3']").click();
  await opened.page.locator("#floor-plan-numbers").waitFor();
  await opened.page.locator("[data-stage='3'][aria-pressed=true]").waitFor();
  return opened;
}

test("a floor plan comes back after a reload, with what was chosen and its sweep", async (t) => {
  const { page, app } = await openSample(t);
  const before = await result(app);
  const length = await at(app, "#floor-plan-n-length").textContent();
  await reload(app);
  await app.poll(() => at(app, "#floor-plan-name").textContent(), (name) => name === "cellar");
  assert.equal(await result(app), before);
  assert.equal(await at(app, "#floor-plan-gap").inputValue(), "0.5");
  assert.equal(await page.getByLabel("What FURNITURE is").inputValue(), "ignored");
  await page.locator("[data-stage='3'][aria-pressed=true]").waitFor();
  assert.equal(await at(app, "#floor-plan-n-length").textContent(), length);
  assert.equal(await app.message(), "");
  assert.ok(await at(app, "#floor-plan-aside").isHidden());
  // A file opened at the start of a visit isn't replaced by the stored one.
  await page.locator("#tab-explore").click();
  await app.linked("tab", (tab) => tab !== "floor-plan");
  await page.reload();
  await app.settled();
  await app.bring(room("attic.dxf"));
  assert.equal(await at(app, "#floor-plan-name").textContent(), "attic");
  // And that for good.
  await app.frames(20);
  assert.equal(await at(app, "#floor-plan-name").textContent(), "attic");
  await reload(app);
  await app.poll(() => at(app, "#floor-plan-name").textContent(), (name) => name === "attic");
});

test("choices of another version are explained and can be saved; the files come back", async (t) => {
  const { page, app } = await openSample(t);
  await reload(app);
  await app.poll(() => at(app, "#floor-plan-name").textContent(), (name) => name === "cellar");
  await page.locator("[data-stage='3'][aria-pressed=true]").waitFor();
  await kept(app);
  await edit(app, "choices", (kept) => ({ ...kept, settings: { ...kept.settings, gap: "a foot" } }));
  await page.reload();
  await app.says(/settings for cellar\.dxf were saved by another version.*a foot.*reset/);
  assert.equal(await at(app, "#floor-plan-name").textContent(), "cellar");
  assert.equal(await at(app, "#floor-plan-gap").inputValue(), "0.1");
  const [download] = await Promise.all([page.waitForEvent("download"), at(app, "#floor-plan-aside-save").click()]);
  assert.match(fs.readFileSync(await download.path(), "utf8"), /a foot/);
  // Until it is discarded.
  await reload(app);
  await at(app, "#floor-plan-aside").waitFor();
  await at(app, "#floor-plan-aside-discard").click();
  await at(app, "#floor-plan-aside").waitFor({ state: "hidden" });
  await reload(app);
  await app.poll(() => at(app, "#floor-plan-name").textContent(), (name) => name === "cellar");
  assert.ok(await at(app, "#floor-plan-aside").isHidden());
});

test("files of another version, or that can't be read, are kept aside", async (t) => {
  const { page, app } = await openSample(t);
  await kept(app);
  await edit(app, "files", (kept) => ({ ...kept, format: 99 }));
  await page.reload();
  await app.says(/saved by another version of this page, and this one can't read it/);
  assert.ok(await at(app, "#floor-plan-empty").isVisible());
  const [download] = await Promise.all([page.waitForEvent("download"), at(app, "#floor-plan-aside-save").click()]);
  assert.equal(download.suggestedFilename(), "cellar.dxf");
  await at(app, "#floor-plan-aside-discard").click();

  await app.bring(room("cellar.dxf"));
  await kept(app);
  await edit(app, "files", (kept) => ({ ...kept, files: [new File(["0\nSECTION\n2\nENTITIES\n0\nLINE\n"], "cellar.dxf")] }));
  await page.reload();
  await app.says(/floor plan cellar\.dxf can't be restored: .*cut off/);
  await at(app, "#floor-plan-aside").waitFor();
  // Other files can still be opened.
  await app.bring(room("attic.dxf"));
  assert.equal(await at(app, "#floor-plan-name").textContent(), "attic");
});
