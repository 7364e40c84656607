//! Localisation by a laser scanner: the poses at which a scan fits a known map.
//!
//! One scan leaves few poses, which a search over the whole map finds at once (Olson 2009; Hess et al. 2016). The particle
//! filter then follows them until the motion decides, as with other sensors; scan matching keeps it on the map, where wheels
//! alone would lead it away (Grisetti, Stachniss & Burgard, Improved techniques for grid mapping with Rao-Blackwellized
//! particle filters, IEEE Transactions on Robotics 23(1), 2007). The likelihood of a scan is that of the
//! distances from its points to the nearest obstacles (likelihood field; Thrun, Burgard & Fox, Probabilistic Robotics,
//! 2005, section 6.4).

use super::DistanceField;
use crate::mapping::{
    OccupancyMap,
    scan::{CorrelationGrid, Match, ScanPoint, ScanSensor, SearchWindow, SurfaceMap, boundary},
};
use nalgebra::{Matrix3, Vector3};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    math,
    robot::{Body, Laser, RobotModel},
};

/// Cells of the search, m.
const CELL: f64 = 0.1;
/// Poses that a search returns at most, their least score, and that as a share of the best.
const FOUND: (usize, f64, f64) = (24, 0.35, 0.75);
/// Every so many-th point of a scan is used.
const EVERY: usize = 2;
/// Cells of the likelihood, m: their values fall as if the standard deviation of a point's distance from an obstacle of
/// the map were 6 cm.
const FINE: f64 = 0.05;
/// Likelihood of points that don't fit, relative to the best: people, moved chairs.
const ODD: f64 = 0.08;
/// Independent observations that a scan counts for.
const WORTH: f64 = 30.0;
/// How deep the body may be in an obstacle of the map, m, as its error.
const SLACK: f64 = 0.05;
/// Expected errors of the mean of the particles, m and rad, and the share of points that agree with the map at a pose that
/// replaces it.
const TETHER: [f64; 2] = [0.1, 0.1];
const FITS: f64 = 0.5;
/// Least number of points that say anything.
const LEAST: usize = 8;

/// What a search for scans needs.
#[derive(Debug, Clone)]
pub(super) struct ScanSearch {
    sensor: ScanSensor,
    grid: CorrelationGrid,
    likelihood: CorrelationGrid,
    surfaces: SurfaceMap,
    /// Radius of the largest circle in the body, m.
    body: f64,
}

/// A scan prepared for comparison with many poses.
#[derive(Debug, Clone)]
pub(super) struct ScanReading {
    points: Vec<Point>,
    all: Vec<ScanPoint>,
}

impl ScanSearch {
    /// `None` for a map without obstacles.
    pub fn new(map: &OccupancyMap, robot: &RobotModel, laser: Laser) -> Option<Self> {
        let boundary = boundary(map);
        let points: Vec<Point> = boundary.iter().map(|point| point.at).collect();
        Some(Self {
            sensor: ScanSensor::new(laser),
            grid: CorrelationGrid::new(&points, CELL)?,
            likelihood: CorrelationGrid::new(&points, FINE)?,
            surfaces: SurfaceMap::new(std::iter::once((Pose::new(0.0, 0.0, 0.0), &*boundary))),
            body: inside(robot),
        })
    }

    /// A scan; `None` if it has too few points.
    pub fn reading(&self, scan: &[f32]) -> Option<ScanReading> {
        let all = self.sensor.points(scan);
        let points: Vec<Point> = all.iter().map(|point| point.at).step_by(EVERY).collect();
        (points.len() >= LEAST).then_some(ScanReading { points, all })
    }

    /// The poses at which a scan fits best.
    pub fn search(&self, reading: &ScanReading, field: &DistanceField) -> Vec<Match> {
        let can_be = |at: Point| field.distance(at) > self.body - SLACK;
        self.grid.search(&reading.points, SearchWindow::Everywhere, FOUND, can_be)
    }

    /// The pose near `pose` at which a scan fits best; `None` if it doesn't fit there, or only far away.
    pub fn polished(&self, reading: &ScanReading, pose: Pose) -> Option<Pose> {
        let [position, heading] = TETHER.map(|deviation| 1.0 / (deviation * deviation));
        let tether = Matrix3::from_diagonal(&Vector3::new(position, position, heading));
        let (best, fit) = self.surfaces.align(pose, &reading.all, &tether);
        let off = (best.position() - pose.position()).norm();
        (fit.share() > FITS && off < 3.0 * TETHER[0]).then_some(best)
    }

    /// Natural logarithm of the likelihood of a scan at `pose`, 0 at best.
    pub fn fit(&self, reading: &ScanReading, field: &DistanceField, pose: Pose) -> f64 {
        let position = pose.position();
        let room = field.distance(position) - self.body;
        let inside = if room < 0.0 { -0.5 * (room / SLACK) * (room / SLACK) } else { 0.0 };
        let (sin, cos) = math::sin_cos(pose.heading);
        let likelihood = |point: &Point| {
            let at = position + Vector::new(cos * point.x - sin * point.y, sin * point.x + cos * point.y);
            math::ln(ODD + (1.0 - ODD) * self.likelihood.value(at))
        };
        inside + WORTH / reading.points.len() as f64 * reading.points.iter().map(likelihood).sum::<f64>()
    }
}

/// Radius of the largest circle around the origin that is in the body, m.
fn inside(robot: &RobotModel) -> f64 {
    match robot.body {
        Body::Round => robot.radius,
        Body::Polygon(corners) => (0..corners.len())
            .map(|i| {
                let ([ax, ay], [bx, by]) = (corners[i], corners[(i + 1) % corners.len()]);
                let side = Vector::new(bx - ax, by - ay);
                (side.x * -ay - side.y * -ax).abs() / side.norm().max(1e-9)
            })
            .fold(robot.radius, f64::min),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    #[test]
    fn the_circle_in_the_cbot_has_half_its_width() {
        assert!((inside(model("cbot").unwrap()) - 0.1).abs() < 1e-12);
    }
}
