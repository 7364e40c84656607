//! The points of a scan in the robot's frame, with normals where they lie on a surface.

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

    /// The points of a scan, from right to left.
    pub fn points(&self, scan: &[f32]) -> Vec<ScanPoint> {
        let hits: Vec<(Point, Vector, f64)> = self
            .beams(scan)
            .filter(|(_, distance)| distance.is_finite())
            .map(|(direction, distance)| (self.place() + direction * distance, direction, distance))
            .collect();
        let point = |index: usize| {
            let (at, direction, distance) = hits[index];
            let deviation = DEVIATION * distance.max(1.0);
            ScanPoint { at, normal: self.normal(&hits, index, deviation, direction), deviation }
        };
        (0..hits.len()).map(point).collect()
    }

    /// The normal of the line through a point and its neighbours.
    fn normal(&self, hits: &[(Point, Vector, f64)], index: usize, deviation: f64, direction: Vector) -> Option<Vector> {
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
        let count = (high - low + 1) as f64;
        if high - low < 2 {
            return None;
        }
        let mean = hits[low..=high].iter().fold(Vector::zeros(), |sum, hit| sum + hit.0.coords) / count;
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for hit in &hits[low..=high] {
            let off = hit.0.coords - mean;
            (xx, xy, yy) = (xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y);
        }
        let (middle, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let root = (half * half + xy * xy).sqrt();
        let (along, across) = (middle + root, (middle - root).max(0.0));
        let is_straight = across < BENT * BENT * deviation * deviation * (count - 1.0);
        if !is_straight || along * VAGUE * VAGUE < deviation * deviation {
            return None;
        }
        let (sin, cos) = math::sin_cos(0.5 * math::atan2(2.0 * xy, xx - yy));
        let normal = Vector::new(-sin, cos);
        let cosine = normal.dot(&direction);
        (cosine.abs() > GRAZING).then_some(if cosine > 0.0 { -normal } else { normal })
    }
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
    fn a_lone_point_and_a_corner_have_none() {
        let sensor = sensor();
        let mut scan = vec![f32::INFINITY; 114];
        scan[50] = 1.0;
        assert!(sensor.points(&scan).iter().all(|point| point.normal.is_none()));
        // A corner 0.7 m ahead, convex, at right angles.
        let scan: Vec<f32> =
            sensor.directions.iter().map(|d| if d.x > 0.3 { (0.7 / (d.x - d.y.abs())) as f32 } else { -1.0 }).collect();
        let points = sensor.points(&scan);
        let nearest = points.iter().min_by(|a, b| a.at.coords.norm().total_cmp(&b.at.coords.norm())).unwrap();
        assert!(nearest.normal.is_none(), "{nearest:?}");
        assert!(points.iter().any(|point| point.normal.is_some()));
    }

    #[test]
    fn what_is_no_distance_is_left_out() {
        let scan = [f32::NAN, -1.0, 0.0, 1e9, 2.0, f32::INFINITY];
        assert_eq!(sensor().beams(&scan).count(), 2);
        assert_eq!(sensor().points(&scan).len(), 1);
    }
}
