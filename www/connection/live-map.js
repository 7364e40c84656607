// @ts-check
// The live map: its canvas, pointers and keys, and what is told of it in words.
import { LiveMap } from "../../workshop.js";
import { byId, changed, fill, select, setAttribute, setHidden, setText, typed } from "../dom.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { fitSize, startHands, startZoom } from "../shared/pan-zoom.js";
import { goesOn, isOpen } from "./view.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */
/** @typedef {import("./types").ConnectionView} ConnectionView */

/** Milliseconds between descriptions in words. */
const PAUSE = 1000;

/** @param {ConnectionTab} it */
export function startMap(it) {
  const canvas = typed("connection-floor", HTMLCanvasElement);
  const choice = select("connection-room");
  const map = new LiveMap(canvas, it.room.mirror, true);
  let wasThere = false;
  /** Where a ride begins that isn't told of yet, and the pose estimated before. @type {[to: number[], from: number[]] | undefined} */
  let awaited;
  const isDue = atMostEvery(PAUSE);

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
    awaited = undefined;
    const room = `${choice.value} ${it.room.version()}`;
    if (room === drawn) {
      map.wipe();
      map.set_planned([]);
    } else map.begin(it.room.mirror, isKnown());
    drawn = room;
    place(view);
  };
  /** Where its estimate begins: where it stands, as far as that is known. @param {ConnectionView} view */
  const place = ({ pose, virtual }) => {
    const [x, y, heading] = (isKnown() && virtual?.pose) || map.start();
    if (heading !== undefined) map.anchor(...pose, x ?? 0, y ?? 0, heading);
  };
  choice.addEventListener("change", () => begin(it.view));
  startLifting(it, canvas, map);
  offer();

  return {
    map,
    begin,
    isKnown,
    /** A ride has begun: from now on its estimate is the room's start. On blank paper it stays where it is drawn. */
    rideFrom() {
      const [fromX, fromY, from] = it.room.mirror.start();
      const [x, y, heading] = map.start();
      awaited = undefined;
      if (fromX !== undefined && fromY !== undefined && from !== undefined) {
        awaited = [[fromX, fromY], [...it.view.pose]];
        if (!isKnown()) map.stay(fromX, fromY, from);
        else if (heading !== undefined) map.anchor(fromX, fromY, from, x ?? 0, y ?? 0, heading);
      }
      map.wipe();
    },
    /** @param {Float64Array} trace Four numbers a reading. */
    follow(trace) {
      let from = 0;
      if (awaited) {
        const [start, before] = awaited;
        const far = (/** @type {number[]} */ of) => Math.hypot((trace[from] ?? 0) - (of[0] ?? 0), (trace[from + 1] ?? 0) - (of[1] ?? 0));
        // What comes before the ride is another way.
        while (from < trace.length && far(before) < far(start)) from += 4;
        if (from < trace.length) awaited = undefined;
      }
      map.follow(trace.subarray(from));
    },
    /** @param {ConnectionView} view */
    update(view) {
      const isThere = view.phase === "connected";
      if (isThere && !wasThere) begin(view);
      wasThere = isThere || (wasThere && isOpen(view));
      const bumps = view.packets[0] ?? 0;
      if (wasThere) map.show_robot(...view.pose, (bumps & 12) === 12, (bumps & 2) !== 0, (bumps & 1) !== 0);
      else if (changed(canvas, "there", false)) map.hide_robot();
      if (wasThere) changed(canvas, "there", true);
      const truth = wasThere && isKnown() ? view.virtual?.pose : undefined;
      if (truth) map.show_truth(...truth);
      setHidden(byId("connection-legend"), !wasThere);
      setHidden(byId("connection-legend-truth"), !truth);
      showNumbers(map, view, wasThere);
      if (isDue()) setAttribute(canvas, "aria-label", words(map, view, wasThere, isKnown() ? it.app.view.room.title : "an unknown room"));
    },
    draw() {
      fitSize(canvas, map);
      map.draw();
    },
    key: startZoom(byId("connection-stage"), map),
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

/** The picture in words. @param {LiveMap} map @param {ConnectionView} view @param {boolean} isThere @param {string} room */
function words(map, { pose, mode, ride }, isThere, room) {
  if (!isThere) return `Live map of ${room}: no robot yet`;
  const share = map.coverage();
  const [bumps, cliffs] = map.felt();
  const [x, y, heading] = pose;
  const degrees = Math.round((heading * 180) / Math.PI);
  const swept = share === undefined ? `${map.swept_m2().toFixed(1)} square metres` : `${(100 * share).toFixed(0)} % of the reachable floor`;
  return `Live map of ${room}: the robot is estimated to be at ${x.toFixed(2)} m, ${y.toFixed(2)} m, heading ${degrees} degrees, in mode ${mode || "unknown"}${ride && goesOn(ride) ? `, driven by ${ride.manual ? "you" : ride.title}` : ""}. It has swept ${swept}, bumped ${bumps} times and seen ${cliffs} cliffs.`;
}

/** A hand can lift the virtual robot from the map. @param {ConnectionTab} it @param {HTMLCanvasElement} canvas @param {LiveMap} map */
function startLifting(it, canvas, map) {
  startHands(canvas, map, {
    pointer(kind, x, y) {
      if (kind === "down") return it.hand.takes(map.is_on_robot(x, y));
      if (kind === "move") return;
      const [to_x, to_y] = map.place_at(x, y);
      if (to_x !== undefined && to_y !== undefined) it.hand.putDown(to_x, to_y);
    },
  });
}
