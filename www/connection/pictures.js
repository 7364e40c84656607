// @ts-check
// The drawings of robot and cable: files that docs/real-robot.md shows too. They are put into the document rather than shown as
// images, so that they have the page's colours. Each says in its label what it shows.
import { text } from "../parts.js";

/** Written out one by one, as the build gives each address its version. @type {Record<string, URL>} */
const FILES = {
  asleep: new URL("./pictures/asleep.svg", import.meta.url),
  booting: new URL("./pictures/booting.svg", import.meta.url),
  bootloader: new URL("./pictures/bootloader.svg", import.meta.url),
  dock: new URL("./pictures/dock.svg", import.meta.url),
  levels: new URL("./pictures/levels.svg", import.meta.url),
  listening: new URL("./pictures/listening.svg", import.meta.url),
  older: new URL("./pictures/older.svg", import.meta.url),
  socket: new URL("./pictures/socket.svg", import.meta.url),
  speed: new URL("./pictures/speed.svg", import.meta.url),
  transistor: new URL("./pictures/transistor.svg", import.meta.url),
  unheard: new URL("./pictures/unheard.svg", import.meta.url),
  unplugged: new URL("./pictures/unplugged.svg", import.meta.url),
  usb: new URL("./pictures/usb.svg", import.meta.url),
  waking: new URL("./pictures/waking.svg", import.meta.url),
};

/** Shows a drawing. If it can't be loaded, the words beside it have to do. @param {HTMLElement} figure @param {string} name */
export async function showPicture(figure, name) {
  if (figure.dataset.picture === name) return;
  figure.dataset.picture = name;
  const drawing = await text(FILES[name]).catch(() => "");
  // Another one can have been wanted meanwhile.
  if (figure.dataset.picture === name) figure.innerHTML = drawing;
}
