//! Key frames: scans whose poses are adjusted, and everything that hangs on them.

use super::{
    CorrelationGrid, ScanPoint, ScanSensor, SearchWindow, SurfaceMap,
    axes::WallAxes,
    graph::{Edge, KnownHeading, PoseGraph, between, compose},
    outline::outline,
    paint::{paint_body, paint_scan},
    surfaces::ScanFit,
};
use crate::mapping::{CellMark, Marks, OccupancyMap, TiledLayer, multiscan::WallLine};
use nalgebra::{Matrix3, Vector3};
use robovac_core::{
    geometry::{Point, Pose, Vector, difference},
    grid::Cell,
    math,
    robot::{Laser, RobotModel, SensorReadings},
};
use std::{collections::BTreeMap, sync::Arc};

/// A new key frame is made where none of these is nearer than this, m and rad.
const APART: (f64, f64) = (0.4, 0.6);
/// Way along edges up to which key frames are known to agree, m.
const LINKED: f64 = 8.0;
/// Key frames that a scan is matched to are at most this far away, and so are the points of a given map, m; they are
/// gathered again after this way, m.
const AROUND: f64 = 4.0;
const REGATHER: f64 = 0.4;
/// Key frames for a loop closure are at most this far away, m, and at most so many.
const CANDIDATES: f64 = 2.5;
const MOST_CANDIDATES: usize = 40;
/// Window in which a loop is searched: m, m per metre of way along the edges, and most; and the same in rad.
const WINDOW: [f64; 3] = [0.2, 0.01, 1.0];
const TURN: [f64; 3] = [0.05, 0.003, 0.2];
/// Cells of the searches, m.
const CELL: f64 = 0.05;
/// Least score of a match, and share of agreeing points that closes a loop.
const SCORE: f64 = 0.5;
const CLOSES: f64 = 0.6;
/// Least number of a key frame's points that closes a loop: few points fit in many places.
const TELLING: usize = 100;
/// Accuracy of an edge: m and rad for a match, and m, m per m, rad and rad per rad for the wheels.
const MATCHED: [f64; 2] = [0.003, 0.0015];
const CLOSED: [f64; 2] = [0.006, 0.003];
const ROLLED: [f64; 4] = [0.003, 0.02, 0.01, 0.03];
/// Mean error of so many headings by walls from which the poses are adjusted, rad.
const MISSED: (usize, f64) = (6, 0.003);
/// Distance from all key frames at which a pose in doubt makes one, m.
const LEFT: f64 = 0.8;
/// Most scans that make a key frame.
const MOST_SCANS: usize = 40;
/// Change of a key frame's place at which the map is painted again, m.
const REPAINT: f64 = 0.004;
/// Scans from nearer places or headings aren't kept: cells, m, and sectors.
const VIEW: f64 = 0.06;
const SECTORS: f64 = 60.0;
/// Distance and turn after which the next scan is painted, m and rad.
const PAINT: (f64, f64) = (0.05, 0.05);

/// A scan, and where it was taken.
#[derive(Debug, Clone)]
struct PlacedScan {
    frame: usize,
    relative: Pose,
    scan: Arc<[f32]>,
}

/// A place of the body.
#[derive(Debug, Clone, Copy)]
struct Place {
    frame: usize,
    relative: Pose,
    is_dirty: bool,
}

/// The key frames of a robot with a laser scanner.
#[derive(Debug, Clone)]
pub(in crate::mapping) struct ScanMapper {
    sensor: Arc<ScanSensor>,
    /// Points of each key frame, in its own coordinates.
    frames: Vec<Arc<[ScanPoint]>>,
    /// Points of the scans near the latest key frame, of which it is the mean in the end, and their number.
    open: Vec<ScanPoint>,
    scans: usize,
    graph: PoseGraph,
    axes: WallAxes,
    /// Way along the edges from the current key frame to each, m; infinite beyond [`LINKED`].
    ways: Vec<f64>,
    /// The key frame that the present pose refers to: the nearest linked one.
    current: usize,
    /// Scans and places to paint the map from, and the places and headings that have been stored.
    views: Vec<PlacedScan>,
    places: Vec<Place>,
    viewed: TiledLayer<u64>,
    /// Map that it began with, with its boundary's points.
    given: Option<Arc<(OccupancyMap, Marks, Vec<ScanPoint>)>>,
    /// Surfaces around the robot, and where it was when they were gathered.
    surfaces: Arc<SurfaceMap>,
    gathered: Option<Point>,
    /// Largest change of a key frame's place since the map was painted, m.
    moved: f64,
    /// The latest scan, and the pose at which one was painted.
    last: Option<Arc<[f32]>>,
    painted: Option<Pose>,
}

impl ScanMapper {
    pub fn new(laser: Laser) -> Self {
        Self {
            sensor: Arc::new(ScanSensor::new(laser)),
            frames: Vec::new(),
            open: Vec::new(),
            scans: 0,
            graph: PoseGraph::default(),
            axes: WallAxes::default(),
            ways: Vec::new(),
            current: 0,
            views: Vec::new(),
            places: Vec::new(),
            viewed: TiledLayer::new(),
            given: None,
            surfaces: Arc::new(SurfaceMap::default()),
            gathered: None,
            moved: 0.0,
            last: None,
            painted: None,
        }
    }

    /// The same on a given map.
    pub fn knowing(mut self, map: &OccupancyMap, marks: &Marks) -> Self {
        self.given = Some(Arc::new((map.clone(), marks.clone(), outline(map))));
        self
    }

    /// The scan of a reading, if it is a new one.
    pub fn fresh(&mut self, sensed: &SensorReadings) -> Option<Arc<[f32]>> {
        let scan = sensed.laser.as_ref()?;
        if self.last.as_ref().is_some_and(|last| Arc::ptr_eq(last, scan)) {
            return None;
        }
        self.last = Some(Arc::clone(scan));
        Some(Arc::clone(scan))
    }

    /// Whether no scan has been added.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// The points of a scan.
    pub fn points(&self, scan: &[f32]) -> Vec<ScanPoint> {
        self.sensor.points(scan)
    }

    /// The walls of a scan.
    pub fn walls(&self, scan: &[f32]) -> Vec<WallLine> {
        self.sensor.walls(scan)
    }

    /// The robot is at `pose`, whatever was known before.
    pub fn relocate(&mut self, pose: Pose) {
        let nearest = self.nearest(pose, |_| true);
        self.current = nearest.unwrap_or(self.current);
        self.ways = if self.frames.is_empty() { Vec::new() } else { self.graph.ways(self.current, LINKED) };
        (self.gathered, self.painted) = (None, None);
    }

    /// The surfaces around `pose`.
    pub fn surfaces(&mut self, pose: Pose) -> Arc<SurfaceMap> {
        let here = pose.position();
        if self.gathered.is_none_or(|at| (at - here).norm() > REGATHER) {
            self.gather(pose);
        }
        Arc::clone(&self.surfaces)
    }

    fn gather(&mut self, pose: Pose) {
        let here = pose.position();
        if let Some(nearest) = self.nearest(pose, |frame| self.ways[frame].is_finite())
            && nearest != self.current
        {
            self.current = nearest;
            self.ways = self.graph.ways(nearest, LINKED);
        }
        let near = (0..self.frames.len())
            .filter(|&frame| self.ways[frame].is_finite())
            .filter(|&frame| (self.graph.poses[frame].position() - here).norm() < AROUND);
        let given: Vec<ScanPoint> = self
            .given
            .iter()
            .flat_map(|given| &given.2)
            .copied()
            .filter(|point| (point.at - here).norm() < 1.5 * AROUND)
            .collect();
        let given = std::iter::once((Pose::new(0.0, 0.0, 0.0), &*given));
        let scans = near.map(|frame| (self.graph.poses[frame], &*self.frames[frame]));
        self.surfaces = Arc::new(SurfaceMap::new(given.chain(scans)));
        self.gathered = Some(here);
    }

    /// The nearest key frame of a kind.
    fn nearest(&self, pose: Pose, is: impl Fn(usize) -> bool) -> Option<usize> {
        let off = |frame: usize| (self.graph.poses[frame].position() - pose.position()).norm_squared();
        (0..self.frames.len()).filter(|&frame| is(frame)).min_by(|&a, &b| off(a).total_cmp(&off(b)))
    }

    /// Searches around a pose that doesn't fit, for one that does; `None` if there is none.
    pub fn search(&mut self, pose: Pose, scan: &[ScanPoint], window: [f64; 2]) -> Option<(Pose, ScanFit)> {
        let surfaces = self.surfaces(pose);
        let grid = CorrelationGrid::new(&surfaces.places(), CELL)?;
        let points: Vec<Point> = scan.iter().filter(|point| point.normal.is_some()).map(|point| point.at).collect();
        let found = grid.search(&points, SearchWindow::Around(pose, window), (1, 0.3, 1.0), |_| true);
        let tether = Matrix3::from_diagonal(&Vector3::new(1e3, 1e3, 1e3));
        found.first().map(|best| surfaces.align(best.pose, scan, &tether))
    }

    /// Adds a scan that was matched at `pose`, with its points and walls, and with what it says about that pose. Returns the adjusted
    /// pose if the map was adjusted.
    pub fn add(
        &mut self,
        pose: Pose,
        scan: &Arc<[f32]>,
        (points, walls): (&[ScanPoint], &[WallLine]),
        fit: &ScanFit,
    ) -> Option<Pose> {
        let is_near = |other: Pose| {
            (other.position() - pose.position()).norm() < APART.0
                && difference(other.heading, pose.heading).abs() < APART.1
        };
        let mut linked = (0..self.frames.len()).filter(|&frame| self.ways[frame].is_finite());
        let is_covered = linked.any(|frame| is_near(self.graph.poses[frame]));
        // A pose in doubt makes no key frame, unless the robot has left all others behind.
        let is_doubtful = fit.is_doubtful();
        let is_left = |other: Pose| (other.position() - pose.position()).norm() < LEFT;
        let mut linked = (0..self.frames.len()).filter(|&frame| self.ways[frame].is_finite());
        let waits = is_doubtful && linked.any(|frame| is_left(self.graph.poses[frame]));
        let adjusted = if is_covered || waits {
            let latest = self.frames.len() - 1;
            if self.scans < MOST_SCANS && !is_doubtful && is_near(self.graph.poses[latest]) {
                self.gather_scan(between(self.graph.poses[latest], pose), points);
            }
            None
        } else {
            let adjusted = self.close_frame(pose);
            self.open_frame(adjusted.unwrap_or(pose), points, fit);
            adjusted
        };
        let pose = adjusted.unwrap_or(pose);
        if !is_doubtful {
            self.axes.add(self.current, pose.heading - self.graph.poses[self.current].heading, walls);
        }
        let sector = math::floor((pose.heading + math::PI) / math::TAU * SECTORS).clamp(0, SECTORS as i32 - 1);
        let cell = Cell::at(pose.position(), VIEW);
        if self.viewed.get(cell) & (1_u64 << sector) == 0 && (!is_doubtful || !is_covered) {
            self.viewed.update(cell, |sectors| sectors | (1_u64 << sector));
            let relative = between(self.graph.poses[self.current], pose);
            self.views.push(PlacedScan { frame: self.current, relative, scan: Arc::clone(scan) });
        }
        adjusted
    }

    /// Adds the points of a scan that was taken at `relative` to the latest key frame.
    fn gather_scan(&mut self, relative: Pose, points: &[ScanPoint]) {
        let (sin, cos) = math::sin_cos(relative.heading);
        let turn = |v: Vector| Vector::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
        let oriented = points.iter().filter(|point| point.normal.is_some());
        self.open.extend(oriented.map(|point| ScanPoint {
            at: relative.position() + turn(point.at.coords),
            normal: point.normal.map(turn),
            ..*point
        }));
        self.scans += 1;
        // The first scans of a frame are better known the more there are.
        if self.scans.is_power_of_two() && self.scans > 1 {
            let latest = self.frames.len() - 1;
            self.frames[latest] = condensed(&self.open).into();
            self.gathered = None;
        }
    }

    /// Completes the latest key frame by the scans near it, searches a loop there, and turns it along the walls. Returns the robot's
    /// pose if that adjusted the map.
    fn close_frame(&mut self, pose: Pose) -> Option<Pose> {
        let latest = self.frames.len().checked_sub(1)?;
        self.frames[latest] = condensed(&std::mem::take(&mut self.open)).into();
        let relative = between(self.graph.poses[latest], pose);
        self.ways = self.graph.ways(latest, LINKED);
        let is_closed = self.close_loop(latest);
        let is_turned = self.turn_along_walls(latest);
        (is_closed || is_turned).then(|| compose(self.graph.poses[latest], relative))
    }

    /// Learns a key frame's heading from the walls around it, and adjusts all poses if the last ones have missed theirs; returns
    /// whether it did.
    fn turn_along_walls(&mut self, frame: usize) -> bool {
        let known = self.axes.heading(frame, &self.graph.poses);
        if !self.is_straight() {
            return self.graph.forget_headings() && self.optimise();
        }
        let Some([heading, deviation]) = known else { return false };
        self.graph.face(KnownHeading { pose: frame, heading, deviation });
        self.graph.missed_by(MISSED.0).abs() > MISSED.1 && self.optimise()
    }

    /// Adjusts all poses.
    fn optimise(&mut self) -> bool {
        self.moved += self.graph.optimise();
        true
    }

    /// Whether it is known that the building's walls are parallel or at right angles.
    pub fn is_straight(&self) -> bool {
        self.axes.is_straight()
    }

    /// Makes a key frame of a scan at `pose`.
    fn open_frame(&mut self, pose: Pose, points: &[ScanPoint], fit: &ScanFit) {
        let last = self.nearest(pose, |frame| self.ways[frame].is_finite());
        let frame = self.graph.add(pose);
        self.frames.push(points.into());
        self.axes.add_frame();
        if let Some(from) = last {
            let relative = between(self.graph.poses[from], pose);
            let way = relative.position().coords.norm();
            let rolled = [ROLLED[0] + ROLLED[1] * way, ROLLED[2] + ROLLED[3] * relative.heading.abs()];
            // In the frame of `from`.
            let information = turned(&fit.information, -self.graph.poses[from].heading);
            let information = limited(&information, MATCHED) + diagonal(rolled);
            self.graph.link(Edge { from, to: frame, relative, information, closes_loop: false });
        }
        self.scans = 0;
        self.gather_scan(Pose::new(0.0, 0.0, 0.0), points);
        self.current = frame;
        self.ways = self.graph.ways(frame, LINKED);
        self.gathered = None;
    }

    /// Searches old key frames near `frame` that are far away by the graph, and adjusts all poses if it fits there.
    fn close_loop(&mut self, frame: usize) -> bool {
        let pose = self.graph.poses[frame];
        let scan = Arc::clone(&self.frames[frame]);
        let points: Vec<Point> = scan.iter().filter(|point| point.normal.is_some()).map(|point| point.at).collect();
        if points.len() < TELLING {
            return false;
        }
        let Some(anchor) = self.nearest(pose, |other| self.ways[other].is_infinite()) else { return false };
        if (self.graph.poses[anchor].position() - pose.position()).norm() > CANDIDATES {
            return false;
        }
        let ways = self.graph.ways(anchor, f64::INFINITY);
        let mut old: Vec<usize> = (0..frame)
            .filter(|&other| self.ways[other].is_infinite() && ways[other] < LINKED)
            .filter(|&other| (self.graph.poses[other].position() - pose.position()).norm() < AROUND)
            .collect();
        old.sort_by(|&a, &b| ways[a].total_cmp(&ways[b]));
        old.truncate(MOST_CANDIDATES);
        let scans = old.iter().map(|&other| (self.graph.poses[other], &*self.frames[other]));
        let surfaces = SurfaceMap::new(scans);
        let Some(grid) = CorrelationGrid::new(&surfaces.places(), CELL) else { return false };
        let along = ways[frame].min(1e3);
        let window = [WINDOW, TURN].map(|[least, by_way, most]| (least + by_way * along).min(most));
        let found = grid.search(&points, SearchWindow::Around(pose, window), (1, SCORE, 1.0), |_| true);
        let Some(found) = found.first() else { return false };
        let (at, fit) = surfaces.align(found.pose, &scan, &(Matrix3::identity() * 1.0));
        // Along a corridor, the alignment can leave the window.
        let off = [(at.position() - pose.position()).norm(), difference(pose.heading, at.heading).abs()];
        if fit.share() < CLOSES || off[0] > window[0] || off[1] > window[1] {
            return false;
        }
        let relative = between(self.graph.poses[anchor], at);
        let information = limited(&turned(&fit.information, -self.graph.poses[anchor].heading), CLOSED);
        self.graph.link(Edge { from: anchor, to: frame, relative, information, closes_loop: true });
        self.moved += self.graph.optimise();
        self.ways = self.graph.ways(frame, LINKED);
        true
    }

    /// Adds a place of the body, and whether dirt was found there.
    pub fn pass(&mut self, pose: Pose, is_dirty: bool) {
        if !self.frames.is_empty() {
            let relative = between(self.graph.poses[self.current], pose);
            self.places.push(Place { frame: self.current, relative, is_dirty });
        }
    }

    /// Paints a scan taken at `pose`, unless the last one was painted nearby.
    pub fn paint(&mut self, map: &mut OccupancyMap, pose: Pose, scan: &[f32]) {
        let is_near = |last: Pose| {
            (last.position() - pose.position()).norm() < PAINT.0
                && difference(last.heading, pose.heading).abs() < PAINT.1
        };
        if !self.painted.is_some_and(is_near) {
            self.painted = Some(pose);
            paint_scan(map, pose, &self.sensor, scan);
        }
    }

    /// Whether places have moved so far that the map must be painted again.
    pub fn is_outdated(&self) -> bool {
        self.moved > REPAINT
    }

    /// The map and the marks by the adjusted poses.
    pub fn repaint(&mut self, resolution: f64, robot: &RobotModel) -> (OccupancyMap, Marks) {
        self.moved = 0.0;
        let given = self.given.as_ref().map(|given| (given.0.clone(), given.1.clone()));
        let (mut map, mut marks) = given.unwrap_or_else(|| (OccupancyMap::new(resolution), Marks::new(resolution)));
        for view in &self.views {
            let pose = compose(self.graph.poses[view.frame], view.relative);
            paint_scan(&mut map, pose, &self.sensor, &view.scan);
        }
        for place in &self.places {
            let pose = compose(self.graph.poses[place.frame], place.relative);
            paint_place(&mut map, &mut marks, pose, robot, place.is_dirty);
        }
        (map, marks)
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        let points = self.frames.iter().map(|points| points.len() * size_of::<ScanPoint>()).sum::<usize>();
        let views = self.views.iter().map(|view| size_of::<PlacedScan>() + size_of_val(&*view.scan)).sum::<usize>();
        points
            + views
            + self.places.len() * size_of::<Place>()
            + self.viewed.bytes()
            + self.graph.bytes()
            + self.axes.bytes()
    }
}

/// Adds the floor under the body at `pose`, cleaned, and dirty if so.
pub(in crate::mapping) fn paint_place(
    map: &mut OccupancyMap,
    marks: &mut Marks,
    pose: Pose,
    robot: &RobotModel,
    is_dirty: bool,
) {
    paint_body(map, pose, robot);
    let radius = 0.5 * robot.tool_width;
    marks.note(pose.position(), radius, CellMark::Cleaned);
    if is_dirty {
        marks.note(pose.position(), radius, CellMark::Dirty);
    }
}

/// The means of points that are near each other and face alike.
fn condensed(points: &[ScanPoint]) -> Vec<ScanPoint> {
    let mut means: BTreeMap<(i32, i32, i32), (f64, Vector, Vector)> = BTreeMap::new();
    for point in points {
        let Some(normal) = point.normal else { continue };
        let cell = Cell::at(point.at, CELL);
        let side = math::floor(math::atan2(normal.y, normal.x) / math::FRAC_PI_2 + 0.5).rem_euclid(4);
        let (weight, place, facing) = means.entry((cell.x, cell.y, side)).or_default();
        let share = 1.0 / (point.deviation * point.deviation);
        *weight += share;
        *place += point.at.coords * share;
        *facing += normal * share;
    }
    let mean = |(weight, place, facing): (f64, Vector, Vector)| ScanPoint {
        at: (place / weight).into(),
        normal: Some(facing / facing.norm().max(1e-9)),
        deviation: (1.0 / weight).sqrt(),
    };
    means.into_values().map(mean).collect()
}

/// Information in a frame that is turned by `angle` against the present one.
fn turned(information: &Matrix3<f64>, angle: f64) -> Matrix3<f64> {
    let (sin, cos) = math::sin_cos(angle);
    let turn = Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
    turn * information * turn.transpose()
}

/// Information of a match that is no more accurate than so many m and rad.
fn limited(information: &Matrix3<f64>, [position, heading]: [f64; 2]) -> Matrix3<f64> {
    let floor = Matrix3::from_diagonal(&Vector3::new(position * position, position * position, heading * heading));
    let covariance = (information + Matrix3::identity() * 1e-3).try_inverse().map(|covariance| covariance + floor);
    let information = covariance.and_then(Matrix3::try_inverse).unwrap_or_else(Matrix3::zeros);
    0.5 * (information + information.transpose())
}

fn diagonal([position, heading]: [f64; 2]) -> Matrix3<f64> {
    let [position, heading] = [position, heading].map(|deviation| 1.0 / (deviation * deviation));
    Matrix3::from_diagonal(&Vector3::new(position, position, heading))
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    /// The walls of a room of 4 m x 3 m as seen from its middle, a point every `step` metres.
    fn room(step: f64) -> Vec<ScanPoint> {
        let mut points = Vec::new();
        for (half, depth, turns) in [(2.0, 1.5, 0), (1.5, 2.0, 1), (2.0, 1.5, 2), (1.5, 2.0, 3)] {
            for i in 0..(2.0 * half / step) as i32 {
                let (mut at, mut normal) = (Vector::new(f64::from(i) * step - half, -depth), Vector::new(0.0, 1.0));
                for _ in 0..turns {
                    (at, normal) = (Vector::new(-at.y, at.x), Vector::new(-normal.y, normal.x));
                }
                points.push(ScanPoint { at: at.into(), normal: Some(normal), deviation: 0.01 });
            }
        }
        points
    }

    /// Whether the loop is closed of a robot that comes back to a room after 20 m, and believes to be `off` m from where it is.
    fn closes(off: f64, step: f64) -> bool {
        let mut mapper = ScanMapper::new(model("cbot").unwrap().sensors.laser.unwrap());
        let poses = [0.0, 10.0, off].map(|x| Pose::new(x, 0.0, 0.0));
        for (frame, pose) in poses.into_iter().enumerate() {
            mapper.graph.add(pose);
            mapper.frames.push(if frame == 1 { Vec::new() } else { room(step) }.into());
        }
        for (from, to) in [(0, 1), (1, 2)] {
            let (relative, information) = (between(poses[from], poses[to]), Matrix3::identity());
            mapper.graph.link(Edge { from, to, relative, information, closes_loop: false });
        }
        mapper.ways = mapper.graph.ways(2, LINKED);
        mapper.close_loop(2)
    }

    #[test]
    fn loop_outside_its_search_window_is_not_closed() {
        // 20 m of way make a window of 0.4 m.
        assert!(closes(0.35, 0.05));
        assert!(!closes(0.45, 0.05));
    }

    #[test]
    fn loop_with_few_points_is_not_closed() {
        assert!(closes(0.1, 0.1));
        assert!(!closes(0.1, 0.15));
    }
}
