//! `CBot`, the simulated robot of the East West University thesis (000).

use crate::robot::{
    RobotModel,
    body::{Battery, Body, Bumper, Castor, Corners, Laser, SensorSuite, Tool, WheelLayout},
    model::PowerDraw,
};
use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Half the length of the body, m, and half its width.
const HALF: [f64; 2] = [0.2, 0.1];
/// Steps of the laser scanner from one beam to the next: every sixth, as a driver's clustering would.
const CLUSTER: f64 = 6.0;
/// One step of the laser scanner, rad.
const STEP: f64 = TAU / 1024.0;

/// Its scanner, Hokuyo's URG-04LX: 0.02 to 5.6 m, steps of 360/1024 degrees from number 44 to 725 with 384 straight
/// ahead, 600 scans a minute (Hokuyo, Communication Protocol Specification SCIP 2.0, command PP).
pub(super) const URG_04LX: Laser = Laser {
    at: [0.15, 0.0],
    first: -340.0 * STEP,
    step: CLUSTER * STEP,
    beams: 114,
    range: [0.02, 5.6],
    rate_hz: 10.0,
};

/// `CBot`.
///
/// Of 000: a box of 0.4 x 0.2 m (section 3.4), two driven wheels whose separation is 0.17 m and diameter 0.14 m (the
/// listing of section 3.5; the text's radius of 0.1 m is that of the drawn cylinder), two castors, and a Hokuyo laser
/// scanner 0.15 m ahead of the middle. The scanner looks along the long side, so that is ahead.
///
/// Ours: the axle is in the middle, between the castors, whose places and radius the thesis doesn't give; encoders as the
/// Roomba's; a bumper on its front half and four
/// cliff sensors (the thesis counts four sensors but names the scanner only, and its rooms have no stairs; without
/// these its robot couldn't drive safely in a flat). It cleans a strip as wide as itself, 0.2 m, which is the thesis'
/// grid cell. It drives as fast as the Roomba and has its battery and power, because the thesis doesn't mention them.
pub(super) const CBOT: RobotModel = RobotModel {
    id: "cbot",
    title: "CBot",
    summary: "Box of 40 x 20 cm with a laser scanner; cleans its full width",
    body: Body::Polygon(Corners::of(&[
        [-HALF[0], -HALF[1]],
        [HALF[0], -HALF[1]],
        [HALF[0], HALF[1]],
        [-HALF[0], HALF[1]],
    ])),
    // The half diagonal.
    radius: 0.223_606_797_749_979,
    wheels: WheelLayout::Differential,
    sensors: SensorSuite {
        bumper: Some(Bumper { half_arc: FRAC_PI_2, both_within: 0.26, height: 0.0 }),
        cliffs: [Some([0.14, 0.09]), Some([0.19, 0.05]), Some([0.19, -0.05]), Some([0.14, -0.09])],
        light_bumper: None,
        infrared: false,
        wheel_drops: false,
        laser: Some(URG_04LX),
    },
    castors: &[Castor { at: [0.17, 0.0], radius: 0.025 }, Castor { at: [-0.17, 0.0], radius: 0.025 }],
    side_brushes: &[],
    battery: Battery { capacity_mah: 2696.0, voltage: 14.4, charge_ma: 0.0, has_gauge: true },
    tool_width: 0.2,
    tool: Tool::CENTRED,
    wheel_base: 0.17,
    counts_per_metre: 508.8 / (PI * 0.14),
    wheel_radius: 0.07,
    max_wheel_speed: 0.5,
    speed_steps: [0.0, 0.0],
    acceleration: 0.8,
    cruise_speed: 0.3,
    turn_wheel_speed: 0.15,
    default_cell: 0.15,
    fills_cell: false,
    power: PowerDraw { standing: 21.0, straight: 5.0, turning: 2.5 },
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_beam_is_within_the_scanners_field() {
        let laser = CBOT.sensors.laser.unwrap();
        let last = laser.first + laser.step * (laser.beams - 1) as f64;
        assert!(last <= (725.0 - 384.0) * STEP + 1e-12 && last > (725.0 - 384.0 - CLUSTER) * STEP);
    }
}
