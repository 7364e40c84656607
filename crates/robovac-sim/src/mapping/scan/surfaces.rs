//! Surfaces for scan matching: a mean place and normal for every few centimetres.
//!
//! Points of several scans are gathered in cells. A cell's surface is the mean over it and its eight neighbours, so that a
//! wall on the border of two cells is one wall, and noise averages out. Its normal is that of the line through the means around it, not
//! the mean of the points' normals: a line through noisy points of one scan is turned towards the beams that meet the wall askew (total
//! least squares takes errors across and along the line to be alike), by up to a third of a degree. A body that slides along a
//! wall is corrected away from it in each scan, metres in all, and a share of that as large as the turn would go along the wall.

use super::ScanPoint;
use nalgebra::{Matrix2, Matrix3, Vector3};
use robovac_core::{
    geometry::{Point, Pose, Vector},
    grid::Cell,
    math,
};

/// Side of the cells, m.
const SIDE: f64 = 0.05;
/// Cosine between normals that belong to one surface.
const SAME: f64 = 0.7;
/// Cells around a surface that its normal is fitted to, least number of them, and their least root mean square from their middle, m.
const FIT: (i32, usize, f64) = (5, 3, 0.04);
/// Means lie on one surface up to this distance from it: m, and as a share of how far they are from its middle.
const LEVEL: (f64, f64) = (0.02, 0.1);
/// Least cosine between a fitted normal and the mean of the points' ones.
const FITS: f64 = 0.98;
/// Cells around a point that are searched for its surface.
const REACH: i32 = 3;
/// A surface is met beside its mean place up to this distance, m.
const ASIDE: f64 = 0.08;
/// Standard deviation of surfaces, m (ours).
const MAP: f64 = 0.006;
/// Residuals of more than this many standard deviations count little.
const OUTLIER: f64 = 3.0;
/// A point nearer to its surface than this many standard deviations, or metres, agrees with it.
const AGREES: (f64, f64) = (3.0, 0.03);
/// A pose is in doubt with fewer points on surfaces, or a smaller share of those that agree.
const LEAST_MET: usize = 25;
const AGREE: f64 = 0.8;
/// Information about the position below which a scan tells nothing of it, 1/m² (ours: noise of a bare corridor's walls makes 30).
const TELLS: f64 = 1e3;
/// Largest side of the grid, cells: beyond any range.
const MOST: i32 = 2000;

/// Sums over the points of a cell.
#[derive(Debug, Clone, Copy, Default)]
struct PointSums {
    weight: f32,
    /// Place relative to the grid's corner, and normal.
    place: [f32; 2],
    normal: [f32; 2],
}

/// A few centimetres of surface.
#[derive(Debug, Clone, Copy)]
struct SurfacePatch {
    point: Point,
    normal: Vector,
}

/// Surfaces around the robot.
#[derive(Debug, Clone, Default)]
pub(in crate::mapping) struct SurfaceMap {
    /// Lowest cell.
    low: [i32; 2],
    width: i32,
    height: i32,
    /// Index + 1 of each cell's surface, 0 without one.
    cells: Vec<u32>,
    surfaces: Vec<SurfacePatch>,
}

/// Comparison of a scan with surfaces.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::mapping) struct ScanFit {
    /// Information about x, y and heading, and half the gradient of the weighted squared errors.
    pub information: Matrix3<f64>,
    pub gradient: Vector3<f64>,
    /// Points on surfaces of the scan, those that have a surface of the map near, and those that agree with it.
    pub points: usize,
    pub met: usize,
    pub agreeing: usize,
}

impl SurfaceMap {
    /// The surfaces that scans show from their poses.
    pub fn new<'a>(scans: impl Iterator<Item = (Pose, &'a [ScanPoint])> + Clone) -> Self {
        let world = |(pose, points): (Pose, &'a [ScanPoint])| {
            let ahead = pose.direction();
            let oriented = points.iter().filter_map(|point| Some((point.at, point.normal?, point.deviation)));
            oriented.map(move |(at, normal, deviation)| {
                (
                    Point::new(pose.x + ahead.x * at.x - ahead.y * at.y, pose.y + ahead.y * at.x + ahead.x * at.y),
                    Vector::new(ahead.x * normal.x - ahead.y * normal.y, ahead.y * normal.x + ahead.x * normal.y),
                    deviation,
                )
            })
        };
        let cells = scans.clone().flat_map(world).map(|(at, ..)| Cell::at(at, SIDE));
        let bounds = cells.fold(None, |bounds: Option<[i32; 4]>, cell| {
            let [a, b, c, d] = bounds.unwrap_or([cell.x, cell.y, cell.x, cell.y]);
            Some([a.min(cell.x), b.min(cell.y), c.max(cell.x), d.max(cell.y)])
        });
        let Some([left, bottom, right, top]) = bounds else { return Self::default() };
        let low = [left - REACH, bottom - REACH];
        let [width, height] = [right - left, top - bottom].map(|size| (size + 1 + 2 * REACH).min(MOST));
        let corner = Cell::new(low[0], low[1]).centre(SIDE);
        let mut sums = vec![PointSums::default(); (width * height) as usize];
        let mut filled = Vec::new();
        for (at, normal, deviation) in scans.flat_map(world) {
            let cell = Cell::at(at, SIDE);
            let (x, y) = (cell.x - low[0], cell.y - low[1]);
            if !(1..width - 1).contains(&x) || !(1..height - 1).contains(&y) {
                continue;
            }
            let index = (y * width + x) as usize;
            let sum = &mut sums[index];
            if sum.weight == 0.0 {
                filled.push(index);
            }
            let weight = 1e-4 / (deviation * deviation);
            let off = at - corner;
            sum.weight += weight as f32;
            sum.place = [sum.place[0] + (weight * off.x) as f32, sum.place[1] + (weight * off.y) as f32];
            sum.normal = [sum.normal[0] + (weight * normal.x) as f32, sum.normal[1] + (weight * normal.y) as f32];
        }
        let mut map = Self { low, width, height, cells: vec![0; sums.len()], surfaces: Vec::new() };
        for &index in &filled {
            if let Some(surface) = map.blend(&sums, index, corner) {
                map.surfaces.push(surface);
                map.cells[index] = map.surfaces.len() as u32;
            }
        }
        map
    }

    /// Their places.
    pub fn places(&self) -> Vec<Point> {
        self.surfaces.iter().map(|surface| surface.point).collect()
    }

    /// The surface of a cell and its neighbours.
    fn blend(&self, sums: &[PointSums], index: usize, corner: Point) -> Option<SurfacePatch> {
        let own = Vector::new(f64::from(sums[index].normal[0]), f64::from(sums[index].normal[1]));
        let length = own.norm();
        if length < 1e-6 {
            return None;
        }
        let (mut weight, mut place, mut normal) = (0.0, Vector::zeros(), Vector::zeros());
        for dy in -1..=1 {
            for dx in -1..=1 {
                let sum = &sums[(index as i32 + dy * self.width + dx) as usize];
                let theirs = Vector::new(f64::from(sum.normal[0]), f64::from(sum.normal[1]));
                if theirs.dot(&own) < SAME * length * theirs.norm() || sum.weight == 0.0 {
                    continue;
                }
                weight += f64::from(sum.weight);
                place += Vector::new(f64::from(sum.place[0]), f64::from(sum.place[1]));
                normal += theirs;
            }
        }
        let length = normal.norm();
        if length < 1e-6 {
            return None;
        }
        let (middle, facing) = (place / weight, normal / length);
        let normal = self.fitted(sums, index, (middle, facing)).unwrap_or(facing);
        Some(SurfacePatch { point: corner + middle, normal })
    }

    /// The normal of the line through the means around a cell, of those that lie on a surface through `middle` that faces about
    /// there; `None` if they are too few to tell, or tell otherwise.
    fn fitted(&self, sums: &[PointSums], index: usize, (middle, facing): (Vector, Vector)) -> Option<Vector> {
        let (reach, least, wide) = FIT;
        let (x, y) = (index as i32 % self.width, index as i32 / self.width);
        let (mut cells, mut all, mut mean, mut squares) = (0, 0.0, Vector::zeros(), Matrix2::zeros());
        for row in (y - reach).max(0)..=(y + reach).min(self.height - 1) {
            let columns = (x - reach).max(0)..=(x + reach).min(self.width - 1);
            let row =
                &sums[(row * self.width + columns.start()) as usize..=(row * self.width + columns.end()) as usize];
            for sum in row.iter().filter(|sum| sum.weight > 0.0) {
                let [place, theirs] = [sum.place, sum.normal].map(|[x, y]| Vector::new(f64::from(x), f64::from(y)));
                let weight = f64::from(sum.weight);
                let off = place / weight - middle;
                let is_level = off.dot(&facing).abs() < LEVEL.0 + LEVEL.1 * off.norm();
                if is_level && theirs.dot(&facing) > SAME * theirs.norm() {
                    (cells, all, mean) = (cells + 1, all + weight, mean + off * weight);
                    squares += off * off.transpose() * weight;
                }
            }
        }
        let mean = mean / all;
        let spread = squares / all - mean * mean.transpose();
        let (half, xy) = (0.5 * (spread[(0, 0)] - spread[(1, 1)]), spread[(0, 1)]);
        let along = 0.5 * spread.trace() + (half * half + xy * xy).sqrt();
        let (sin, cos) = math::sin_cos(0.5 * math::atan2(xy, half));
        let normal = Vector::new(-sin, cos);
        let cosine = normal.dot(&facing);
        (cells >= least && along > wide * wide && cosine.abs() > FITS).then_some(normal * cosine.signum())
    }

    /// The surface that a point with the normal `facing` lies on, or nearly.
    fn nearest(&self, at: Point, facing: Vector) -> Option<SurfacePatch> {
        let cell = Cell::at(at, SIDE);
        let (x, y) = (cell.x - self.low[0], cell.y - self.low[1]);
        let columns = (x - REACH).max(0)..=(x + REACH).min(self.width - 1);
        let mut best: Option<(f64, SurfacePatch)> = None;
        for row in (y - REACH).max(0)..=(y + REACH).min(self.height - 1) {
            for column in columns.clone() {
                let index = self.cells[(row * self.width + column) as usize];
                if index == 0 {
                    continue;
                }
                let surface = self.surfaces[index as usize - 1];
                if surface.normal.dot(&facing) < SAME {
                    continue;
                }
                let off = at - surface.point;
                let (height, aside) = (surface.normal.dot(&off), surface.normal.perp(&off));
                if aside.abs() > ASIDE {
                    continue;
                }
                let distance = height * height + 0.5 * aside * aside;
                if best.is_none_or(|(least, _)| distance < least) {
                    best = Some((distance, surface));
                }
            }
        }
        best.map(|(_, surface)| surface)
    }

    /// Compares a scan from `pose` with the surfaces.
    pub fn compare(&self, pose: Pose, scan: &[ScanPoint]) -> ScanFit {
        let (sin, cos) = math::sin_cos(pose.heading);
        let turn = |v: Vector| Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
        let mut fit = ScanFit::default();
        for point in scan {
            let Some(normal) = point.normal else { continue };
            fit.points += 1;
            let arm = turn(point.at.coords);
            let at = pose.position() + arm;
            let Some(surface) = self.nearest(at, turn(normal)) else { continue };
            fit.met += 1;
            let normal = surface.normal;
            let off = normal.dot(&(at - surface.point));
            let variance = point.deviation * point.deviation + MAP * MAP;
            let ratio = off * off / (OUTLIER * OUTLIER * variance);
            let trust = 1.0 / ((1.0 + ratio) * (1.0 + ratio));
            fit.agreeing += usize::from(off.abs() < AGREES.1.max(AGREES.0 * point.deviation));
            let row = Vector3::new(normal.x, normal.y, -normal.perp(&arm));
            fit.information += row * row.transpose() * (trust / variance);
            fit.gradient += row * (off * trust / variance);
        }
        fit
    }

    /// The pose near `pose` at which a scan fits best, and the fit there; `tether` is the information that holds it to
    /// `pose`, which decides where the scan doesn't.
    pub fn align(&self, pose: Pose, scan: &[ScanPoint], tether: &Matrix3<f64>) -> (Pose, ScanFit) {
        /// Most steps, and the change at which they end, m and rad.
        const STEPS: usize = 12;
        const DONE: f64 = 1e-4;
        let mut off = Vector3::zeros();
        let at = |off: &Vector3<f64>| Pose::new(pose.x + off.x, pose.y + off.y, pose.heading + off.z);
        for _ in 0..STEPS {
            let fit = self.compare(at(&off), scan);
            let Some(inverse) = (fit.information + tether).try_inverse() else { break };
            let step = inverse * (fit.gradient + tether * off);
            if !step.iter().all(|value| value.is_finite()) {
                break;
            }
            off -= step;
            if step.norm() < DONE {
                break;
            }
        }
        (at(&off), self.compare(at(&off), scan))
    }
}

impl ScanFit {
    /// Whether the pose is in doubt: little of the scan is known, or it contradicts what is known.
    pub fn is_doubtful(&self) -> bool {
        self.met < self.points.min(LEAST_MET) || (self.agreeing as f64) < AGREE * self.met as f64
    }

    /// The directions, of unit length, in which the scan tells nothing of the position, such as along a bare corridor.
    pub fn untold(&self) -> impl Iterator<Item = Vector> {
        let i = &self.information;
        // Whatever the heading is.
        let position = |a: usize, b: usize| i[(a, b)] - i[(a, 2)] * i[(2, b)] / i[(2, 2)].max(1e-9);
        let [xx, xy, yy] = [position(0, 0), position(0, 1), position(1, 1)];
        let (middle, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let root = (half * half + xy * xy).sqrt();
        let (sin, cos) = math::sin_cos(0.5 * math::atan2(2.0 * xy, xx - yy));
        let axes = [(middle + root, Vector::new(cos, sin)), (middle - root, Vector::new(-sin, cos))];
        axes.into_iter().filter(|&(told, _)| told < TELLS).map(|(_, axis)| axis)
    }

    /// Share of the scan's points that agree with the map, from 0 to 1.
    pub fn share(&self) -> f64 {
        if self.points == 0 { 0.0 } else { self.agreeing as f64 / self.points as f64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mapping::scan::ScanSensor;
    use robovac_core::{
        rng::{normal, seeded},
        robot::model,
    };

    #[test]
    fn noise_of_beams_that_meet_a_wall_askew_does_not_turn_it() {
        let laser = model("cbot").unwrap().sensors.laser.unwrap();
        let sensor = ScanSensor::new(laser);
        let mut rng = seeded(1, 0);
        // Scans of a wall half a metre to the right, ahead of a robot that drives along it.
        let scans: Vec<(Pose, Vec<ScanPoint>)> = (0..40)
            .map(|scan| {
                let distance = |beam: usize| {
                    let (sin, cos) = math::sin_cos(laser.first + laser.step * beam as f64);
                    let distance = if cos > 0.1 && sin < -0.1 { -0.5 / sin } else { f64::INFINITY };
                    (distance + 0.01 * distance.clamp(1.0, 9.0) * normal(&mut rng)) as f32
                };
                let scan_at = Pose::new(0.01 * f64::from(scan), 0.0, 0.0);
                (scan_at, sensor.points(&(0..laser.beams).map(distance).collect::<Vec<f32>>()))
            })
            .collect();
        let tilt = |normals: Vec<Vector>| normals.iter().map(|normal| normal.x).sum::<f64>() / normals.len() as f64;
        let is_middle = |x: f64| (0.6..1.6).contains(&x);
        let points = scans.iter().flat_map(|(pose, points)| points.iter().filter(|at| is_middle(pose.x + at.at.x)));
        let of_points = points.filter_map(|point| point.normal).collect();
        let map = SurfaceMap::new(scans.iter().map(|(pose, points)| (*pose, &**points)));
        let surfaces = map.surfaces.iter().filter(|surface| is_middle(surface.point.x));
        let of_surfaces = surfaces.map(|surface| surface.normal).collect();
        let [before, after] = [tilt(of_points), tilt(of_surfaces)];
        assert!(before.abs() > 0.003 && after.abs() < 0.3 * before.abs(), "{before} rad, {after} rad");
    }

    /// Points every 3 cm on a wall from one point to another, which faces the origin's side.
    fn wall(from: Point, to: Point) -> impl Iterator<Item = ScanPoint> {
        let way = to - from;
        let normal = Vector::new(-way.y, way.x).normalize();
        let count = (way.norm() / 0.03) as usize;
        let at = move |i: usize| from + way * (i as f64 / count as f64);
        (0..=count).map(move |i| ScanPoint { at: at(i), normal: Some(normal), deviation: 0.01 })
    }

    #[test]
    fn a_scan_tells_nothing_of_the_way_along_a_corridor_until_its_end_is_seen() {
        let turn = |angle: f64| {
            let (sin, cos) = math::sin_cos(angle);
            move |x: f64, y: f64| Point::new(cos * x - sin * y, sin * x + cos * y)
        };
        for angle in [0.0, 0.4, 2.0] {
            let at = turn(angle);
            let sides: Vec<ScanPoint> =
                wall(at(-2.0, -0.6), at(2.0, -0.6)).chain(wall(at(2.0, 0.6), at(-2.0, 0.6))).collect();
            let closed: Vec<ScanPoint> = sides.iter().copied().chain(wall(at(2.0, -0.6), at(2.0, 0.6))).collect();
            let here = Pose::new(0.0, 0.0, 0.0);
            let fit = |scan: &[ScanPoint]| SurfaceMap::new(std::iter::once((here, scan))).compare(here, scan);
            let untold: Vec<Vector> = fit(&sides).untold().collect();
            let along = at(1.0, 0.0).coords;
            assert!(untold.len() == 1 && untold[0].perp(&along).abs() < 1e-3, "{angle}: {untold:?}");
            assert_eq!(fit(&closed).untold().count(), 0);
        }
        assert_eq!(ScanFit::default().untold().count(), 2, "no point tells anything");
    }
}
