//! Localisation by a laser scanner: the poses at which a scan fits a known map.
//!
//! One scan leaves few poses, which a search over the whole map finds at once (Olson 2009; Hess et al. 2016). The particle
//! filter then follows them until the motion decides, as with other sensors; scan matching keeps it on the map, where wheels
//! alone would lead it away (Grisetti, Stachniss & Burgard, Improved techniques for grid mapping with Rao-Blackwellized
//! particle filters, IEEE Transactions on Robotics 23(1), 2007). Along a bare corridor, where a scan tells nothing of the
//! way, it is left to the wheels, as in mapping. The likelihood of a scan is that of the distances from its points to the
//! nearest obstacles (likelihood field; Thrun, Burgard & Fox, Probabilistic Robotics, 2005, section 6.4).

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

    /// The pose near `pose` at which a scan fits best, moved only in the directions of which it tells; `None` if it doesn't
    /// fit there, or only far away.
    pub fn polished(&self, reading: &ScanReading, pose: Pose) -> Option<Pose> {
        let [position, heading] = TETHER.map(|deviation| 1.0 / (deviation * deviation));
        let tether = Matrix3::from_diagonal(&Vector3::new(position, position, heading));
        let (best, fit) = self.surfaces.align(pose, &reading.all, &tether);
        // Along a corridor, where few points tell of the way, the match would follow their errors, by centimetres a step.
        let step = best.position() - pose.position();
        let told = fit.untold().fold(step, |step, axis| step - axis * step.dot(&axis));
        let best = Pose::new(pose.x + told.x, pose.y + told.y, best.heading);
        (fit.share() > FITS && told.norm() < 3.0 * TETHER[0]).then_some(best)
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
    use crate::RandomStream;
    use robovac_core::{
        floor_plan::Sketch,
        rng::{Rng, normal},
        robot::model,
    };

    /// A bare corridor: left, bottom, right and top, m.
    const CORRIDOR: [f64; 4] = [0.2, 0.2, 18.2, 2.0];

    /// A scan from `pose` in the corridor with the scanner's errors.
    fn scan(laser: Laser, pose: Pose, rng: &mut Rng) -> Vec<f32> {
        let beam = |beam: usize| {
            let (sin, cos) = math::sin_cos(pose.heading + laser.first + laser.step * beam as f64);
            let [left, bottom, right, top] = CORRIDOR;
            let way = |at: f64, low: f64, high: f64, along: f64| {
                (if along > 0.0 { high - at } else { at - low }) / along.abs().max(1e-9)
            };
            let range = way(pose.x, left, right, cos).min(way(pose.y, bottom, top, sin));
            let measured = range + 0.01 * range.max(1.0) * normal(rng);
            if range < laser.range[1] { measured as f32 } else { f32::INFINITY }
        };
        (0..laser.beams).map(beam).collect()
    }

    /// How far a robot at `truth` is moved along the corridor by a scan if it is expected at `expected`, m, for some scans.
    fn moved_along(truth: Pose, expected: Pose) -> impl Iterator<Item = f64> {
        let robot = model("roomba600_lidar").unwrap();
        let laser = robot.sensors.laser.unwrap();
        let plan = Sketch::solid(18.4, 2.2, 0.1).carve(&[CORRIDOR]).finish("", "");
        let search = ScanSearch::new(&OccupancyMap::of(&plan), robot, laser).unwrap();
        (0..20).map(move |seed| {
            let reading = search.reading(&scan(laser, truth, &mut RandomStream::Laser.seeded(seed))).unwrap();
            search.polished(&reading, expected).unwrap().x - expected.x
        })
    }

    #[test]
    fn noise_moves_no_robot_along_a_bare_corridor() {
        let middle = Pose::new(9.0, 0.5, 0.1);
        let most = moved_along(middle, middle).map(f64::abs).fold(0.0, f64::max);
        assert!(most < 0.01, "{most}");
    }

    #[test]
    fn the_end_of_a_corridor_tells_how_far_away_it_is() {
        let (truth, expected) = (Pose::new(15.0, 0.5, 0.1), Pose::new(14.92, 0.5, 0.1));
        let off = moved_along(truth, expected).map(|by| (by - 0.08).abs()).fold(0.0, f64::max);
        assert!(off < 0.02, "{off}");
    }

    #[test]
    fn the_circle_in_the_cbot_has_half_its_width() {
        assert!((inside(model("cbot").unwrap()) - 0.1).abs() < 1e-12);
    }
}
