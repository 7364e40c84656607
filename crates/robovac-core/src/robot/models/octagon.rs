//! The octagon that moves in all directions (001).

use crate::robot::{
    RobotModel,
    body::{Battery, Body, Bumper, Corners, SensorSuite, Tool, WheelLayout},
    model::PowerDraw,
};
use core::f64::consts::PI;

/// Half the distance between opposite sides, m.
const HALF: f64 = 0.18;
/// Half the length of a side: tan 22.5° of it.
const SIDE: f64 = HALF * 0.414_213_562_373_095;

/// The octagon.
///
/// Of 001: the shape, that it moves without turning (section 2), and lanes half the robot's width apart (section 3). The
/// paper prints no measure of the robot. Ours are 0.36 m from side to side, a home robot's size; a tool as wide as that,
/// since the paper takes the floor under the robot as swept; a bumper all around, because it may move any way, and four
/// cliff sensors at its front half; and drive, encoders, battery and power as the Roomba's.
pub(super) const OCTAGON: RobotModel = RobotModel {
    id: "octagon",
    title: "Omnidirectional octagon",
    summary: "Eight sides, 36 cm wide, moves in any direction without turning",
    body: Body::Polygon(Corners::of(&[
        [HALF, -SIDE],
        [HALF, SIDE],
        [SIDE, HALF],
        [-SIDE, HALF],
        [-HALF, SIDE],
        [-HALF, -SIDE],
        [-SIDE, -HALF],
        [SIDE, -HALF],
    ])),
    // To a corner: HALF / cos 22.5°.
    radius: HALF * 1.082_392_200_292_394,
    wheels: WheelLayout::Omnidirectional,
    sensors: SensorSuite {
        bumper: Some(Bumper { half_arc: PI, both_within: 0.35, height: 0.0 }),
        cliffs: [Some([0.07, 0.16]), Some([0.17, 0.05]), Some([0.17, -0.05]), Some([0.07, -0.16])],
        light_bumper: None,
        infrared: false,
        wheel_drops: true,
        laser: None,
    },
    castors: &[],
    side_brushes: &[],
    battery: Battery { capacity_mah: 2696.0, voltage: 14.4, charge_ma: 0.0, has_gauge: true },
    tool_width: 2.0 * HALF,
    tool: Tool::CENTRED,
    wheel_base: 0.235,
    counts_per_metre: 508.8 / (PI * 0.072),
    wheel_radius: 0.036,
    max_wheel_speed: 0.5,
    speed_steps: [0.0, 0.0],
    acceleration: 0.8,
    cruise_speed: 0.3,
    turn_wheel_speed: 0.2,
    default_cell: HALF,
    fills_cell: false,
    power: PowerDraw { standing: 21.0, straight: 5.0, turning: 3.3 },
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_corners_lie_on_the_circle_around_it() {
        let Body::Polygon(corners) = OCTAGON.body else { panic!("it is a polygon") };
        assert_eq!(corners.len(), 8);
        for [x, y] in corners.iter() {
            assert!(((x * x + y * y).sqrt() - OCTAGON.radius).abs() < 1e-9);
        }
    }
}
