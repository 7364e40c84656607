//! The points of a scan in the robot's frame, with normals where they lie on a surface.

use crate::mapping::multiscan::WallLine;
use robovac_core::{
    geometry::{Point, Vector},
    math,
    robot::Laser,
};

/// Standard deviation of a distance, m: up to 1 m, and per metre beyond (Hokuyo URG-04LX, data sheet).
const DEVIATION: f64 = 0.01;
/// Neighbours on either side that a line is fitted through, and the distance from the point at which that ends, m.
const NEIGHBOURS: usize = 8;
pub(super) const REACH: f64 = 0.16;
/// Largest gap between points of one surface: m, and in steps of the scanner at that distance.
const GAP: (f64, f64) = (0.06, 3.5);
/// Mean error of a fitted line at which the points don't lie on one, in standard deviations.
const BENT: f64 = 2.2;
/// Largest uncertainty of a line's direction, rad, and least cosine of the angle at which a beam meets it.
const VAGUE: f64 = 0.3;
const GRAZING: f64 = 0.12;

/// Distance from the line between its ends at which a wall has a corner, in standard deviations.
const CORNER: f64 = 3.0;
/// Shortest wall whose direction counts, m, and the least uncertainty of that, rad: a wall is seen in many scans, which
/// share its error.
const WALL: f64 = 0.8;
const WALL_DEVIATION: f64 = 0.012;

/// A point of a scan.
#[derive(Debug, Clone, Copy)]
pub(in crate::mapping) struct ScanPoint {
    /// Its place in the robot's frame.
    pub at: Point,
    /// The surface's normal there, towards the scanner; `None` for a point that lies on no surface.
    pub normal: Option<Vector>,
    /// Standard deviation of its distance, m.
    pub deviation: f64,
}

/// A straight line through points of a scan.
pub(super) struct Line {
    /// Its direction, rad; ambiguous by half a turn.
    pub direction: f64,
    /// Sums of the squared distances of the points from their mean, along the line and across it, m²; and their number.
    along: f64,
    across: f64,
    count: f64,
}

/// A hit: its place, the beam's direction, and its length, m.
type Hit = (Point, Vector, f64);

impl Line {
    /// The line with the least squared distances.
    pub fn through(points: impl Iterator<Item = Point> + Clone) -> Option<Self> {
        let count = points.clone().count() as f64;
        let mean = points.clone().fold(Vector::zeros(), |sum, point| sum + point.coords) / count;
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for point in points {
            let off = point.coords - mean;
            (xx, xy, yy) = (xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y);
        }
        let (middle, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let root = (half * half + xy * xy).sqrt();
        let direction = 0.5 * math::atan2(2.0 * xy, xx - yy);
        (count > 0.0).then(|| Self { direction, along: middle + root, across: (middle - root).max(0.0), count })
    }

    /// Mean square of the points' distances from it, m².
    pub fn error(&self) -> f64 {
        self.across / (self.count - 1.0)
    }

    /// Whether the points lie on it, with errors of that standard deviation, m.
    pub fn is_straight(&self, deviation: f64) -> bool {
        self.error() < BENT * BENT * deviation * deviation
    }
}

/// A scanner with the directions of its beams.
#[derive(Debug, Clone)]
pub(in crate::mapping) struct ScanSensor {
    laser: Laser,
    directions: Vec<Vector>,
}

impl ScanSensor {
    pub fn new(laser: Laser) -> Self {
        let direction = |beam: usize| {
            let (sin, cos) = math::sin_cos(laser.first + laser.step * beam as f64);
            Vector::new(cos, sin)
        };
        Self { directions: (0..laser.beams).map(direction).collect(), laser }
    }

    /// Position of the scanner in the robot's frame.
    pub fn place(&self) -> Point {
        Point::new(self.laser.at[0], self.laser.at[1])
    }

    /// Farthest distance that it measures, m.
    pub fn range(&self) -> f64 {
        self.laser.range[1]
    }

    /// The beams of a scan: direction in the robot's frame, and distance, infinite where there is nothing. Readings that
    /// aren't distances are left out.
    pub fn beams<'a>(&'a self, scan: &'a [f32]) -> impl Iterator<Item = (Vector, f64)> + 'a {
        let is_distance = |distance: f64| distance > 0.0 && (distance <= self.range() || distance.is_infinite());
        let beams = self.directions.iter().zip(scan).map(|(&direction, &distance)| (direction, f64::from(distance)));
        beams.filter(move |&(_, distance)| is_distance(distance))
    }

    fn hits(&self, scan: &[f32]) -> Vec<Hit> {
        let ends = self.beams(scan).filter(|(_, distance)| distance.is_finite());
        ends.map(|(direction, distance)| (self.place() + direction * distance, direction, distance)).collect()
    }

    /// The straight walls of a scan, in the robot's frame.
    pub fn walls(&self, scan: &[f32]) -> Vec<WallLine> {
        let hits = self.hits(scan);
        let mut walls = Vec::new();
        let mut begin = 0;
        for end in 1..=hits.len() {
            let joins = end < hits.len() && {
                let gap = GAP.0 + GAP.1 * self.laser.step * hits[end].2;
                (hits[end].0 - hits[end - 1].0).norm_squared() < gap * gap
            };
            if !joins {
                split(&hits[begin..end], &mut walls);
                begin = end;
            }
        }
        walls
    }

    /// The points of a scan, from right to left.
    pub fn points(&self, scan: &[f32]) -> Vec<ScanPoint> {
        let hits = self.hits(scan);
        let point = |index: usize| {
            let (at, direction, distance) = hits[index];
            let deviation = DEVIATION * distance.max(1.0);
            ScanPoint { at, normal: self.normal(&hits, index, deviation, direction), deviation }
        };
        (0..hits.len()).map(point).collect()
    }

    /// The normal of the line through a point and its neighbours.
    fn normal(&self, hits: &[Hit], index: usize, deviation: f64, direction: Vector) -> Option<Vector> {
        let (at, _, distance) = hits[index];
        let gap = GAP.0 + GAP.1 * self.laser.step * distance;
        let joins = |a: usize, b: usize| (hits[a].0 - hits[b].0).norm_squared() < gap * gap;
        let is_near = |other: usize| (hits[other].0 - at).norm_squared() < REACH * REACH;
        let (mut low, mut high) = (index, index);
        while low > 0 && index - low < NEIGHBOURS && joins(low, low - 1) && (low == index || is_near(low)) {
            low -= 1;
        }
        while high + 1 < hits.len()
            && high - index < NEIGHBOURS
            && joins(high, high + 1)
            && (high == index || is_near(high))
        {
            high += 1;
        }
        let line = |low: usize, high: usize| {
            let line = Line::through(hits[low..=high].iter().map(|hit| hit.0))?;
            let is_exact = line.along * VAGUE * VAGUE > deviation * deviation;
            (high - low >= 2 && line.is_straight(deviation) && is_exact).then_some(line)
        };
        // Beside a corner, the points on one side still lie on a line: on that which fits better. To prefer a side would turn
        // the map, as scans always go around the same way.
        let line = line(low, high).or_else(|| match (line(low, index), line(index, high)) {
            (Some(right), Some(left)) => Some(if right.error() <= left.error() { right } else { left }),
            (right, left) => right.or(left),
        })?;
        let (sin, cos) = math::sin_cos(line.direction);
        let normal = Vector::new(-sin, cos);
        let cosine = normal.dot(&direction);
        (cosine.abs() > GRAZING).then_some(if cosine > 0.0 { -normal } else { normal })
    }
}

/// Adds the walls that joined points lie on. They are split at the point farthest from the line between the first and the last
/// one (Ramer 1972, An iterative procedure for the polygonal approximation of plane curves): to follow a wall until points
/// don't fit would take a few of the next one in, always at the same end, and so turn all walls the same way.
fn split(hits: &[Hit], walls: &mut Vec<WallLine>) {
    let [first, .., last] = hits else { return };
    let chord = last.0 - first.0;
    let off = |hit: &Hit| chord.perp(&(hit.0 - first.0)).abs() / (DEVIATION * hit.2.max(1.0));
    let farthest = hits.iter().map(off).enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
    match farthest {
        Some((at, off)) if off > CORNER * chord.norm() => {
            split(&hits[..=at], walls);
            split(&hits[at..], walls);
        }
        // The first and the last point can lie on the next wall.
        _ => walls.extend(wall(&hits[1..hits.len() - 1])),
    }
}

/// The wall that points lie on, if it is long enough.
fn wall(hits: &[Hit]) -> Option<WallLine> {
    let length = (hits.last()?.0 - hits.first()?.0).norm();
    let line = Line::through(hits.iter().map(|hit| hit.0))?;
    let error = DEVIATION * hits.iter().map(|hit| hit.2).fold(1.0, f64::max);
    let deviation = (error * error / line.along.max(1e-9) + WALL_DEVIATION * WALL_DEVIATION).sqrt();
    let is_wall = length > WALL && line.count >= 8.0 && line.is_straight(error);
    is_wall.then_some(WallLine { direction: line.direction, deviation, length })
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{geometry::normalize, robot::model};

    fn sensor() -> ScanSensor {
        ScanSensor::new(model("cbot").unwrap().sensors.laser.unwrap())
    }

    /// A wall at x = 1 m in front of the scanner, which ends at y = 0.5 m.
    fn wall() -> Vec<f32> {
        let sensor = sensor();
        let distance = |direction: &Vector| {
            let distance = 1.0 / direction.x;
            if direction.x > 0.0 && (direction.y * distance) < 0.5 && distance < 5.0 {
                distance as f32
            } else {
                f32::INFINITY
            }
        };
        sensor.directions.iter().map(distance).collect()
    }

    #[test]
    fn points_of_a_wall_have_its_normal() {
        let points = sensor().points(&wall());
        assert!(points.len() > 20);
        for point in &points {
            assert!((point.at.x - 1.15).abs() < 1e-6 && point.at.y < 0.5);
        }
        let oriented: Vec<Vector> = points.iter().filter_map(|point| point.normal).collect();
        assert!(oriented.len() + 8 > points.len(), "{} of {}", oriented.len(), points.len());
        assert!(oriented.iter().all(|normal| (normal - Vector::new(-1.0, 0.0)).norm() < 1e-6));
    }

    #[test]
    fn a_lone_point_has_none_and_those_beside_a_corner_have_that_of_their_wall() {
        let sensor = sensor();
        let mut scan = vec![f32::INFINITY; 114];
        scan[50] = 1.0;
        assert!(sensor.points(&scan).iter().all(|point| point.normal.is_none()));
        // A corner that points at the scanner from 0.7 m ahead, at right angles.
        let distance = |d: &Vector| if d.x > 0.3 + d.y.abs() { (0.7 / (d.x - d.y.abs())) as f32 } else { -1.0 };
        let scan: Vec<f32> = sensor.directions.iter().map(distance).collect();
        let points = sensor.points(&scan);
        let normals: Vec<Vector> = points.iter().filter_map(|point| point.normal).collect();
        let is_of_a_wall = |normal: &Vector| (normal.x + 0.707).abs() < 0.25 && (normal.y.abs() - 0.707).abs() < 0.25;
        assert!(normals.len() > 20 && normals.iter().all(is_of_a_wall), "{normals:?}");
    }

    #[test]
    fn the_walls_of_a_corner_are_at_right_angles() {
        let sensor = sensor();
        // Walls 1 m ahead and 1.2 m to the left.
        let distance = |d: &Vector| {
            let [ahead, left] =
                [(1.0, d.x), (1.2, d.y)].map(|(off, along)| if along > 0.05 { off / along } else { 9.0 });
            if ahead.min(left) < 4.0 { ahead.min(left) as f32 } else { f32::INFINITY }
        };
        let scan: Vec<f32> = sensor.directions.iter().map(distance).collect();
        let walls = sensor.walls(&scan);
        let [first, .., last] = &*walls else { panic!("{walls:?}") };
        let between = (first.direction - last.direction).abs();
        assert!((between - math::FRAC_PI_2).abs() < 0.01 && first.length.min(last.length) > 1.0, "{walls:?}");
        // One of them can be found in pieces.
        assert!(walls.iter().all(|wall| normalize(4.0 * wall.direction).abs() < 0.01), "{walls:?}");
    }

    /// Distances to the walls of a corner, 1.5 m ahead and so far to one side, m: 1 for the left, -1 for the right; without
    /// errors, or with ones that alternate.
    fn corner(side: f64, error: f32) -> Vec<f32> {
        let distance = |(beam, d): (usize, &Vector)| {
            let [ahead, aside] =
                [(1.5, d.x), (1.2, side * d.y)].map(|(off, along)| if along > 0.05 { off / along } else { 9.0 });
            let range = ahead.min(aside) as f32;
            let sign = if beam.is_multiple_of(2) { 1.0 } else { -1.0 };
            if range < 4.0 { range * (1.0 + sign * error) } else { f32::INFINITY }
        };
        sensor().directions.iter().enumerate().map(distance).collect()
    }

    #[test]
    fn the_next_wall_does_not_turn_the_one_before_it() {
        // Beams go from right to left: on one side the long wall comes first, on the other one last.
        for (side, error) in [(1.0, 0.0), (-1.0, 0.0), (1.0, 0.005), (-1.0, 0.005)] {
            let walls = sensor().walls(&corner(side, error));
            assert_eq!(walls.len(), 2, "{walls:?}");
            for wall in walls {
                let off = 0.25 * normalize(4.0 * wall.direction).abs();
                assert!(off.to_degrees() < 0.3, "side {side}, error {error}: {} degrees", off.to_degrees());
            }
        }
    }

    #[test]
    fn normals_beside_a_corner_do_not_prefer_a_side() {
        let sum = |side: f64| {
            let points = sensor().points(&corner(side, 0.0));
            let turn = |normal: Vector| 0.25 * normalize(4.0 * math::atan2(normal.y, normal.x)) * side;
            points.iter().filter_map(|point| point.normal).map(turn).sum::<f64>()
        };
        assert!((sum(1.0) - sum(-1.0)).abs() < 0.3, "{} and {}", sum(1.0), sum(-1.0));
    }

    #[test]
    fn what_is_no_distance_is_left_out() {
        let scan = [f32::NAN, -1.0, 0.0, 1e9, 2.0, f32::INFINITY];
        assert_eq!(sensor().beams(&scan).count(), 2);
        assert_eq!(sensor().points(&scan).len(), 1);
    }
}
