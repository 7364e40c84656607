//! Position and heading of a robot.

use super::{Point, Vector, normalize};
use crate::math;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Position and heading of a robot.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Metres to the right of the map's lower-left corner.
    pub x: f64,
    /// Metres above the map's lower-left corner.
    pub y: f64,
    /// Radians counter-clockwise from +x, in (-π, π].
    pub heading: f64,
}

impl Pose {
    /// A pose at (`x`, `y`) metres with the heading normalised to (-π, π].
    pub fn new(x: f64, y: f64, heading: f64) -> Self {
        Self { x, y, heading: normalize(heading) }
    }

    /// Position without heading.
    pub fn position(&self) -> Point {
        Point::new(self.x, self.y)
    }

    /// Unit vector in the direction of the heading.
    pub fn direction(&self) -> Vector {
        let (sin, cos) = math::sin_cos(self.heading);
        Vector::new(cos, sin)
    }

    /// The point that lies at `local` (x ahead, y to the left, metres) as seen from this pose.
    pub fn to_world(&self, local: Point) -> Point {
        let d = self.direction();
        Point::new(self.x + d.x * local.x - d.y * local.y, self.y + d.y * local.x + d.x * local.y)
    }
}

impl fmt::Display for Pose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:.3} m, {:.3} m, {:.1}°)", self.x, self.y, self.heading.to_degrees())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn to_world_turns_and_shifts() {
        let pose = Pose::new(1.0, 2.0, math::FRAC_PI_2);
        let ahead = pose.to_world(Point::new(1.0, 0.0));
        let left = pose.to_world(Point::new(0.0, 1.0));
        assert!((ahead - Point::new(1.0, 3.0)).norm() < 1e-12);
        assert!((left - Point::new(0.0, 2.0)).norm() < 1e-12);
    }
}
