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
    OccupancyMap, PoseCovariance,
    scan::{CorrelationGrid, Match, ScanPoint, ScanSensor, SearchWindow, SurfaceMap, outline},
};
use nalgebra::Matrix3;
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
/// Least deviation of the particles from their mean that scan matching assumes, m or rad.
const LEAST_SPREAD: f64 = 1e-3;
/// Share of points that agree with the map at a pose that replaces the mean of the particles, and how far away that is at
/// most, m.
const FITS: f64 = 0.5;
const FARTHEST: f64 = 0.3;
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
        let outline = outline(map);
        let points: Vec<Point> = outline.iter().map(|point| point.at).collect();
        Some(Self {
            sensor: ScanSensor::new(laser),
            grid: CorrelationGrid::new(&points, CELL)?,
            likelihood: CorrelationGrid::new(&points, FINE)?,
            surfaces: SurfaceMap::new(std::iter::once((Pose::new(0.0, 0.0, 0.0), &*outline))),
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

    /// The pose near `pose` at which a scan fits best, moved only in the directions of which it tells, and the less the surer
    /// the particles are, whose covariance is `spread`; `None` if it doesn't fit there, or only far away.
    pub fn polished(&self, reading: &ScanReading, pose: Pose, spread: &PoseCovariance) -> Option<Pose> {
        // All points together count for as much as in the likelihood. If each counted, a few that are taken for ones of
        // another surface, such as those beside a door in a corridor, would move the robot along it by a hand's breadth.
        let oriented = reading.all.iter().filter(|point| point.normal.is_some()).count().max(1);
        let tether = information(spread)? * (oriented as f64 / WORTH);
        let (best, fit) = self.surfaces.align(pose, &reading.all, &tether);
        // Along a corridor, where few points tell of the way, the match would follow their errors, by centimetres a step.
        let step = best.position() - pose.position();
        let told = fit.untold().fold(step, |step, axis| step - axis * step.dot(&axis));
        let best = Pose::new(pose.x + told.x, pose.y + told.y, best.heading);
        (fit.share() > FITS && told.norm() < FARTHEST).then_some(best)
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

/// What particles with that covariance know of their pose: the inverse of it.
fn information(spread: &PoseCovariance) -> Option<Matrix3<f64>> {
    let ([xx, xy, yy], heading) = (spread.position, spread.heading * spread.heading);
    let covariance = Matrix3::new(xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, heading);
    (covariance + Matrix3::from_diagonal_element(LEAST_SPREAD * LEAST_SPREAD)).try_inverse()
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
        floor_plan::{Rect, Sketch},
        rng::{Rng, normal},
        robot::model,
    };

    /// A corridor, and a room behind a double door of it: left, bottom, right and top, m.
    const CORRIDOR: Rect = [0.2, 0.2, 18.2, 2.0];
    const DOOR: Rect = [8.2, 2.0, 9.8, 2.2];
    const ROOM: Rect = [6.0, 2.2, 14.0, 8.0];

    /// A scan from `pose` on that floor with the scanner's errors.
    fn scan(laser: Laser, floor: &[Rect], pose: Pose, rng: &mut Rng) -> Vec<f32> {
        const STEP: f64 = 0.004;
        let is_free = |[x, y]: [f64; 2]| {
            floor.iter().any(|&[left, bottom, right, top]| (left..right).contains(&x) && (bottom..top).contains(&y))
        };
        let beam = |beam: usize| {
            let (sin, cos) = math::sin_cos(pose.heading + laser.first + laser.step * beam as f64);
            let steps = (1..).take_while(|&i| {
                let range = STEP * f64::from(i);
                range < laser.range[1] && is_free([pose.x + range * cos, pose.y + range * sin])
            });
            let range = STEP * (0.5 + steps.count() as f64);
            let measured = range + 0.01 * range.max(1.0) * normal(rng);
            if range < laser.range[1] { measured as f32 } else { f32::INFINITY }
        };
        (0..laser.beams).map(beam).collect()
    }

    /// How far along the corridor some robots at `truth` are taken to be from there after a scan if they were expected at
    /// `expected`, with that deviation, m: at most.
    fn off_along(floor: &[Rect], truth: Pose, expected: Pose, deviation: f64) -> f64 {
        let robot = model("roomba600_lidar").unwrap();
        let laser = robot.sensors.laser.unwrap();
        let plan = Sketch::solid(18.4, 8.2, 0.1).carve(floor).finish("", "");
        let search = ScanSearch::new(&OccupancyMap::of(&plan), robot, laser).unwrap();
        let variance = deviation * deviation;
        let spread = PoseCovariance { position: [variance, 0.0, variance], heading: deviation };
        let off = |seed| {
            let scan = scan(laser, floor, truth, &mut RandomStream::Laser.seeded(seed));
            let pose = search.polished(&search.reading(&scan).unwrap(), expected, &spread).unwrap();
            (pose.x - truth.x).abs()
        };
        (0..20).map(off).fold(0.0, f64::max)
    }

    #[test]
    fn noise_moves_no_robot_along_a_bare_corridor() {
        let middle = Pose::new(9.0, 0.5, 0.1);
        let off = off_along(&[CORRIDOR], middle, middle, 0.1);
        assert!(off < 0.01, "{off}");
    }

    #[test]
    fn the_end_of_a_corridor_tells_how_far_away_it_is() {
        let off = off_along(&[CORRIDOR], Pose::new(15.0, 0.5, 0.1), Pose::new(14.92, 0.5, 0.1), 0.1);
        assert!(off < 0.03, "{off}");
    }

    #[test]
    fn few_points_beside_a_door_do_not_move_a_robot_that_is_sure_of_its_place() {
        // There it was moved by up to 4 and 7 cm.
        for x in [8.14, 8.48] {
            let truth = Pose::new(x, 0.41, 0.0);
            let off = off_along(&[CORRIDOR, DOOR, ROOM], truth, truth, 0.04);
            assert!(off < 0.02, "{off} at {x}");
        }
    }

    #[test]
    fn the_circle_in_the_cbot_has_half_its_width() {
        assert!((inside(model("cbot").unwrap()) - 0.1).abs() < 1e-12);
    }
}
