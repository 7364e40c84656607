//! Whether something is in the way, by the bumper or, for robots without one, by the laser scanner.

use crate::{
    math,
    robot::{Body, Laser, RobotModel, Sensors},
};
use std::sync::Arc;

/// Room that a robot that sees leaves before what it stops for, m.
const ROOM: f64 = 0.02;
/// What is this share of half the width off the middle or less counts as straight ahead.
const MIDDLE: f64 = 0.25;

/// How a robot feels what is in front of it.
#[derive(Debug, Clone)]
pub(super) enum Feel {
    /// Its bumper says it.
    Bumper,
    /// It looks ahead. Direction of each beam that points forward (index, cosine, sine), half the width of the strip that
    /// its body sweeps, how far ahead it stops, and what the last scan said.
    Laser { beams: Arc<[(usize, f64, f64)]>, half_width: f64, reach: f64, seen: (bool, bool) },
}

impl Feel {
    /// For `robot` when it drives at up to `speed`, m/s.
    pub(super) fn new(robot: &RobotModel, speed: f64) -> Self {
        let (None, Some(laser)) = (robot.sensors.bumper, robot.sensors.laser) else { return Self::Bumper };
        let (front, half_width) = match robot.body {
            Body::Round => (robot.radius, robot.radius),
            Body::Polygon(corners) => {
                corners.iter().fold((0.0, 0.0), |(front, side): (f64, f64), [x, y]| (front.max(*x), side.max(y.abs())))
            }
        };
        let brakes = speed / laser.rate_hz + 0.5 * speed * speed / robot.acceleration;
        // It must be able to turn round where it stops.
        let reach = (front + brakes).max(robot.radius) + ROOM;
        Self::Laser { beams: forward(laser), half_width: half_width + 0.5 * ROOM, reach, seen: (false, false) }
    }

    /// What is felt on the left and on the right.
    pub(super) fn touched(&mut self, sensed: &Sensors) -> (bool, bool) {
        let Self::Laser { beams, half_width, reach, seen } = self else {
            return (sensed.bump_left, sensed.bump_right);
        };
        let Some(scan) = &sensed.laser else { return *seen };
        *seen = (false, false);
        for &(index, cos, sin) in beams.iter() {
            let Some(range) = scan.get(index).map(|&r| f64::from(r)).filter(|r| r.is_finite()) else { continue };
            let (x, y) = (range * cos, range * sin);
            if x < *reach && y.abs() < *half_width {
                seen.0 |= y > -MIDDLE * *half_width;
                seen.1 |= y < MIDDLE * *half_width;
            }
        }
        *seen
    }
}

/// The beams that point forward.
fn forward(laser: Laser) -> Arc<[(usize, f64, f64)]> {
    let angles = (0..laser.beams).map(|i| (i, laser.first + laser.step * i as f64));
    angles.map(|(i, angle)| (i, math::cos(angle), math::sin(angle))).filter(|&(_, cos, _)| cos > 0.0).collect()
}
