// @ts-check
// The line's traffic, decoded and as bytes; and sending raw bytes.
import { typed_bytes } from "../../workshop.js";
import { button, byId, fill, input, make, select, setAttribute, setEnabled, setText } from "../dom.js";
import { count } from "../format.js";
import { download } from "../files.js";
import { ask } from "./dialogs.js";

/** @typedef {import("./types").Traffic} Traffic */

/** Lines that are shown, and kept for the log. */
const [SHOWN, KEPT] = [300, 20_000];
/** @type {[kind: string, name: string][]} */
const KINDS = [["", "Everything"], ["talk", "All but readings"], ["sent", "Commands"], ["frame", "Readings"], ["refused", "Rejected readings"], ["held", "Unconfirmed readings"], ["text", "Robot's own text"], ["bytes", "Other bytes"], ["line", "Connection"]];
/** Prefix of each kind of line, in addition to its colour. */
const SIGNS = { sent: "→", frame: "←", refused: "✗", held: "?", text: "“", bytes: "·", line: "–" };

/** @param {import("./tab.js").ConnectionTab} it */
export function startConsole(it) {
  const list = byId("console-lines");
  const kinds = select("console-kind");
  const find = input("console-find");
  fill(kinds, KINDS);
  /** @type {Traffic[]} */
  let log = [];
  /** When the connection began, s: the line's clock is older. @type {number | undefined} */
  let began;
  /** Traffic received while paused. */
  let isPaused = false;
  let isStale = true;
  /** The last line, if a repeated reading continues in it. @type {{ traffic: Traffic, node: HTMLElement } | undefined}
   */
  let last;

  const isWanted = (/** @type {Traffic} */ { kind, text, hex }) => {
    const isKind = kinds.value === "" || kinds.value === kind || (kinds.value === "talk" && kind !== "frame");
    const wanted = find.value.trim().toLowerCase();
    return isKind && (wanted === "" || text.toLowerCase().includes(wanted) || hex.toLowerCase().includes(wanted));
  };
  const line = (/** @type {Traffic} */ traffic) => {
    const node = make("li", { className: `line-${traffic.kind}` }, make("time", {}), make("i", {}, SIGNS[traffic.kind]), make("span", {}), make("code", {}));
    write(node, traffic);
    return node;
  };
  const write = (/** @type {HTMLElement} */ node, /** @type {Traffic} */ { time_s, text, hex, times }) => {
    const [time, , words, bytes] = node.children;
    if (time) setText(time, (time_s - (began ?? 0)).toFixed(2));
    if (words) setText(words, times > 1 ? `${text} (${count(times)} times)` : text);
    if (bytes) setText(bytes, hex);
  };
  const isAtEnd = () => list.scrollHeight - list.scrollTop - list.clientHeight < 24;
  const show = () => {
    const wanted = log.filter(isWanted).slice(-SHOWN);
    list.replaceChildren(...wanted.map(line));
    list.scrollTop = list.scrollHeight;
    last = undefined;
    isStale = false;
  };
  for (const node of [kinds, find]) node.addEventListener("input", () => (isStale = true));
  button("console-pause").addEventListener("click", () => {
    isPaused = !isPaused;
    setAttribute(button("console-pause"), "aria-pressed", String(isPaused));
    setText(button("console-pause"), isPaused ? "Resume" : "Pause");
    isStale ||= !isPaused;
  });
  button("console-save").addEventListener("click", () => {
    const lines = log.map(({ time_s, kind, hex, text, times }) => `${(time_s - (began ?? 0)).toFixed(3)}\t${kind}\t${hex}\t${text}${times > 1 ? `\t${times} times` : ""}`);
    download("robot-console.txt", `${lines.join("\n")}\n`, "text/plain");
  });
  startRaw(it);

  /** Lines that aren't shown yet. @type {Traffic[]} */
  let fresh = [];
  const wipe = () => {
    log = [];
    fresh = [];
    isStale = true;
    list.replaceChildren();
  };
  button("console-clear").addEventListener("click", wipe);
  return {
    /** For another connection. */
    begin() {
      wipe();
      began = undefined;
    },
    /** @param {Traffic[]} traffic */
    take(traffic) {
      for (const one of traffic) {
        began ??= one.time_s;
        const before = log.at(-1);
        // Readings follow each other 64 times a second.
        if (one.kind === "frame" && before?.kind === "frame") {
          Object.assign(before, { ...one, times: before.times + one.times });
          if (last?.traffic !== before && fresh.at(-1) !== before && !isPaused) isStale ||= isWanted(before);
        } else {
          log.push({ ...one });
          fresh.push(/** @type {Traffic} */ (log.at(-1)));
        }
      }
      if (log.length > KEPT) log = log.slice(-KEPT / 2);
      if (fresh.length > SHOWN) fresh = fresh.slice(-SHOWN);
    },
    update() {
      if (!list.checkVisibility({ visibilityProperty: true }) || isPaused) return;
      if (isStale) {
        fresh = [];
        show();
        return;
      }
      if (last) write(last.node, last.traffic);
      const wanted = fresh.filter(isWanted);
      fresh = [];
      if (wanted.length === 0) return;
      const follows = isAtEnd();
      for (const traffic of wanted) {
        const node = line(traffic);
        list.append(node);
        last = { traffic, node };
      }
      while (list.children.length > SHOWN) list.firstElementChild?.remove();
      if (follows) list.scrollTop = list.scrollHeight;
    },
  };
}

/** @param {import("./tab.js").ConnectionTab} it */
function startRaw(it) {
  const [field, send, told] = [input("console-bytes"), button("console-send"), byId("console-parsed")];
  const read = () => {
    const typed = typed_bytes(field.value);
    setAttribute(field, "aria-invalid", String(typed.is_refused));
    told.classList.toggle("fault", typed.is_refused);
    setText(told, typed.told);
    return typed;
  };
  field.addEventListener("input", read);
  byId("console-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    const { bytes, moving } = read();
    if (bytes.length === 0) return;
    const agreed = moving.length === 0 || (await ask({
      title: "This may move the robot",
      points: [`It contains ${moving.join(", ")}.`, "Obstacles are not checked: it continues until you press Stop, or leave or hide this page.", "Make sure that there is room around the robot."],
      yes: "Send it",
      isWarning: true,
    }));
    if (agreed && (await it.request({ do: "raw", bytes }))) field.select();
  });
  it.onview.push(({ can }) => setEnabled(send, can.press));
}
