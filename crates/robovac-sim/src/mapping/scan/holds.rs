//! Directions in which obstacles hold a body that touches something.
//!
//! A wall takes from a motion what points into it; along the wall the body slides as far as its wheels roll (measured in the
//! simulator: 5 % of the way are wrong along it, and half of the way across it). A scanner sees the surfaces beside the body, and so
//! which of the two a direction is. In a corner, or at what it can't see, the body can be held in all directions.

use super::ScanPoint;
use nalgebra::Matrix2;
use robovac_core::{
    geometry::{Point, edges, nearest_on_segment},
    math,
    robot::{Body, RobotModel},
};

/// Distance of a surface from the body at which they can touch, m: five standard deviations of a scan's distances.
const NEAR: f64 = 0.05;
/// Least number of points that show what is there.
const LEAST: usize = 3;
/// Share of surface at right angles to most of it from which the body is held there as firmly: a few points of it are a corner
/// (ours).
const CORNER: f64 = 0.15;

/// How firmly what is beside a body can hold it in each direction, as seen from it: 1, or 0 along a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::mapping) struct Holds(Matrix2<f64>);

impl Holds {
    /// What a scan shows beside the robot.
    pub fn beside(robot: &RobotModel, scan: &[ScanPoint]) -> Self {
        let corners: Vec<Point> = match robot.body {
            Body::Round => Vec::new(),
            Body::Polygon(corners) => corners.iter().map(|&[x, y]| Point::new(x, y)).collect(),
        };
        let beside = scan.iter().filter(|point| is_beside(robot.radius, &corners, point.at));
        let normals = beside.filter_map(|point| point.normal);
        let (count, sum) =
            normals.fold((0, Matrix2::zeros()), |(count, sum), normal| (count + 1, sum + normal * normal.transpose()));
        if count < LEAST {
            return Self(Matrix2::identity());
        }
        let axes = sum.symmetric_eigen();
        let least = axes.eigenvalues.imin();
        let share = axes.eigenvalues[least].max(0.0) / axes.eigenvalues[1 - least];
        let along = axes.eigenvectors.column(least);
        Self(Matrix2::identity() - along * along.transpose() * (1.0 - (share / CORNER).min(1.0)))
    }

    /// The same as seen from where the robot was before it turned by `turn`, rad.
    pub fn before(&self, turn: f64) -> Matrix2<f64> {
        let (sin, cos) = math::sin_cos(turn);
        let turn = Matrix2::new(cos, -sin, sin, cos);
        turn * self.0 * turn.transpose()
    }
}

/// Whether a point is near enough to touch a body with these corners, or without any, a circle.
fn is_beside(radius: f64, corners: &[Point], at: Point) -> bool {
    let is_within = at.coords.norm_squared() < (radius + NEAR) * (radius + NEAR);
    let is_near = |(a, b)| (nearest_on_segment(a, b, at) - at).norm_squared() < NEAR * NEAR;
    is_within && (corners.is_empty() || edges(corners).any(is_near))
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{geometry::Vector, robot::model};

    /// Points every 2 cm on a wall that begins at `from`.
    fn wall(from: [f64; 2], along: Vector, normal: Vector) -> impl Iterator<Item = ScanPoint> {
        let at = move |i: i32| Point::new(from[0], from[1]) + along * (0.02 * f64::from(i));
        (0..20).map(move |i| ScanPoint { at: at(i), normal: Some(normal), deviation: 0.01 })
    }

    /// How firmly the `CBot` is held ahead and to its left, as seen from where it was before it turned.
    fn held(scan: &[ScanPoint], turn: f64) -> [f64; 2] {
        let holds = Holds::beside(model("cbot").unwrap(), scan).before(turn);
        [holds[(0, 0)], holds[(1, 1)]]
    }

    #[test]
    fn a_wall_beside_the_body_holds_across_and_not_along() {
        let scan: Vec<ScanPoint> = wall([-0.1, -0.11], Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)).collect();
        let [along, across] = held(&scan, 0.0);
        assert!(along.abs() < 1e-9 && (across - 1.0).abs() < 1e-9, "{along} {across}");
        let [ahead, left] = held(&scan, math::FRAC_PI_2);
        assert!((ahead - 1.0).abs() < 1e-9 && left.abs() < 1e-9, "{ahead} {left}");
    }

    #[test]
    fn a_corner_and_what_is_not_seen_hold_in_all_directions() {
        let side = wall([-0.1, -0.11], Vector::new(1.0, 0.0), Vector::new(0.0, 1.0));
        let ahead = wall([0.21, -0.1], Vector::new(0.0, 1.0), Vector::new(-1.0, 0.0));
        let corner: Vec<ScanPoint> = side.chain(ahead).collect();
        let far: Vec<ScanPoint> = wall([-0.1, -0.6], Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)).collect();
        for scan in [&*corner, &far, &[]] {
            assert_eq!(Holds::beside(model("cbot").unwrap(), scan).0, Matrix2::identity());
        }
    }
}
