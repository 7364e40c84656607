// @ts-check
// Brushes and vacuum, on, off or with a duty cycle; and wheels by duty cycle.
import { byId, make, setEnabled } from "../dom.js";
import { group, slider, toggles, wishes } from "./switches.js";

/** Bits of opcode 138. @type {[bit: number, name: string, tip: string][]} */
const MOTORS = [[1, "Side brush", "Sweeps dirt from the edge."], [2, "Vacuum", "Loud."], [4, "Main brush", "Keep fingers and hair away."], [8, "Side brush clockwise", "Counter-clockwise otherwise."], [16, "Main brush outward", "Throws dirt out instead of picking it up."]];
/** Largest duty cycles: of brushes and vacuum (opcode 144), of wheels (146). */
const [MOST, MOST_WHEEL] = [127, 255];
/** How often the wheels' duty cycles are said again, ms. They hold for 200 ms. */
const AGAIN_MS = 60;

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: import("./types").ConnectionView) => void} */
export function startMotors(it) {
  const motors = wishes(it, { motors: 0, duty: /** @type {[number, number, number]} */ ([0, 0, 0]) });
  const switches = toggles(MOTORS, (bit) => {
    const { motors: bits } = motors.wish({ motors: motors.now.motors ^ bit });
    void motors.ask({ do: "motors", bits });
  });
  const turn = (/** @type {number} */ which) => (/** @type {number} */ value) => {
    const [main_brush, side_brush, vacuum] = /** @type {[number, number, number]} */ (motors.now.duty.map((old, at) => (at === which ? value : old)));
    motors.wish({ duty: [main_brush, side_brush, vacuum] });
    void motors.ask({ do: "pwm_motors", main_brush, side_brush, vacuum });
  };
  const duties = [slider("Main brush: outward to inward", -MOST, MOST, turn(0)), slider("Side brush: clockwise to counter-clockwise", -MOST, MOST, turn(1)), slider("Vacuum", 0, MOST, turn(2))];
  const wheels = startWheels(it);
  byId("connection-motors").append(
    make("div", { className: "connection-sets" },
      group("Brushes and vacuum", switches.node),
      group("Brush and vacuum power", ...duties.map(({ field }) => field)),
      wheels.node,
    ),
  );

  return ({ can, motors: bits, duty }) => {
    const now = motors.take({ motors: bits, duty });
    switches.show(now.motors, can.drive);
    duties.forEach(({ show }, index) => show(now.duty[index] ?? 0, can.drive));
    wheels.update(can.steer);
  };
}

/** The wheels' power. @param {import("./tab.js").ConnectionTab} it */
function startWheels(it) {
  let wanted = [0, 0];
  const set = (/** @type {number} */ which) => (/** @type {number} */ value) => void (wanted = wanted.map((old, at) => (at === which ? value : old)));
  const sliders = [slider("Left wheel: backward to forward", -MOST_WHEEL, MOST_WHEEL, set(0)), slider("Right wheel: backward to forward", -MOST_WHEEL, MOST_WHEEL, set(1))];
  const hold = make("button", { type: "button", id: "wheels-hold", "data-tip": "Drives while you hold it (or Enter). Obstacles are not checked." }, "Hold to drive");
  let timer = 0;
  const end = () => {
    if (timer === 0) return;
    clearInterval(timer);
    timer = 0;
    if (it.view.can.drive) void it.request({ do: "drive_pwm", right: 0, left: 0 });
  };
  const again = async () => {
    const [left = 0, right = 0] = wanted;
    if (!(await it.request({ do: "drive_pwm", right, left }))) end();
  };
  const begin = () => {
    if (timer !== 0 || !it.view.can.steer) return;
    timer = window.setInterval(again, AGAIN_MS);
    void again();
  };
  it.onhalt.push(end);
  hold.addEventListener("pointerdown", begin);
  for (const event of ["pointerup", "pointercancel", "pointerleave", "blur", "keyup"]) hold.addEventListener(event, end);
  hold.addEventListener("keydown", (event) => event.key === "Enter" && !event.repeat && begin());
  return {
    node: group("Wheel power", ...sliders.map(({ field }) => field), hold),
    /** @param {boolean} can */
    update(can) {
      sliders.forEach(({ show }, index) => show(wanted[index] ?? 0, can));
      setEnabled(hold, can);
      if (!can) end();
    },
  };
}
