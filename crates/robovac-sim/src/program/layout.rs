//! What a program senses: numbers at fixed places, with names and units.
//!
//! The list [`SLOTS`] is the interface. The page's runtime reads the numbers from the memory of its simulation;
//! `robovac run` sends them by name. Both get the list as JSON from [`layout_json`].

use robovac_core::robot::{RobotModel, SensorReadings};
use serde::Serialize;

/// One entry of the readings: a number, a flag, or several of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Slot {
    /// Name in programs.
    pub name: &'static str,
    /// Index of its first number.
    pub index: usize,
    /// How many there are; more than 1 for a list.
    pub count: usize,
    /// Whether they are flags: 0 or 1 here, true or false in programs.
    pub flag: bool,
    /// Unit of a number; empty for none.
    pub unit: &'static str,
    /// What it is, in one sentence.
    pub about: &'static str,
}

const fn number(name: &'static str, unit: &'static str, about: &'static str) -> Slot {
    Slot { name, index: 0, count: 1, flag: false, unit, about }
}

const fn flag(name: &'static str, about: &'static str) -> Slot {
    Slot { name, index: 0, count: 1, flag: true, unit: "", about }
}

const fn several(count: usize, slot: Slot) -> Slot {
    Slot { count, ..slot }
}

/// All entries in their order, with their indices.
pub const SLOTS: [Slot; 42] = indexed([
    number("step", "", "Number of steps of 15 ms since the start."),
    number("time", "s", "Time since the start."),
    number("x", "m", "Position by odometry, to the right; the start's is true."),
    number("y", "m", "Position by odometry, up."),
    number("heading", "deg", "Heading by odometry, counter-clockwise from the right, above -180 up to 180."),
    number("distance", "m", "Distance that the wheels have driven since the start; backward counts as negative."),
    number(
        "turned",
        "deg",
        "Angle that the wheels have turned the robot since the start; clockwise counts as negative.",
    ),
    flag("bump_left", "The bumper is pressed on its left half."),
    flag("bump_right", "The bumper is pressed on its right half."),
    flag("wheel_drop_left", "The left wheel hangs down."),
    flag("wheel_drop_right", "The right wheel hangs down."),
    flag("cliff_left", "No floor under the sensor at the left."),
    flag("cliff_front_left", "No floor under the sensor at the front left."),
    flag("cliff_front_right", "No floor under the sensor at the front right."),
    flag("cliff_right", "No floor under the sensor at the right."),
    number("cliff_left_signal", "", "Signal of the cliff sensor at the left, 0 to 4095."),
    number("cliff_front_left_signal", "", "Signal of the cliff sensor at the front left, 0 to 4095."),
    number("cliff_front_right_signal", "", "Signal of the cliff sensor at the front right, 0 to 4095."),
    number("cliff_right_signal", "", "Signal of the cliff sensor at the right, 0 to 4095."),
    flag("wall", "The wall sensor on the right detects something."),
    number("wall_signal", "", "Signal of the wall sensor, 0 to 1023."),
    flag("virtual_wall", "The beam of a virtual wall is detected."),
    several(6, flag("light_bumper", "Detections of the light bumper, from left to right.")),
    several(6, number("light", "", "Signals of the light bumper, from left to right, 0 to 4095.")),
    number("dirt", "", "Amount of dirt being picked up, 0 to 255."),
    number("infrared_omni", "", "Infrared character received all around; 0 for none."),
    number("infrared_left", "", "Infrared character received at the front left; 0 for none."),
    number("infrared_right", "", "Infrared character received at the front right; 0 for none."),
    number("charge", "", "Charge of the battery as a share of its capacity, 0 to 1."),
    flag("docked", "The robot stands on its dock and is charged."),
    number("voltage", "V", "Voltage of the battery."),
    number("current", "A", "Current of the battery; negative while it discharges."),
    number("left_counts", "", "Encoder of the left wheel; wraps at 65536."),
    number("right_counts", "", "Encoder of the right wheel; wraps at 65536."),
    flag("stasis", "The castor turns: the robot makes progress."),
    flag("overcurrent_left", "The motor of the left wheel draws too much current."),
    flag("overcurrent_right", "The motor of the right wheel draws too much current."),
    flag("overcurrent_brush", "The motor of the main brush draws too much current."),
    flag("overcurrent_side_brush", "The motor of the side brush draws too much current."),
    number("left_speed", "m/s", "Speed that the left wheel was last commanded."),
    number("right_speed", "m/s", "Speed that the right wheel was last commanded."),
    number("laser_scan", "", "Number of the latest scan of the laser, from 1; 0 before the first and without a laser."),
]);

/// Numbers before the ranges of the laser, which follow: metres, counter-clockwise from the first beam, infinite where
/// nothing is in range.
pub const LASER: usize = SLOTS[SLOTS.len() - 1].index + 1;

const fn indexed<const N: usize>(mut slots: [Slot; N]) -> [Slot; N] {
    let (mut slot, mut index) = (0, 0);
    while slot < N {
        slots[slot].index = index;
        index += slots[slot].count;
        slot += 1;
    }
    slots
}

/// Facts about a robot that its program knows. SI units, angles in degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RobotFacts {
    /// Name of the model.
    pub name: &'static str,
    /// Radius of the smallest circle around the body, m.
    pub radius: f64,
    /// Distance between the wheels, m.
    pub wheel_base: f64,
    /// Highest speed of a wheel, m/s, in whole millimetres.
    pub top_speed: f64,
    /// Width of the strip of floor that one pass cleans, m.
    pub tool_width: f64,
    /// Encoder counts per metre of wheel travel.
    pub counts_per_metre: f64,
    /// The laser scanner, if there is one.
    pub laser: Option<LaserFacts>,
}

/// Facts about a laser scanner. Angles are counter-clockwise from straight ahead, degrees.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LaserFacts {
    /// Number of beams.
    pub beams: usize,
    /// Direction of the first one.
    pub first: f64,
    /// Angle from one to the next.
    pub step: f64,
    /// Farthest distance that it measures, m.
    pub range: f64,
}

impl RobotFacts {
    /// Those of `robot`.
    pub fn of(robot: &RobotModel) -> Self {
        Self {
            name: robot.title,
            radius: robot.radius,
            wheel_base: robot.wheel_base,
            top_speed: f64::from(top_speed_mm_s(robot)) / 1000.0,
            tool_width: robot.tool_width,
            counts_per_metre: robot.counts_per_metre,
            laser: robot.sensors.laser.map(|laser| LaserFacts {
                beams: laser.beams,
                first: laser.first.to_degrees(),
                step: laser.step.to_degrees(),
                range: laser.range[1],
            }),
        }
    }

    /// As JSON.
    pub fn to_json(&self) -> String {
        // Strings, numbers and lists can always be serialised.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// Highest speed of the robot's wheels, whole mm/s.
pub fn top_speed_mm_s(robot: &RobotModel) -> i16 {
    (robot.max_wheel_speed * 1000.0 + 1e-6).floor() as i16
}

/// The command for wheel speeds in mm/s: whole, within the top speed; 0 for what isn't a number.
pub fn wheel_command(robot: &RobotModel, wanted_mm_s: f64) -> i16 {
    let most = f64::from(top_speed_mm_s(robot));
    // A cast of NaN gives 0.
    wanted_mm_s.round().clamp(-most, most) as i16
}

/// [`SLOTS`] and [`LASER`] as JSON: `{"slots": [{"name", "index", "count", "flag", "unit", "about"}, ...], "laser": 52}`.
pub fn layout_json() -> String {
    #[derive(Serialize)]
    struct Layout {
        slots: Vec<Slot>,
        laser: usize,
    }
    serde_json::to_string(&Layout { slots: SLOTS.to_vec(), laser: LASER }).unwrap_or_default()
}

/// What programs are told of a robot besides its sensors.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reckoned {
    /// Steps since the start.
    pub steps: u64,
    /// x, y (m) and heading (rad) by odometry.
    pub pose: [f64; 3],
    /// Distance (m) and angle (rad) of the wheels since the start.
    pub driven: [f64; 2],
    /// Last command, left and right, m/s.
    pub command: [f64; 2],
    /// Number of the latest scan.
    pub scan: u32,
}

/// Writes the readings; `numbers` has [`LASER`] places and those of the laser's beams.
pub fn write_readings(numbers: &mut [f64], sensed: &SensorReadings, reckoned: &Reckoned) {
    let on = |flag: bool| f64::from(u8::from(flag));
    let Reckoned { steps, pose: [x, y, heading], driven: [distance, turned], command, scan } = *reckoned;
    let (infrared, over, battery) = (sensed.infrared, sensed.overcurrent, &sensed.battery);
    let mut at = numbers.iter_mut();
    let mut put = |values: &[f64]| {
        for (&value, place) in values.iter().zip(at.by_ref()) {
            *place = value;
        }
    };
    put(&[steps as f64, steps as f64 * crate::STEP_S]);
    put(&[x, y, heading.to_degrees(), distance, turned.to_degrees()]);
    put(&[sensed.bump_left, sensed.bump_right, sensed.wheel_drop_left, sensed.wheel_drop_right].map(on));
    put(&sensed.cliff.map(on));
    put(&sensed.cliff_signal.map(f64::from));
    put(&[on(sensed.wall), sensed.wall_signal.into(), on(sensed.virtual_wall)]);
    put(&sensed.light_bumper.map(on));
    put(&sensed.light_signal.map(f64::from));
    put(&[sensed.dirt, infrared.omni, infrared.left, infrared.right].map(f64::from));
    put(&[battery.share(), on(battery.on_dock)]);
    put(&[f64::from(battery.voltage_mv) / 1000.0, f64::from(battery.current_ma) / 1000.0]);
    put(&[sensed.left_counts, sensed.right_counts].map(f64::from));
    put(&[sensed.stasis, over.left_wheel, over.right_wheel, over.main_brush, over.side_brush].map(on));
    put(&command);
    put(&[scan.into()]);
}

/// Readings as an object with their names, one line of JSON; the laser's ranges only `with_laser`, `null` where nothing is in
/// range.
pub fn readings_json(numbers: &[f64], with_laser: bool) -> String {
    let mut text = String::with_capacity(1200);
    text.push('{');
    let mut push = |name: &str, values: &[f64], is_list: bool, is_flag: bool| {
        if text.len() > 1 {
            text.push(',');
        }
        text.extend(["\"", name, "\":"]);
        text.push_str(if is_list { "[" } else { "" });
        for (index, &value) in values.iter().enumerate() {
            text.push_str(if index > 0 { "," } else { "" });
            push_value(&mut text, value, is_flag);
        }
        text.push_str(if is_list { "]" } else { "" });
    };
    for slot in &SLOTS {
        let values = numbers.get(slot.index..slot.index + slot.count).unwrap_or_default();
        push(slot.name, values, slot.count > 1, slot.flag);
    }
    if with_laser {
        push("laser", numbers.get(LASER..).unwrap_or_default(), true, false);
    }
    text.push('}');
    text
}

fn push_value(text: &mut String, value: f64, is_flag: bool) {
    use std::fmt::Write;
    let written = match value {
        _ if is_flag => write!(text, "{}", value != 0.0),
        _ if !value.is_finite() => write!(text, "null"),
        // The shortest digits that give the same number back.
        _ => write!(text, "{value}"),
    };
    // A string takes all.
    let _ = written;
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::{Infrared, model};

    #[test]
    fn every_reading_is_written_where_its_name_says() {
        assert_eq!((SLOTS[22].name, SLOTS[22].index, SLOTS[23].index), ("light_bumper", 22, 28));
        assert_eq!(LASER, SLOTS.iter().map(|slot| slot.count).sum::<usize>());
        assert!((1..SLOTS.len()).all(|i| SLOTS[..i].iter().all(|slot| slot.name != SLOTS[i].name)));
        let mut numbers = vec![f64::NAN; LASER];
        let sensed = SensorReadings {
            bump_right: true,
            cliff: [false, false, false, true],
            light_signal: [1, 2, 3, 4, 5, 6],
            infrared: Infrared { omni: 0, left: 244, right: 248 },
            stasis: true,
            right_counts: 65_535,
            ..SensorReadings::default()
        };
        let reckoned = Reckoned { steps: 200, command: [0.1, -0.2], scan: 7, ..Reckoned::default() };
        write_readings(&mut numbers, &sensed, &reckoned);
        let at = |name: &str| numbers[SLOTS.iter().find(|slot| slot.name == name).unwrap().index];
        assert_eq!((at("step"), at("time"), at("bump_left"), at("bump_right")), (200.0, 3.0, 0.0, 1.0));
        assert_eq!((at("cliff_right"), at("light"), at("infrared_right")), (1.0, 1.0, 248.0));
        assert_eq!((at("stasis"), at("right_counts"), at("right_speed"), at("laser_scan")), (1.0, 65_535.0, -0.2, 7.0));
        assert_eq!(at("charge"), 1.0, "a robot without a gauge has a full battery");
        assert!(numbers.iter().all(|number| !number.is_nan()), "{numbers:?}");
    }

    #[test]
    fn commands_are_whole_and_within_the_robots_speed() {
        let robot = model("roomba600").unwrap();
        for (wanted, expected) in
            [(299.5, 300), (-299.5, -300), (0.4, 0), (1e9, 500), (f64::NEG_INFINITY, -500), (f64::NAN, 0)]
        {
            assert_eq!(wheel_command(robot, wanted), expected, "{wanted}");
        }
    }
}
