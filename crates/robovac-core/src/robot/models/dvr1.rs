//! DVR-1, the vacuum robot of Khulna University (002).

use crate::robot::{
    RobotModel,
    body::{Battery, Body, Bumper, SensorSuite, SideBrush, Tool, WheelLayout},
    model::PowerDraw,
};
use core::f64::consts::{FRAC_PI_3, TAU};

/// Radius of the wheels, m: r of 002, section IV.A.i.
const WHEEL_RADIUS: f64 = 0.04;
/// Distance from a wheel to the body's centre, m: R there.
const WHEEL_TO_CENTRE: f64 = 0.12;
/// Revolutions of a wheel a second: N there.
const REVOLUTIONS: f64 = 1.2;
/// Radius of the body, m. The paper prints L = 14.5 cm as its diameter, which can't hold wheels 12 cm from the centre.
const BODY_RADIUS: f64 = 0.145;
/// Full speed, m/s: the paper's motors are either on or off.
const SPEED: f64 = TAU * WHEEL_RADIUS * REVOLUTIONS;

/// DVR-1.
///
/// Of 002: a round body; r, R and N above, which give 0.30 m/s and a quarter turn in R / (4 r N) = 0.625 s (equation 2); a
/// bumper of two switches that spans 120 degrees, 2 cm above the floor, and three cliff sensors at the left, front and
/// right (section III,
/// figures 5 and 15); two side brushes; a battery of 6 V and 4.5 Ah that lasts for about an hour and charges in 5 to 6
/// hours (section IV.E), so with 4.5 Ah / 5.5 h. It finds no dock by itself and has no receivers for virtual walls, which
/// are future work there, nor a gauge, nor wheel drop switches; it charges where a person puts it on a dock.
///
/// Ours: encoders, of which it has none (8 counts a turn of the motor before its 70:1 gear, so that dead reckoning has
/// something to go by); where its cliff sensors and side brushes sit, drawn from figure 15's arrangement - the side
/// sensors just outside the wheels' tracks, or a wheel could get over an edge alongside unseen; the contact angle that presses both switches; acceleration. Its lanes are at most L apart, so that they overlap: the strip
/// that it cleans is taken to be L wide.
///
/// Power: 6 V x 4.5 Ah in an hour are 27 W, split as the motors are rated: 5 A for the vacuum, two brushes of 0.5 A, two
/// wheels of 2 A. Turning takes as much as driving, since the wheels turn as fast.
pub(super) const DVR_1: RobotModel = RobotModel {
    id: "dvr1",
    title: "DVR-1",
    summary: "Round, 29 cm wide, two bumper switches, three cliff sensors",
    body: Body::Round,
    radius: BODY_RADIUS,
    wheels: WheelLayout::Differential,
    sensors: SensorSuite {
        bumper: Some(Bumper { half_arc: FRAC_PI_3, both_within: 0.26, height: 0.02 }),
        cliffs: [Some([0.057, 0.1224]), Some([0.135, 0.0]), Some([0.135, 0.0]), Some([0.057, -0.1224])],
        light_bumper: None,
        infrared: false,
        wheel_drops: false,
        laser: None,
    },
    castors: &[],
    side_brushes: &[SideBrush { at: [0.08, 0.09], radius: 0.06 }, SideBrush { at: [0.08, -0.09], radius: 0.06 }],
    battery: Battery { capacity_mah: 4500.0, voltage: 6.0, charge_ma: 4500.0 / 5.5, has_gauge: false },
    tool_width: 0.145,
    tool: Tool::CENTRED,
    wheel_base: 2.0 * WHEEL_TO_CENTRE,
    counts_per_metre: 8.0 * 70.0 / (TAU * WHEEL_RADIUS),
    wheel_radius: WHEEL_RADIUS,
    max_wheel_speed: SPEED,
    speed_steps: [0.0, 0.0],
    acceleration: 0.8,
    cruise_speed: SPEED,
    turn_wheel_speed: SPEED,
    default_cell: 0.1,
    fills_cell: false,
    power: PowerDraw { standing: 16.2, straight: 10.8, turning: 10.8 },
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_takes_as_long_as_the_paper_says() {
        let seconds = 0.25 * TAU / DVR_1.turn_rate();
        assert!((seconds - 0.625).abs() < 1e-9, "{seconds}");
    }

    #[test]
    fn an_hour_of_driving_empties_the_battery() {
        let watt_hours = DVR_1.battery.capacity_mah * DVR_1.battery.voltage / 1000.0;
        assert!((watt_hours / (DVR_1.power.standing + DVR_1.power.straight) - 1.0).abs() < 1e-9);
    }
}
