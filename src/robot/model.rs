//! The robots that can be chosen, every figure with its source.

use super::body::{Battery, Body, Bumper, LightBumper, SensorSuite, SideBrush, Wheels};

/// Geometry, limits, sensors and power of a robot. SI units; the middle between the wheels is the body's origin.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotModel {
    /// Name in links, files and on the command line.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence for people who choose.
    pub summary: &'static str,
    /// Outline of the body.
    pub body: Body,
    /// Radius of the smallest circle around the origin that holds the body, m: where it fits, the robot can turn round.
    pub radius: f64,
    /// How it moves.
    pub wheels: Wheels,
    /// What it senses with.
    pub sensors: SensorSuite,
    /// Brushes beside the tool.
    pub side_brushes: &'static [SideBrush],
    /// Where its power comes from.
    pub battery: Battery,
    /// Width of the strip of floor that one pass cleans, m.
    pub tool_width: f64,
    /// Distance between the wheels' contact points, m.
    pub wheel_base: f64,
    /// Encoder counts per metre of wheel travel.
    pub counts_per_metre: f64,
    /// Radius of the driven wheels, m.
    pub wheel_radius: f64,
    /// Wheel speed that the motors reach, m/s.
    pub max_wheel_speed: f64,
    /// Smallest wheel speed that moves the robot, and the distance between speeds that its motor controller can keep, m/s;
    /// zeros for any speed.
    pub speed_steps: [f64; 2],
    /// Wheel acceleration, m/s².
    pub acceleration: f64,
    /// Speed at which planned paths are driven straight, m/s.
    pub cruise_speed: f64,
    /// Wheel speed at which the robot turns on the spot while following a path, m/s.
    pub turn_wheel_speed: f64,
    /// Side of the planning cells that fits this robot, m.
    pub default_cell: f64,
    /// Whether it lives on a grid of cells as wide as its tool: a cell is floor only if all of it is free, and standing
    /// on a cell cleans all of it.
    pub fills_cell: bool,
    /// What it draws from its battery.
    pub power: Power,
}

/// Electrical power that a cleaning robot draws from its battery, W.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Power {
    /// Electronics and cleaning motors: drawn all the time.
    pub standing: f64,
    /// Wheels while driving straight, in addition.
    pub straight: f64,
    /// Wheels while turning on the spot, in addition.
    pub turning: f64,
}

impl RobotModel {
    /// Turn rate on the spot while following a path, rad/s.
    pub fn turn_rate(&self) -> f64 {
        2.0 * self.turn_wheel_speed / self.wheel_base
    }

    /// Seconds to drive `distance` metres straight, from rest to rest (trapezoidal speed profile).
    pub fn straight_time(&self, distance: f64) -> f64 {
        trapezoid(distance, self.cruise_speed, self.acceleration)
    }

    /// Seconds to turn by `angle` radians on the spot, from rest to rest.
    pub fn turn_time(&self, angle: f64) -> f64 {
        trapezoid(angle.abs() * 0.5 * self.wheel_base, self.turn_wheel_speed, self.acceleration)
    }
}

/// Seconds to cover `distance` from rest to rest with limited speed and acceleration.
fn trapezoid(distance: f64, speed: f64, acceleration: f64) -> f64 {
    let ramps = speed * speed / acceleration;
    if distance >= ramps { distance / speed + speed / acceleration } else { 2.0 * (distance / acceleration).sqrt() }
}

/// iRobot Roomba 600 and Create 2.
///
/// Wheel base 235 mm, wheel diameter 72 mm, 508.8 counts a revolution and at most 500 mm/s are of the Create 2 Open
/// Interface specification; the bumper's diameter of 348.5 mm is of its dimension drawing. The width of the brush,
/// about 170 mm, is what owners measure (the specification doesn't say; the side brush isn't counted). Acceleration
/// and the two speeds for following paths are ours: 300 mm/s is about what the robot's own programs drive.
///
/// Power: 14.4 V x 3 Ah last for up to 100 minutes of cleaning, which is 26 W, and about 500 mA, 7 W, are drawn while
/// driving with the cleaning motors off (Kurt, Hacking Roomba, 2006, chapters 1 and 15; of the 400 series, which has the
/// same battery). Standing still, owners read -111 to -151 mA from packet 23: 2 W. So wheels take 5 W and brushes and
/// vacuum 19 W. For turning, wheel power is taken to be proportional to wheel speed, which is an estimate.
const ROOMBA_600: RobotModel = RobotModel {
    id: "roomba600",
    title: "Roomba 600 / Create 2",
    summary: "Round, 35 cm wide, cleans a strip of 17 cm under its brush",
    body: Body::Round,
    radius: 0.174_25,
    wheels: Wheels::Differential,
    sensors: SensorSuite {
        bumper: Some(Bumper { half_arc: 1.553, both_within: 0.35 }),
        cliffs: [Some([0.063, 0.148]), Some([0.154, 0.042]), Some([0.154, -0.042]), Some([0.063, -0.148])],
        light_bumper: Some(LightBumper { angles: [1.169, 0.559, 0.21, -0.21, -0.559, -1.169], range: 0.2 }),
        infrared: true,
        wheel_drops: true,
        laser: None,
    },
    side_brushes: &[SideBrush { at: [0.092, -0.116], radius: 0.095 }],
    battery: Battery { capacity_mah: 2696.0, voltage: 14.4, charge_ma: 1232.0, has_gauge: true },
    tool_width: 0.17,
    wheel_base: 0.235,
    counts_per_metre: 508.8 / (core::f64::consts::PI * 0.072),
    wheel_radius: 0.036,
    max_wheel_speed: 0.5,
    speed_steps: [0.011, 0.0285],
    acceleration: 0.8,
    cruise_speed: 0.3,
    turn_wheel_speed: 0.2,
    // Lanes overlap by 5 cm: that is how far walls off the lattice move them.
    default_cell: 0.12,
    fills_cell: false,
    power: Power { standing: 21.0, straight: 5.0, turning: 3.3 },
};

/// The robots that ship.
pub const MODELS: &[&RobotModel] = &[&ROOMBA_600, &CELL_20];

/// The thesis' robot on its grid: one cell of 20 cm is what it stands on and cleans (000, section 5.1).
const CELL_20: RobotModel = cell_robot(0.2);

/// An idealised robot that fills one grid cell of side `cell` metres and cleans the cell it stands on.
///
/// Its body is 90 % of the cell, so that it drives through corridors of one cell without rubbing along both walls.
/// The wheel base is three quarters of the body, it drives like the Roomba, and its encoders count hundredths of a
/// millimetre: a textbook's robot knows where it is.
///
/// Its power is the DVR-1's: 6 V x 4.5 Ah last for about an hour, 27 W, split as its motors are rated: 5 A for the vacuum,
/// two brushes of 0.5 A, two wheels of 2 A (002, section IV); turning as for the Roomba.
pub const fn cell_robot(cell: f64) -> RobotModel {
    RobotModel {
        id: "cell",
        title: "Grid robot (one cell)",
        summary: "The textbook's robot: fills one grid cell and cleans it",
        body: Body::Round,
        radius: 0.45 * cell,
        wheels: Wheels::Differential,
        sensors: SensorSuite {
            bumper: Some(Bumper { half_arc: core::f64::consts::FRAC_PI_2, both_within: 0.35 }),
            cliffs: [
                Some([0.25 * cell, 0.4 * cell]),
                Some([0.44 * cell, 0.1 * cell]),
                Some([0.44 * cell, -0.1 * cell]),
                Some([0.25 * cell, -0.4 * cell]),
            ],
            light_bumper: None,
            infrared: true,
            wheel_drops: true,
            laser: None,
        },
        side_brushes: &[],
        battery: Battery { capacity_mah: 4500.0, voltage: 6.0, charge_ma: 818.0, has_gauge: true },
        tool_width: cell,
        wheel_base: 0.675 * cell,
        counts_per_metre: 1e5,
        wheel_radius: 0.2 * cell,
        max_wheel_speed: 0.5,
        speed_steps: [0.0, 0.0],
        acceleration: 0.8,
        cruise_speed: 0.3,
        turn_wheel_speed: 0.2,
        default_cell: cell,
        fills_cell: true,
        power: Power { standing: 16.2, straight: 10.8, turning: 7.2 },
    }
}

/// The model with that id.
pub fn model(id: &str) -> Option<&'static RobotModel> {
    MODELS.iter().copied().find(|m| m.id == id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roomba_counts_match_the_specification() {
        // Open Interface: 0.444565 mm a count, 1660.7 counts per wheel for a full spin.
        assert!((1000.0 / ROOMBA_600.counts_per_metre - 0.444_565).abs() < 1e-6);
        let spin = core::f64::consts::PI * ROOMBA_600.wheel_base * ROOMBA_600.counts_per_metre;
        assert!((spin - 1660.7).abs() < 0.1, "{spin}");
    }

    #[test]
    fn trapezoid_has_no_jump_where_the_profile_changes() {
        let ramps = 0.3 * 0.3 / 0.8;
        let (below, above) = (trapezoid(ramps - 1e-9, 0.3, 0.8), trapezoid(ramps + 1e-9, 0.3, 0.8));
        assert!((below - above).abs() < 1e-6);
    }
}
