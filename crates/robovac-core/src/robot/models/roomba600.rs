//! iRobot Roomba 600 and Create 2.

use crate::robot::{
    LightLaw, RobotModel,
    body::{Battery, Body, Bumper, LightBumper, SensorSuite, SideBrush, Tool, WheelLayout},
    model::PowerDraw,
};

/// iRobot Roomba 600 and Create 2.
///
/// Wheel base 235 mm, wheel diameter 72 mm, 508.8 counts a revolution and at most 500 mm/s are of the Create 2 Open
/// Interface specification; the bumper's diameter of 348.5 mm is of its dimension drawing. The width of the brush,
/// about 170 mm, was measured by owners (it isn't in the specification; the side brush isn't counted). Acceleration and
/// the two speeds for following paths are ours: 300 mm/s is about the speed of the robot's own programs, and 0.8 m/s² is
/// less than half of the only published acceleration (1.8 m/s², of the emulator), so that braking distances are safe.
///
/// Power: 14.4 V x 3 Ah last for up to 100 minutes of cleaning, which is 26 W, and about 500 mA, 7 W, are drawn while
/// driving with the cleaning motors off (Kurt, Hacking Roomba, 2006, chapters 1 and 15; of the 400 series, which has the
/// same battery). Standing still, owners read -111 to -151 mA from packet 23: 2 W. So wheels take 5 W and brushes and
/// vacuum 19 W. For turning, wheel power is taken to be proportional to wheel speed, which is an estimate.
pub(super) const ROOMBA_600: RobotModel = RobotModel {
    id: "roomba600",
    title: "Roomba 600 / Create 2",
    summary: "Round, 35 cm wide, 17 cm brush, light bumper, cliff sensors",
    body: Body::Round,
    radius: 0.174_25,
    wheels: WheelLayout::Differential,
    sensors: SensorSuite {
        bumper: Some(Bumper { half_arc: 1.553, both_within: 0.35, height: 0.0 }),
        cliffs: [Some([0.063, 0.148]), Some([0.154, 0.042]), Some([0.154, -0.042]), Some([0.063, -0.148])],
        light_bumper: Some(LightBumper {
            angles: [1.169, 0.559, 0.21, -0.21, -0.559, -1.169],
            range: 0.2,
            law: LightLaw::CREATE_3,
        }),
        infrared: true,
        wheel_drops: true,
        laser: None,
    },
    castors: &[],
    side_brushes: &[SideBrush { at: [0.092, -0.116], radius: 0.095 }],
    battery: Battery { capacity_mah: 2696.0, voltage: 14.4, charge_ma: 1232.0, has_gauge: true },
    tool_width: 0.17,
    tool: Tool::CENTRED,
    wheel_base: 0.235,
    counts_per_metre: 508.8 / (core::f64::consts::PI * 0.072),
    wheel_radius: 0.036,
    max_wheel_speed: 0.5,
    speed_steps: [0.011, 0.0285],
    acceleration: 0.8,
    cruise_speed: 0.3,
    turn_wheel_speed: 0.2,
    // Lanes overlap by 5 cm, the distance by which walls off the lattice can move them.
    default_cell: 0.12,
    fills_cell: false,
    power: PowerDraw { standing: 21.0, straight: 5.0, turning: 3.3 },
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_match_the_specification() {
        // Open Interface: 0.444565 mm a count, 1660.7 counts per wheel for a full spin.
        assert!((1000.0 / ROOMBA_600.counts_per_metre - 0.444_565).abs() < 1e-6);
        let spin = core::f64::consts::PI * ROOMBA_600.wheel_base * ROOMBA_600.counts_per_metre;
        assert!((spin - 1660.7).abs() < 0.1, "{spin}");
    }
}
