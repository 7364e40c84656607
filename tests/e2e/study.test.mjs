// The results of a study in Compare: a file that `robovac study` wrote is dropped, and chart, table and files tell of it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { openApp } from "./app.mjs";

const STUDY = {
  format: "robovac-study",
  version: 1,
  rooms: [{ room: "bedroom" }, { flats: { first: 1, count: 2, area_m2: [25, 30] } }],
  robots: [{ robot: "roomba600" }],
  algorithms: [{ behaviour: "bounce" }, { behaviour: "spiral_out" }, { planner: "snake", params: { patience: 3 } }],
  conditions: [{ name: "perfect" }, { name: "typical", slip: "typical", noise: "typical" }],
  seeds: { first: 1, count: 4 },
  minutes: 2,
};

/** The bytes of its results. */
function results() {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robovac-"));
  const [study, out] = ["study.json", "results.parquet"].map((name) => path.join(folder, name));
  fs.writeFileSync(study, JSON.stringify(STUDY));
  execFileSync(process.env.ROBOVAC, ["study", study, "--out", out], { stdio: "ignore" });
  const bytes = fs.readFileSync(out);
  fs.rmSync(folder, { recursive: true });
  return bytes;
}

/** Drops a file onto the page. */
const drop = (page, name, bytes) =>
  page.evaluate(
    ([name, text]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], name));
      for (const type of ["dragenter", "drop"]) document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    },
    [name, bytes.toString("base64")],
  );

test("a study's file opens in Compare, and its rooms and conditions can be chosen", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty" });
  const bytes = results();
  await drop(page, "results.parquet", bytes);
  await page.locator("#study-table tbody tr").first().waitFor();
  assert.equal(await page.locator("#view-study").getAttribute("aria-pressed"), "true");
  const names = await page.locator("#study-table tbody th").allTextContents();
  assert.deepEqual(names.map((name) => name.replace(/12 runs$/, "")).sort(), ["Bounce", "Improved snake (patience:3)", "Spiral"]);
  const count = page.locator("#study-table tbody th small").first();
  assert.equal(await count.evaluate((small) => getComputedStyle(small).display), "block", "the number of runs stands below the name");
  assert.match(await app.text("#study-note"), /^36 of 72 runs\. /);
  assert.equal(await page.locator("#study-plot .curve").count(), 3);
  const coverage = () => page.locator("#study-table tbody tr").first().locator("td").nth(4).textContent();
  const all = await coverage();
  await page.locator("#study-rooms").selectOption("bedroom");
  assert.match(await app.text("#study-note"), /^12 of 72 runs\. /);
  assert.notEqual(await coverage(), all);
  await page.locator("#study-conditions").selectOption("typical");
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("[data-export=csv]").click()]);
  const csv = fs.readFileSync(await download.path(), "utf8").trim().split("\n");
  assert.ok(csv.length === 4 && csv[1]?.includes('"bedroom","roomba600","typical",4,'), csv.join("\n"));

  // What isn't a study says so, and leaves the other where it is.
  const cut = { name: "cut.parquet", mimeType: "application/octet-stream", buffer: bytes.subarray(0, 1000) };
  await page.locator("#study-file").setInputFiles(cut);
  await page.getByText("isn't a complete Parquet file").first().waitFor();
  assert.equal(await page.locator("#study-table tbody tr").count(), 3);
});
