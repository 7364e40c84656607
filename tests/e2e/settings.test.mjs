// Whatever the setup offers works, for every algorithm.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApp, values } from "./app.mjs";

test("every robot, cell size and slip can be chosen", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=empty" });
  await app.unfold();
  for (const menu of ["robot", "cell-size", "slip", "noise", "odometry"]) {
    // An own robot is a form, and cells for a coverage are a search: they have tests of their own.
    const others = ["mixed", "own", ...(menu === "cell-size" ? ["95", "98", "99"] : [])];
    for (const value of (await values(page, menu)).filter((value) => !others.includes(value))) {
      assert.ok(["playing", "finished"].includes(await app.choose(menu, value)), `${menu} ${value}`);
      assert.equal(await app.message(), "", `${menu} ${value}`);
      assert.equal(await page.locator(`#${menu}`).inputValue(), value);
    }
  }
  await page.locator("#seed").fill("7");
  await page.keyboard.press("Tab");
  assert.equal(await app.linked("seed"), "7");
  await page.locator("#seed").fill("-1");
  await page.keyboard.press("Tab");
  await app.says(/seed.*-1/);
  assert.equal(await page.locator("#seed").inputValue(), "7", "what holds is shown again");
});

test("every parameter of every algorithm can be changed", async (t) => {
  const { page, app } = await openApp(t, { address: "#room=thesis8&robot=cell" });
  await app.unfold();
  const controls = page.locator("#params, #params-more").locator("select, input[type=checkbox], input[type=number]");
  let changed = 0;
  // The search of lanes takes minutes when all of them are at their ends: lanes.test.mjs.
  for (const planner of (await values(page, "algorithm")).filter((id) => id !== "lanes")) {
    await app.choose("algorithm", planner);
    const found = await controls.all();
    for (const control of found) {
      await control.evaluate((node) => {
        if (node.type === "checkbox") node.checked = !node.checked;
        else if (node.type === "number") node.value = node.value === node.max ? node.min : node.max;
        else node.selectedIndex = (node.selectedIndex + 1) % node.length;
        node.dispatchEvent(new Event("change", { bubbles: true }));
      });
      changed += 1;
      assert.ok(["playing", "finished"].includes(await app.settled()), planner);
      assert.equal(await app.message(), "", planner);
    }
    if (found.length > 0) assert.ok((await app.poll(() => app.link(), (link) => Object.keys(link).some((key) => key.startsWith("p.")))), planner);
  }
  assert.ok(changed >= 2, `${changed} parameters`);
});
