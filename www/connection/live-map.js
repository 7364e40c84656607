// @ts-check
// The live map: its canvas, pointers and keys, and what is told of it in words.
import { LiveMap } from "../../workshop.js";
import { byId, changed, fill, select, setAttribute, setHidden, setText, typed } from "../dom.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */
/** @typedef {import("./types").ConnectionView} ConnectionView */

const KEY_PAN = 60;
const WHEEL_LINE = 16;
/** Milliseconds between descriptions in words. */
const TOLD_EVERY = 1000;

/** @param {ConnectionTab} it */
export function startMap(it) {
  const canvas = typed("connection-floor", HTMLCanvasElement);
  const choice = select("connection-room");
  const map = new LiveMap(canvas, it.room.mirror, true);
  let wasThere = false;
  let told = 0;
  let size = "";

  const isKnown = () => choice.value === "known";
  const offer = () => {
    const value = choice.value || "known";
    fill(choice, [["known", `${it.app.playground.view().room.title} (from Explore)`], ["blank", "Unknown room"]]);
    choice.value = value;
    setText(byId("connection-room-note"), isKnown() ? it.room.mirror.complaint() || "Change it in Explore." : "The map grows as the robot drives.");
  };
  /** What the map shows of rooms, to tell when that is another one. */
  let drawn = "";
  /** Begins anew where the robot stands now. @param {ConnectionView} view */
  const begin = (view) => {
    offer();
    const room = `${choice.value} ${it.room.version()}`;
    if (room === drawn) {
      map.wipe();
      map.set_planned([]);
    } else map.begin(it.room.mirror, isKnown());
    drawn = room;
    map.place(...view.pose, Float64Array.from(view.virtual?.pose ?? []));
  };
  choice.addEventListener("change", () => begin(it.view));
  startHands(it, canvas, map);
  offer();

  return {
    map,
    begin,
    isKnown,
    /** @param {ConnectionView} view @param {Float64Array} way That leads there, four numbers a reading. */
    update(view, way) {
      const isThere = view.phase === "connected";
      if (isThere && !wasThere) begin(view);
      wasThere = isThere || (wasThere && view.is_open);
      map.follow(way);
      const { is_lifted: isLifted, bumper } = view.readings?.sensors ?? { is_lifted: false, bumper: [false, false] };
      if (wasThere) map.show_robot(...view.pose, isLifted, bumper[0] === true, bumper[1] === true);
      else if (changed(canvas, "there", false)) map.hide_robot();
      if (wasThere) changed(canvas, "there", true);
      const truth = wasThere && isKnown() ? view.virtual?.pose : undefined;
      if (truth) map.show_truth(...truth);
      setHidden(byId("connection-legend"), !wasThere);
      setHidden(byId("connection-legend-truth"), !truth);
      showNumbers(map, view, wasThere);
      const now = performance.now();
      if (now - told > TOLD_EVERY) {
        told = now;
        const { ride, mode } = view;
        setAttribute(canvas, "aria-label", map.words(isKnown() ? it.app.view.room.title : "an unknown room", mode, !ride || ride.done ? "" : ride.manual ? "you" : ride.title));
      }
    },
    draw() {
      const { clientWidth: width, clientHeight: height } = canvas;
      const now = `${width} ${height} ${devicePixelRatio}`;
      if (now !== size && width > 0 && height > 0) {
        size = now;
        map.resize(width, height, devicePixelRatio);
      }
      map.draw();
    },
    /** @param {string} key */
    key(key) {
      const [x, y] = [canvas.clientWidth / 2, canvas.clientHeight / 2];
      if (key === "+" || key === "=") map.zoom(x, y, 1.25);
      else if (key === "-") map.zoom(x, y, 0.8);
      else if (key === "0") map.fit();
      else return false;
      return true;
    },
  };
}

/** @param {LiveMap} map @param {ConnectionView} view @param {boolean} isThere */
function showNumbers(map, view, isThere) {
  const share = map.coverage();
  setText(byId("connection-swept"), !isThere ? "–" : share === undefined ? map.swept_m2().toFixed(1) : (100 * share).toFixed(1));
  setText(byId("connection-swept-unit"), share === undefined ? "m²" : "%");
  setText(byId("connection-time"), view.ride ? lasted(Math.floor(view.ride.time_s)) : "–");
  setText(byId("connection-distance"), isThere ? view.distance_m.toFixed(1) : "–");
}

/** @param {number} seconds */
function lasted(seconds) {
  const [h, m, s] = [Math.floor(seconds / 3600), Math.floor(seconds / 60) % 60, seconds % 60];
  return h > 0 ? `${h} h ${m} min` : m > 0 ? `${m} min ${s} s` : `${s} s`;
}

/** Wheel, pinch, drag and keys. @param {ConnectionTab} it @param {HTMLCanvasElement} canvas @param {LiveMap} map */
function startHands(it, canvas, map) {
  /** @type {Map<number, { x: number, y: number }>} */
  const down = new Map();
  let carries = false;
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 1 : WHEEL_LINE);
    map.zoom(event.offsetX, event.offsetY, Math.exp(-Math.max(-120, Math.min(120, pixels)) * (event.ctrlKey ? 0.01 : 0.0016)));
  }, { passive: false });
  canvas.addEventListener("dblclick", () => map.fit());
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    carries = down.size === 1 && it.hand.takes(map.is_on_robot(event.offsetX, event.offsetY));
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const at = { x: event.offsetX, y: event.offsetY };
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      const far = (/** @type {{ x: number, y: number }} */ spot) => Math.max(1, Math.hypot(spot.x - other.x, spot.y - other.y));
      map.zoom((at.x + other.x) / 2, (at.y + other.y) / 2, far(at) / far(before));
    } else if (!carries) map.pan(at.x - before.x, at.y - before.y);
    down.set(event.pointerId, at);
  });
  for (const kind of /** @type {const} */ (["pointerup", "pointercancel"])) {
    canvas.addEventListener(kind, (event) => {
      if (!down.delete(event.pointerId) || !carries) return;
      carries = false;
      const [x, y] = map.place_at(event.offsetX, event.offsetY);
      if (x !== undefined && y !== undefined) it.hand.putDown(x, y);
    });
  }
  canvas.addEventListener("keydown", (event) => {
    const pan = { ArrowLeft: [KEY_PAN, 0], ArrowRight: [-KEY_PAN, 0], ArrowUp: [0, KEY_PAN], ArrowDown: [0, -KEY_PAN] }[event.key];
    if (!pan || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    map.pan(pan[0] ?? 0, pan[1] ?? 0);
  });
  for (const node of byId("connection-stage").querySelectorAll("[data-zoom]")) {
    const how = node.getAttribute("data-zoom");
    node.addEventListener("click", () => (how === "fit" ? map.fit() : map.zoom(canvas.clientWidth / 2, canvas.clientHeight / 2, how === "in" ? 1.4 : 1 / 1.4)));
  }
}
