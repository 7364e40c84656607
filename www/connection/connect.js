// @ts-check
// Connecting: what can be connected to, and what is found there, in pictures.
import { VirtualRobot } from "../../workshop.js";
import { button, byId, changed, fill, input, make, select, setAttribute, setHidden, setText } from "../dom.js";
import { kept, keep, readSafety } from "./dialogs.js";
import { support } from "./support.js";
import { isOpen, isReplay, waitedFor } from "./view.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */
/** @typedef {import("./types").ConnectionView} ConnectionView */

/** Which picture belongs to what was found. @type {Record<string, string>} */
const PICTURES = { nothing: "listening", silence: "asleep", stream: "awake", robot: "awake", text: "awake", charging: "dock", booting: "boot", bootloader: "boot", garbage: "speed", no_stream: "awake" };
/** What is being tried, while it is. @type {Record<string, string>} */
const TRYING = { listening: "Listening for a robot…", asking: "Waiting for an answer…", waking: "Waking it through the cable's wake-up wire…", slow: "Trying 19,200 baud…", create1: "Trying 57,600 baud…" };
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

  setHidden(byId("connection-unsupported"), can.why === "");
  setText(byId("connection-unsupported"), `${can.why} ${can.instead}`);
  button("connection-serial").addEventListener("click", async () => {
    if (!can.serial) {
      it.complain(`${can.why} ${can.instead}`);
      return;
    }
    if (await readSafety()) await it.open({ kind: "serial" });
  });
  setAttribute(button("connection-serial"), "aria-disabled", String(!can.serial));
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
    const open = isOpen(view);
    if (changed(byId("connection-welcome"), "open", open)) {
      setHidden(byId("connection-welcome"), open);
      setHidden(byId("connection-need"), open);
      setHidden(byId("connection-line-buttons"), !open);
      // What had the focus is gone.
      if (open !== wasOpen && (document.activeElement === document.body || !document.activeElement?.checkVisibility())) byId(open ? "connection-floor" : "connection-virtual").focus();
      wasOpen = open;
    }
    showState(view, open);
    const isThere = (view.phase === "connected" && view.transport.state !== "lost") || isReplay(view);
    setHidden(byId("connection-diagnosis"), !open || isThere);
    if (open && !isThere) showDiagnosis(view);
    for (const id of ["connection-again", "connection-retry"]) setHidden(button(id), !view.can.connect || isReplay(view));
    setText(button("connection-close"), isReplay(view) ? "Close the recording" : "Disconnect");
  };
}

/** @param {ConnectionView} view @param {boolean} open */
function showState(view, open) {
  const { phase, transport, diagnosis } = view;
  setAttribute(byId("connection-setup"), "data-phase", open ? phase : "closed");
  const names = { closed: "Connecting…", diagnosing: "Connecting…", waiting: waitedFor(diagnosis)[0], connected: transport.name || "Connected", lost: "Connection lost" };
  setText(byId("connection-name"), isReplay(view) ? transport.name : open ? names[phase] : "Not connected");
  const note = isReplay(view) ? "Playback: nothing can be driven." : phase === "connected" ? transport.text || diagnosis.text : transport.text;
  setText(byId("connection-note"), open ? note : "Connect a real robot by cable, or the virtual one.");
}

/** @param {ConnectionView} view */
function showDiagnosis({ phase, diagnosis, transport }) {
  const isLost = phase === "lost" || transport.state === "lost";
  // Who is still trying doesn't send anybody to press buttons.
  const trying = isLost || phase !== "diagnosing" ? "" : (TRYING[diagnosis.step] ?? "Listening for a robot…");
  const picture = isLost ? "unplugged" : trying ? "listening" : (PICTURES[diagnosis.finding] ?? "listening");
  setAttribute(byId("connection-picture"), "href", `#p-${picture}`);
  setText(byId("connection-found"), trying || (isLost ? transport.text : "") || diagnosis.text || "Listening for a robot…");
  setText(byId("connection-remedy"), trying ? "" : diagnosis.remedy);
  if (!changed(byId("connection-tried"), "log", diagnosis.log.join("\n"))) return;
  byId("connection-tried").replaceChildren(...diagnosis.log.map((line) => make("li", {}, line)));
}

