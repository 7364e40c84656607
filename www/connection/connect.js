// @ts-check
// Connecting: the possible connections, and the diagnosis, in pictures.
import { VirtualRobot } from "../../workshop.js";
import { button, byId, changed, fill, input, make, select, setAttribute, setHidden, setText } from "../dom.js";
import { kept, keep, readSafety } from "./dialogs.js";
import { showPicture } from "./pictures.js";
import { support } from "./support.js";
import { startWiring } from "./wiring.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */
/** @typedef {import("./types").ConnectionView} ConnectionView */

const URL_KEPT = "connection-bridge";

/** @param {ConnectionTab} it @returns {(view: ConnectionView) => void} */
export function startConnect(it) {
  const can = support();
  const personalities = VirtualRobot.personalities();
  const choice = select("connection-personality");
  fill(choice, personalities.map(({ id, title }) => [id, title]));
  const describe = () => setText(byId("connection-personality-note"), personalities.find(({ id }) => id === choice.value)?.summary ?? "");
  choice.addEventListener("change", describe);
  describe();

  startWiring();
  setHidden(byId("connection-unsupported"), can.why === "");
  setText(byId("connection-unsupported"), `${can.why} ${can.instead}`);
  const connect = async (/** @type {"serial" | "usb"} */ kind) => {
    if (!can[kind]) it.complain(`${can.why} ${can.instead}`);
    else if (await readSafety()) await it.open({ kind });
  };
  setHidden(byId("connection-usb"), !can.usb);
  // On Android, serial ports are the few adapters that the system knows.
  setHidden(byId("connection-ports"), !(can.usb && can.serial));
  button("connection-serial").addEventListener("click", () => connect(can.usb ? "usb" : "serial"));
  button("connection-other").addEventListener("click", () => connect("serial"));
  setAttribute(button("connection-serial"), "aria-disabled", String(!can.usb && !can.serial));
  button("connection-virtual").addEventListener("click", () => void it.open({ kind: "virtual", personality: choice.value }));
  input("connection-url").value = kept(URL_KEPT) ?? "";
  byId("connection-socket").addEventListener("submit", async (event) => {
    event.preventDefault();
    const url = input("connection-url").value.trim();
    if (!(await readSafety())) return;
    keep(URL_KEPT, url);
    await it.open({ kind: "socket", url });
  });
  for (const id of ["connection-again", "connection-retry"]) button(id).addEventListener("click", () => void it.request({ do: "connect" }));
  for (const id of ["connection-close", "connection-give-up"]) button(id).addEventListener("click", () => void it.close());

  let wasOpen = false;
  return (view) => {
    const { is_open: open, diagnosis } = view;
    if (changed(byId("connection-welcome"), "open", open)) {
      setHidden(byId("connection-welcome"), open);
      setHidden(byId("connection-need"), open);
      setHidden(byId("connection-line-buttons"), !open);
      // The element with the focus is gone.
      if (open !== wasOpen && (document.activeElement === document.body || !document.activeElement?.checkVisibility())) byId(open ? "connection-floor" : "connection-virtual").focus();
      wasOpen = open;
    }
    setAttribute(byId("connection-setup"), "data-phase", open ? view.phase : "closed");
    setText(byId("connection-name"), view.line.title);
    setText(byId("connection-note"), view.line.note);
    setHidden(byId("connection-diagnosis"), !diagnosis.is_shown);
    if (diagnosis.is_shown) showDiagnosis(diagnosis);
    for (const id of ["connection-again", "connection-retry"]) setHidden(button(id), !view.can.connect);
    setText(button("connection-close"), view.is_recording ? "Close the recording" : "Disconnect");
  };
}

/** Where the explanations of a picture begin, if not at the socket. @type {Record<string, string>} */
const EXPLAINED = { asleep: "transistor", dock: "waking", usb: "usb" };

/** @param {ConnectionView["diagnosis"]} diagnosis */
function showDiagnosis({ picture, caption, log }) {
  if (changed(byId("connection-diagnosis"), "picture", picture)) byId("connection-diagnosis").scrollTop = 0;
  void showPicture(byId("connection-picture"), picture);
  setAttribute(byId("connection-diagnosis-wiring"), "data-wiring", EXPLAINED[picture] ?? "socket");
  setText(byId("connection-found"), caption.title);
  setText(byId("connection-remedy"), caption.note);
  setHidden(byId("connection-remedy"), caption.note === "");
  if (changed(byId("connection-tried"), "log", log.join("\n"))) byId("connection-tried").replaceChildren(...log.map((line) => make("li", {}, line)));
}
