// @ts-check
// "Show me": offered beside the sentence that says what the page is, until it was seen once.
import { make } from "../dom.js";

/** @param {import("../main.js").App} app */
export function offerTour(app) {
  if (wasSeen()) return;
  const start = (/** @type {Event} */ event) => {
    event.preventDefault();
    for (const button of document.querySelectorAll(".tagline button, #welcome button")) button.remove();
    import("./tour.js").then(({ startTour }) => startTour(app)).catch(console.warn);
  };
  for (const place of document.querySelectorAll(".tagline, #welcome")) {
    const button = make("button", { type: "button", className: "link" }, "Show me");
    // The note over the floor goes with the first press, wherever that is: a click would come too late.
    button.addEventListener("pointerdown", (event) => event.isPrimary && start(event));
    button.addEventListener("click", start);
    place.append(" ", button);
  }
}

function wasSeen() {
  try {
    return localStorage.getItem("toured") !== null;
  } catch {
    return true;
  }
}
