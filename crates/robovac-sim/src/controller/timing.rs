//! The timings of 002 (Hasan, Al-Nahid & Reza, ICIEV 2014, section IV.A), as functions of the robot.
//!
//! With wheels of radius r that turn N times a second, R from the middle between them, a robot turns round on the spot once
//! in 2 pi R / (2 pi r N) = R / (r N) seconds, and all else follows. Angles are in degrees here, as printed.
//!
//! The formulas take the wheels to be at full speed at once. Where that matters, the pilot makes up for it: see the
//! behaviours that use them.

use robovac_core::{math, robot::RobotModel};

/// Quantities of the formulas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    /// Wheel radius r, m.
    pub wheel_radius: f64,
    /// Distance R of a wheel from the middle between them, m.
    pub half_base: f64,
    /// Turns N of a wheel a second.
    pub turns_per_s: f64,
    /// Distance L from one lane to the next, m: in the paper the body's diameter.
    pub lane: f64,
}

impl Timing {
    /// For a robot at its cruise speed.
    ///
    /// L is the width that one pass cleans, but not more than the body's. The paper takes the diameter of the body,
    /// "so that the robot partially overlaps adjacent lines" - which it only does if it cleans at its full width - and
    /// prints 14.5 cm for it, which can't be the diameter of a body that has wheels 12 cm from its middle.
    pub fn of(robot: &RobotModel) -> Self {
        Self {
            wheel_radius: robot.wheel_radius,
            half_base: 0.5 * robot.wheel_base,
            turns_per_s: robot.cruise_speed / (math::TAU * robot.wheel_radius),
            lane: robot.tool_width.min(2.0 * robot.radius),
        }
    }

    /// Time to turn round once on the spot: R / (r N), s.
    pub fn full_turn_s(&self) -> f64 {
        self.half_base / (self.wheel_radius * self.turns_per_s)
    }

    /// Least time to turn after a collision, R theta / (720 r N), s, for a bumper that spans `theta_deg`: half of that
    /// angle, so that what was touched anywhere on one half of the bumper is off it afterwards. As much again is the most
    /// that is added by chance (section IV.A.i).
    pub fn corner_escape_s(&self, theta_deg: f64) -> f64 {
        self.full_turn_s() * theta_deg / 720.0
    }

    /// Back by L / 3, formula (1): L / (6 pi r N), s.
    pub fn back_s(&self) -> f64 {
        self.lane / (6.0 * math::PI * self.wheel_radius * self.turns_per_s)
    }

    /// Turn by 90 degrees, formula (2): R / (4 r N), s.
    pub fn turn_s(&self) -> f64 {
        0.25 * self.full_turn_s()
    }

    /// Go by L, formula (3): L / (2 pi r N), s.
    pub fn go_s(&self) -> f64 {
        self.lane / (math::TAU * self.wheel_radius * self.turns_per_s)
    }
}
