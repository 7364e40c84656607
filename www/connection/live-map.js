// @ts-check
// The live map: its canvas, pointers and keys, and its description.
import { LiveMap } from "../../workshop.js";
import { byId, changed, fill, select, setAttribute, setHidden, setText, typed } from "../dom.js";
import { clock } from "../format.js";
import { joystickCorner, lowerEnd } from "../shared/corner.js";
import { atMostEvery } from "../shared/frame-pacer.js";
import { fitSize, startHands, startZoom } from "../shared/pan-zoom.js";

/** @typedef {import("./tab.js").ConnectionTab} ConnectionTab */
/** @typedef {import("./types").ConnectionView} ConnectionView */

/** Milliseconds between descriptions in words. */
const PAUSE = 1000;

/** @param {ConnectionTab} it */
export function startMap(it) {
  const canvas = typed("connection-floor", HTMLCanvasElement);
  const stage = byId("connection-stage");
  const zoom = stage.querySelector(".zoom");
  const choice = select("connection-room");
  const map = new LiveMap(canvas, it.room.mirror, true);
  let wasThere = false;
  const isDue = atMostEvery(PAUSE);

  const isKnown = () => choice.value === "known";
  const offer = () => {
    const value = choice.value || "known";
    fill(choice, [["known", `${it.app.playground.view().room.title} (from Explore)`], ["blank", "Unknown room"]]);
    choice.value = value;
    setText(byId("connection-room-note"), isKnown() ? it.room.mirror.complaint() || "Change it in Explore." : "The map grows as the robot drives.");
  };
  /** The room of the map, to detect changes. */
  let drawn = "";
  /** Starts again at the robot's present pose. @param {ConnectionView} view */
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
  startLifting(it, canvas, map);
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
      // Readings that come after the end would bring the robot back.
      if (wasThere) map.follow(way);
      const { is_lifted: isLifted, bumper } = view.readings?.sensors ?? { is_lifted: false, bumper: [false, false] };
      const isNews = changed(canvas, "there", wasThere);
      if (wasThere) map.show_robot(...view.pose, isLifted, bumper[0] === true, bumper[1] === true);
      else if (isNews) map.hide_robot();
      const truth = wasThere && isKnown() ? view.virtual?.pose : undefined;
      if (truth) map.show_truth(...truth);
      setHidden(byId("connection-legend"), !wasThere);
      setHidden(byId("connection-legend-truth"), !truth);
      showNumbers(map, view, wasThere);
      // After the end there may be no other update.
      if (!isDue() && !isNews) return;
      const { ride, mode } = view;
      setAttribute(canvas, "aria-label", map.words(isKnown() ? it.app.view.room.title : "an unknown room", mode, !ride || ride.done ? "" : ride.manual ? "you" : ride.title));
    },
    draw() {
      fitSize(canvas, map);
      const corner = joystickCorner(stage, "connection-") ?? [0, 0];
      const told = Math.max(...["message", "connection-drop", "connection-stop"].map((id) => lowerEnd(byId(id), stage)));
      // Beside a lesson in a small window nothing floats over its lower end.
      const foot = zoom?.checkVisibility() ? undefined : 0;
      if (changed(canvas, "clear", [told, foot, ...corner].join())) map.keep_clear(told, foot, ...corner);
      map.draw();
    },
    key: startZoom(stage, map),
  };
}

/** @param {LiveMap} map @param {ConnectionView} view @param {boolean} isThere */
function showNumbers(map, view, isThere) {
  const share = map.coverage();
  setText(byId("connection-swept"), !isThere ? "–" : share === undefined ? map.swept_m2().toFixed(1) : (100 * share).toFixed(1));
  setText(byId("connection-swept-unit"), share === undefined ? "m²" : "%");
  setText(byId("connection-time"), view.ride ? clock(Math.floor(view.ride.time_s)) : "–");
  setText(byId("connection-time-unit"), !view.ride ? "" : view.ride.time_s < 3600 ? "min" : "h");
  setText(byId("connection-distance"), isThere ? view.distance_m.toFixed(1) : "–");
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
