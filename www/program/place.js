// @ts-check
// Room and robot stay choosable while the editor takes the place of the setup: their menus move over, and back.
import { button, byId, make } from "../dom.js";
import { currentTab } from "../tabs.js";

export function startPlace() {
  const fields = ["room", "robot"].map((id) => {
    const field = /** @type {HTMLElement} */ (byId(id).closest(".field"));
    return { field, home: /** @type {HTMLElement} */ (field.parentElement), next: field.nextElementSibling };
  });
  const isHere = () => currentTab() === "program" && document.body.dataset.left !== "setup";
  const move = () => {
    for (const { field, home, next } of fields) {
      if (isHere()) byId("program-place").append(field);
      else home.insertBefore(field, next);
    }
  };
  const back = make("button", { type: "button", id: "setup-back", className: "setup-back" }, "Back to the program");
  byId("setup").querySelector(".sheet-head")?.after(back);
  const turn = (/** @type {string} */ left) => {
    document.body.dataset.left = left;
    move();
  };
  button("program-setup").addEventListener("click", () => {
    turn("setup");
    back.focus();
  });
  back.addEventListener("click", () => {
    turn("");
    byId("program-run").focus();
  });
  document.addEventListener("tab", move);
}
