//! What the wheels of a differential drive can do.

use crate::robot::{RobotModel, WheelLayout};

/// Shares of the wheels' top speed and acceleration that a plan uses; a follower needs the rest to correct itself.
const PLANNED: (f64, f64) = (0.8, 0.9);

/// Limits of a differential drive, SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveLimits {
    /// Of the middle between the wheels, m/s.
    pub speed: f64,
    /// Of each wheel, m/s, in curves and turns on the spot.
    pub wheel_speed: f64,
    /// Of each wheel, m/s².
    pub acceleration: f64,
    /// Distance of a wheel from the middle, m.
    pub half_base: f64,
}

impl DriveLimits {
    /// The limits of a robot: its cruise speed, four fifths of its wheels' top speed (or what they turn at while they stop at
    /// every corner, if that is more), and nine tenths of their acceleration. `None` for a robot that isn't a differential drive.
    pub fn of(robot: &RobotModel) -> Option<Self> {
        let wheel_speed = (PLANNED.0 * robot.max_wheel_speed).max(robot.turn_wheel_speed).max(robot.cruise_speed);
        (robot.wheels == WheelLayout::Differential).then_some(Self {
            speed: robot.cruise_speed,
            wheel_speed,
            acceleration: PLANNED.1 * robot.acceleration,
            half_base: 0.5 * robot.wheel_base,
        })
    }

    /// The same, but no faster than `speed` m/s.
    pub fn no_faster_than(self, speed: f64) -> Self {
        Self { speed: self.speed.min(speed), ..self }
    }

    /// The fastest speed at a curvature, 1/m: that at which the outer wheel has its top speed.
    pub fn fastest(&self, curvature: f64) -> f64 {
        self.speed.min(self.wheel_speed / (1.0 + self.half_base * curvature.abs()))
    }

    /// Seconds to turn by `angle` radians on the spot, from rest to rest.
    pub fn turn_time(&self, angle: f64) -> f64 {
        let (way, v, a) = (angle.abs() * self.half_base, self.wheel_speed, self.acceleration);
        if way >= v * v / a { way / v + v / a } else { 2.0 * (way / a).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::model;

    #[test]
    fn the_outer_wheel_limits_curves_and_only_differential_drives_have_limits() {
        let limits = DriveLimits::of(model("roomba600").unwrap()).unwrap();
        assert_eq!(limits.fastest(0.0), 0.3);
        let tight = limits.fastest(-20.0);
        assert!((tight * (1.0 + 20.0 * 0.1175) - limits.wheel_speed).abs() < 1e-12 && limits.wheel_speed == 0.4);
        assert_eq!(limits.no_faster_than(0.2).fastest(0.0), 0.2);
        let omni = crate::robot::MODELS.iter().filter(|robot| robot.wheels == WheelLayout::Omnidirectional);
        assert!(omni.clone().count() > 0 && omni.clone().all(|robot| DriveLimits::of(robot).is_none()));
    }

    #[test]
    fn a_turn_on_the_spot_is_hardly_slower_than_with_stops() {
        // By the share of the acceleration that is kept for corrections.
        let most = 1.0 / PLANNED.1.sqrt();
        for robot in crate::robot::MODELS {
            let Some(limits) = DriveLimits::of(robot) else { continue };
            for angle in [1.5, 2.0, 3.1] {
                assert!(limits.turn_time(angle) <= most * robot.turn_time(angle), "{} {angle}", robot.id);
            }
        }
    }
}
