// @ts-check
// The dialog Cable and wiring, whose text and drawings are loaded when it is first opened.
import { byId, typed } from "../dom.js";
import { text } from "../parts.js";
import { showPicture } from "./pictures.js";

export function startWiring() {
  for (const button of byId("panel-connection").querySelectorAll("button[data-wiring]")) {
    button.addEventListener("click", () => void open(button.getAttribute("data-wiring") ?? ""));
  }
}

/** @param {string} section where it begins */
async function open(section) {
  const [dialog, into] = [typed("connection-wiring", HTMLDialogElement), byId("connection-wiring-text")];
  dialog.showModal();
  if (!into.querySelector("section")) {
    try {
      into.innerHTML = await text(new URL("./wiring.html", import.meta.url));
    } catch (error) {
      into.textContent = `This could not be loaded: ${/** @type {Error} */ (error).message}. Check the network, then open it again.`;
      return;
    }
  }
  const figures = [...into.querySelectorAll("figure")];
  await Promise.all(figures.map((figure) => showPicture(figure, figure.dataset.drawing ?? "")));
  byId(`wiring-${section}`).scrollIntoView();
}
