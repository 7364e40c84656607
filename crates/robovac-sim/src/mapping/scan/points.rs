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
const REACH: f64 = 0.16;
/// Largest gap between points of one surface: m, and in steps of the scanner at that distance.
const GAP: (f64, f64) = (0.06, 3.5);
/// Mean error of a fitted line at which the points don't lie on one, in standard deviations.
const BENT: f64 = 2.2;
/// Largest uncertainty of a line's direction, rad, and least cosine of the angle at which a beam meets it.
const VAGUE: f64 = 0.3;
const GRAZING: f64 = 0.12;

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
struct Line {
    /// Its direction, rad; ambiguous by half a turn.
    direction: f64,
    /// Sums of the squared distances of the points from their mean, along the line and across it, m²; and their number.
    along: f64,
    across: f64,
    count: f64,
}

/// A hit: its place, the beam's direction, and its length, m.
type Hit = (Point, Vector, f64);

impl Line {
    /// The line with the least squared distances.
    fn through(hits: &[Hit]) -> Option<Self> {
        let count = hits.len() as f64;
        let mean = hits.iter().fold(Vector::zeros(), |sum, hit| sum + hit.0.coords) / count;
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for hit in hits {
            let off = hit.0.coords - mean;
            (xx, xy, yy) = (xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y);
        }
        let (middle, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let root = (half * half + xy * xy).sqrt();
        let direction = 0.5 * math::atan2(2.0 * xy, xx - yy);
        (count > 0.0).then(|| Self { direction, along: middle + root, across: (middle - root).max(0.0), count })
    }

    /// Whether the points lie on it, with errors of that standard deviation, m.
    fn is_straight(&self, deviation: f64) -> bool {
        self.across < BENT * BENT * deviation * deviation * (self.count - 1.0)
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
            // A corner ends it, too.
            let fits = |to: usize| {
                let deviation = DEVIATION * hits[begin..=to].iter().map(|hit| hit.2).fold(1.0, f64::max);
                to < begin + 3 || Line::through(&hits[begin..=to]).is_some_and(|line| line.is_straight(deviation))
            };
            if joins && fits(end) {
                continue;
            }
            walls.extend(wall(&hits[begin..end]));
            begin = end;
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
        // Beside a corner, the points on one side still lie on a line.
        let line = [(low, high), (low, index), (index, high)].into_iter().find_map(|(low, high)| {
            let line = Line::through(&hits[low..=high])?;
            let is_exact = line.along * VAGUE * VAGUE > deviation * deviation;
            (high - low >= 2 && line.is_straight(deviation) && is_exact).then_some(line)
        })?;
        let (sin, cos) = math::sin_cos(line.direction);
        let normal = Vector::new(-sin, cos);
        let cosine = normal.dot(&direction);
        (cosine.abs() > GRAZING).then_some(if cosine > 0.0 { -normal } else { normal })
    }
}

/// The wall that points lie on, if it is long enough.
fn wall(hits: &[Hit]) -> Option<WallLine> {
    let length = (hits.last()?.0 - hits.first()?.0).norm();
    let line = Line::through(hits)?;
    let error = DEVIATION * hits.iter().map(|hit| hit.2).fold(1.0, f64::max);
    let deviation = (error * error / line.along.max(1e-9) + WALL_DEVIATION * WALL_DEVIATION).sqrt();
    let is_wall = length > WALL && line.count >= 8.0 && line.is_straight(error);
    is_wall.then_some(WallLine { direction: line.direction, deviation, length })
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

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
        assert_eq!(walls.len(), 2, "{walls:?}");
        let between = (walls[0].direction - walls[1].direction).abs();
        assert!((between - math::FRAC_PI_2).abs() < 0.05 && walls.iter().all(|wall| wall.length > 1.0), "{walls:?}");
    }

    #[test]
    fn what_is_no_distance_is_left_out() {
        let scan = [f32::NAN, -1.0, 0.0, 1e9, 2.0, f32::INFINITY];
        assert_eq!(sensor().beams(&scan).count(), 2);
        assert_eq!(sensor().points(&scan).len(), 1);
    }
}
