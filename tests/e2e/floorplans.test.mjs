// Real floor plans, on machines that have them: a folder named by FLOORPLANS, or ../shared/maps/floorplans. They may not be
// published, so they aren't in this repository.
import assert from "node:assert/strict";
import fs from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { openApp } from "./app.mjs";
import { ROOT } from "./harness.mjs";
import { anyFile } from "./maps.mjs";

const folder = process.env.FLOORPLANS ?? path.join(ROOT, "../shared/maps/floorplans");
const names = fs.existsSync(folder) ? fs.readdirSync(folder).filter((name) => name.endsWith(".png")) : [];

test("cleans real floor plans", { skip: names.length === 0 && "there are none on this machine" }, async (t) => {
  const { app } = await openApp(t, { address: "#room=empty&speed=0" });
  for (const name of names.sort().slice(0, 3)) {
    await app.drop(anyFile(name, fs.readFileSync(path.join(folder, name))));
    assert.equal(await app.message(), "", name);
    const { plan } = await app.metric("Cells visited");
    assert.equal(plan.split(" of ")[0], plan.split(" of ")[1], name);
    // From the start of its run, which may be nearly over by now.
    const to = await app.poll(() => app.numbers(), ({ coverage, time }) => coverage > 5 && time > 600);
    t.diagnostic(`${name}: ${plan} cells, ${to.coverage} % after ${to.time} s`);
  }
});
