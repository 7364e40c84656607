// @ts-check
// "Show me": offered beside the sentence that says what the page is, until it was seen once.
import { make } from "../dom.js";

/** @param {import("../main.js").App} app */
export function offerTour(app) {
  if (wasSeen()) return;
  const start = () => {
    button.remove();
    import("./tour.js").then(({ startTour }) => startTour(app)).catch(console.warn);
  };
  const button = make("button", { type: "button", className: "link", onclick: start }, "Show me");
  document.querySelector(".tagline")?.append(" ", button);
}

function wasSeen() {
  try {
    return localStorage.getItem("toured") !== null;
  } catch {
    return true;
  }
}
