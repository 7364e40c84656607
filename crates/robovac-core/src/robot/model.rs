//! A robot model: geometry, limits, sensors and power.

use super::body::{Battery, Body, Castor, SensorSuite, SideBrush, Tool, WheelLayout};

/// Geometry, limits, sensors and power of a robot. SI units; the middle between the wheels is the body's origin.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotModel {
    /// Name in links, files and on the command line.
    pub id: &'static str,
    /// Name in menus.
    pub title: &'static str,
    /// One sentence for the menu.
    pub summary: &'static str,
    /// Outline of the body.
    pub body: Body,
    /// Radius of the smallest circle around the origin that holds the body, m: where it fits, the robot can turn round.
    pub radius: f64,
    /// How it moves.
    pub wheels: WheelLayout,
    /// Its sensors.
    pub sensors: SensorSuite,
    /// Its castors, as far as a source tells of them. They are only drawn.
    pub castors: &'static [Castor],
    /// Brushes beside the tool.
    pub side_brushes: &'static [SideBrush],
    /// Its battery.
    pub battery: Battery,
    /// Width of the strip of floor that one pass cleans, m.
    pub tool_width: f64,
    /// Where the tool is, and its shape.
    pub tool: Tool,
    /// Distance between the wheels' contact points, m.
    pub wheel_base: f64,
    /// Encoder counts per metre of wheel travel.
    pub counts_per_metre: f64,
    /// Radius of the driven wheels, m.
    pub wheel_radius: f64,
    /// Maximum wheel speed, m/s.
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
    /// Whether it moves on a grid of cells as wide as its tool: a cell is floor only if all of it is free, and standing
    /// on a cell cleans all of it.
    pub fills_cell: bool,
    /// Its power consumption.
    pub power: PowerDraw,
}

/// Electrical power that a cleaning robot draws from its battery, W.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerDraw {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn trapezoid_has_no_jump_where_the_profile_changes() {
        let ramps = 0.3 * 0.3 / 0.8;
        let (below, above) = (trapezoid(ramps - 1e-9, 0.3, 0.8), trapezoid(ramps + 1e-9, 0.3, 0.8));
        assert!((below - above).abs() < 1e-6);
    }
}
