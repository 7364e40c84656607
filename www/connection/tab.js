// @ts-check
// The tab Robot: a connection to a robot, its displays and its controls.
import { Connection } from "../../workshop.js";
import { button, byId, setAttribute } from "../dom.js";
import { complain, forgive } from "../messages.js";
import { currentTab } from "../tabs.js";
import { startSheets } from "../sheets.js";
import { startCalibrate } from "./calibrate.js";
import { ConnectionClient } from "./client.js";
import { startConnect } from "./connect.js";
import { startConsole } from "./console.js";
import { startControl } from "./control.js";
import { startDrive } from "./drive.js";
import { startLights } from "./lights.js";
import { startLine } from "./line.js";
import { startMap } from "./live-map.js";
import { startMotors } from "./motors.js";
import { startReplay } from "./replay.js";
import { startRide } from "./ride.js";
import { startRoom } from "./room.js";
import { startSchedule } from "./schedule.js";
import { startSensors } from "./sensors.js";
import { startSongs } from "./songs.js";
import { startVirtual } from "./hand.js";

/**
 * @typedef {import("./types").ConnectionView} ConnectionView
 * @typedef {object} ConnectionTab What the modules of this tab share.
 * @property {import("../main.js").App} app
 * @property {ConnectionClient} connection
 * @property {ConnectionView} view The latest view.
 * @property {string} personality Of the virtual robot that was opened last; "" if that was none.
 * @property {((view: ConnectionView) => void)[]} onview Listeners for every view.
 * @property {ReturnType<typeof startRoom>} room
 * @property {ReturnType<typeof startMap>} live
 * @property {ReturnType<typeof startVirtual>} hand
 * @property {(text: string) => void} complain
 * @property {(request: import("./types").Request) => Promise<boolean>} request Says whether it was done.
 * @property {(target: import("./types").Target) => Promise<boolean>} open
 * @property {() => Promise<void>} close
 * @property {() => void} halt What would go on driving is let go.
 * @property {(() => void)[]} onhalt Listeners for that.
 */

/** Time after which a view with the reason of a refusal has certainly arrived, ms. */
const SOON_MS = 150;

/**
 * @param {import("../main.js").App} app
 * @param {WebAssembly.Module} module
 * @param {(what: () => void) => boolean} guard
 */
export function startConnection(app, module, guard) {
  const connection = new ConnectionClient(module);
  const room = startRoom(app);
  room.take();
  const closed = /** @type {ConnectionView} */ ({ ...Connection.closed(), virtual: null });
  // The rest of it follows below: its parts need each other.
  const it = /** @type {ConnectionTab} */ (/** @type {unknown} */ ({ app, connection, view: closed, personality: "", onview: [], onhalt: [], room, complain }));
  /** Unanswered requests, oldest first; the reason of a refusal arrives before the answer. @type {string[]} */
  const asked = [];
  /** Number of the notice that is over. */
  let over = -1;
  /** Whether somebody disconnected the robot: what its line said last goes, too. What stays after a fault helps to find it. */
  let hasLeft = false;
  const settle = () => {
    forgive();
    over = it.view.notice?.number ?? -1;
  };
  it.request = async (request) => {
    asked.push(request.do);
    const worked = await connection.request(request);
    asked.shift();
    if (worked && (request.do === "arm" || request.do === "connect")) settle();
    else if (worked && request.do !== "drive" && request.do !== "drive_pwm") forgive();
    return worked;
  };
  it.open = async (target) => {
    room.take();
    connection.follow(room.followed());
    settle();
    it.personality = target.kind === "virtual" ? target.personality : "";
    hasLeft = false;
    traffic.begin();
    return connection.open(target);
  };
  it.hand = startVirtual(it);
  it.live = startMap(it);
  const drive = startDrive(it);
  const ride = startRide(it);
  it.halt = () => {
    for (const release of [drive.stop, ride.cancel, ...it.onhalt]) release();
  };
  it.close = async () => {
    it.halt();
    if (replay.end()) return traffic.begin();
    await connection.close();
    hasLeft = true;
    traffic.begin();
  };
  const traffic = startConsole(it);
  const updates = [startConnect, startControl, startSensors, startLine, startSongs, startLights, startMotors, startSchedule, startCalibrate].map((begin) => begin(it));
  const closeDrawer = startDrawer();
  startSheets(byId("panel-connection"), byId("connection-floor"));

  let isFresh = true;
  /** The way that leads to where the next view shows the robot. @type {Float64Array} */
  let way = new Float64Array();
  const show = (/** @type {ConnectionView} */ view) => {
    // Once connected in any way, earlier messages are hidden.
    if (view.mode !== it.view.mode && view.mode !== "Passive" && it.view.mode === "Passive" && view.notice?.number === it.view.notice?.number) over = view.notice?.number ?? -1;
    // After Disconnect nothing of the robot stays, but its recording.
    const isOver = view.phase === "closed";
    const isLast = isOver && it.view.phase !== "closed";
    it.view = isOver ? { ...view, virtual: null, ride: null } : view;
    if (isLast) {
      it.live.begin(it.view);
      closeDrawer();
    }
    isFresh = true;
    setAttribute(document.body, "data-robot", view.is_open ? "open" : "");
    guard(() => it.live.update(it.view, isOver ? new Float64Array() : way));
    way = new Float64Array();
  };
  const follow = (/** @type {Float64Array} */ trace) => void (way = trace);
  const replay = startReplay(it, { show, follow, traffic: traffic.take, wipe: () => it.live.begin(it.view), settle, closed: () => show(closed) });
  connection.onview = show;
  connection.ontrace = follow;
  connection.ontraffic = (news) => hasLeft || traffic.take(news);
  connection.onfailed = ({ kind, what, remedy }) => {
    const tell = () => complain(remedy ? `${what} ${remedy}` : what);
    if (kind !== "refused" || asked[0] !== "drive") return tell();
    // Control was lost while a key was held: the next view says why, better than this would.
    setTimeout(() => it.view.can.drive && tell(), SOON_MS);
  };

  show(closed);
  let wasHere = false;
  // Elsewhere nothing stops it: it doesn't drive on.
  new MutationObserver(() => {
    if (currentTab() === "connection") return;
    wasHere = false;
    const { is_moving: moves, moves_alone: movesAlone, motors, is_recording: isRecording } = it.view;
    it.halt();
    if ((moves || movesAlone || (motors & 7) !== 0) && !isRecording) connection.leave("You left the Robot tab.");
  }).observe(byId("panel-connection"), { attributes: true, attributeFilter: ["hidden"] });

  return {
    /** Once a frame while the tab is shown. @param {number} now */
    frame(now) {
      guard(() => replay.frame(now));
      if (!wasHere) {
        wasHere = true;
        // The robot that is connected is in the room that it was in.
        if (!it.view.is_open && room.take()) it.live.begin(it.view);
      }
      it.live.draw();
      traffic.update();
      if (isFresh) {
        isFresh = false;
        for (const update of [...updates, ...it.onview, drive.update, ride.update, it.hand.update]) update(it.view);
      }
      const { notice, drop } = it.view;
      // The message above the map isn't repeated.
      const isNews = notice !== null && notice.number !== over && !(drop && notice.text.includes(drop.text));
      return { message: isNews ? notice.text : "", message_kind: isNews ? notice.kind : "" };
    },
    /** @param {string} key */
    key: (key) => it.live.key(key),
    link: () => "tab=connection",
    restore() {},
    /** @param {boolean} dark */
    setDark: (dark) => void guard(() => it.live.map.set_dark(dark)),
  };
}

/** The tools, below the map. Returns what closes them. */
function startDrawer() {
  const [drawer, opener] = [byId("connection-drawer"), button("connection-tools-open")];
  const show = (/** @type {boolean} */ on) => setAttribute(opener, "aria-expanded", String(drawer.classList.toggle("shown", on)));
  opener.addEventListener("click", () => show(!drawer.classList.contains("shown")));
  const tabs = [...byId("connection-tabs").querySelectorAll("button")];
  for (const tab of tabs) {
    tab.addEventListener("click", () => {
      for (const other of tabs) {
        other.setAttribute("aria-pressed", String(other === tab));
        byId(`connection-${other.dataset.panel}`).hidden = other !== tab;
      }
    });
  }
  return () => show(false);
}
