//! The stages one after the other.

use super::{Link, Subgoal, Sweep, SweepError, SweepSetup};
use crate::{
    cspace::{ConfigurationSpace, Motion, Obstacles, Swath},
    floorplan::{FloorPlan, MAX_RESOLUTION, MIN_RESOLUTION},
    geometry::{Point, Pose},
    grid::{Cell, Grid, largest_part, reachable},
    planner::stage::{Beside, Detours, SubgoalScan, is_straight_free, scan_rows, subgoals},
};
use std::ops::{ControlFlow, RangeInclusive};

/// Distances between scan lines that can be asked for, m.
pub const SCAN_WIDTHS: RangeInclusive<f64> = 0.001..=100.0;
/// Most headings of an obstacle map: one a degree.
const MAX_HEADINGS: usize = 360;
/// Links between two reports.
const REPORT_EVERY: usize = 256;

/// How far the stages are when they end, 0 to 1: the obstacle map, subgoals, links; the rest is for coverage.
const DONE: [f64; 3] = [0.25, 0.3, 0.85];

/// Plans a sweep of `plan`. `observe` is told how far it is, 0 to 1, and says whether to go on.
///
/// Of the obstacle map only heading 0 is made here, which is all that the sweep needs; the other headings are
/// [`ConfigurationSpace`]'s. Without a start the robot begins at the first subgoal point of the largest part of the room, as the paper's
/// does (section 4). With one that isn't FREE it begins in the nearest cell that is. Subgoals that it can't get to are left out.
pub fn sweep(
    plan: &FloorPlan,
    setup: &SweepSetup,
    observe: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<Sweep, SweepError> {
    let mut report = |done: f64| match observe(done) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(SweepError::Cancelled),
    };
    let outline = &setup.outline;
    let scan_width = setup.scan_width.unwrap_or(0.5 * outline.width());
    check(setup, scan_width)?;
    report(0.0)?;
    let map = ConfigurationSpace::new(plan, outline, setup.cell, 1)?;
    let motion = Motion::new(plan, outline)?;
    let free = map.slice(0);
    report(DONE[0])?;
    let fits_nowhere = SweepError::FitsNowhere { width: outline.width() };
    let begin = begin(&free, setup).ok_or(fits_nowhere.clone())?;
    let reached = reachable(&free, begin);
    let rows = scan_rows(&reached, scan_width / setup.cell);
    let points = subgoals(&reached, &rows, &Obstacles::of(&free));
    let places = places(&points, &motion, setup.cell);
    if points.is_empty() {
        return Err(fits_nowhere);
    }
    report(DONE[1])?;
    let mut linker = Linker {
        free: &reached,
        cells: points.iter().map(|p| p.cell).collect(),
        places: &places,
        motion: &motion,
        detours: Detours::new(&reached),
        cell: setup.cell,
    };
    let mut scan = SubgoalScan::new(&points, Beside::Never);
    let start = setup.start.map(|pose| start_place(pose, begin, &motion, setup.cell));
    let first = match start {
        None => 0,
        Some(_) => scan.next(&reached, Err(begin)).map_or(0, |(first, _)| first),
    };
    scan.track(first);
    let mut path = Line::default();
    if let Some(start) = start {
        path.extend(&linker.way((begin, start), (points[first].cell, places[first])).0);
    }
    path.extend(&[places[first]]);
    let mut links: Vec<Link> = Vec::with_capacity(points.len());
    let mut from = first;
    while let Some((to, _)) = scan.next(&reached, Ok(from)) {
        if links.len() % REPORT_EVERY == 0 {
            report(DONE[1] + (DONE[2] - DONE[1]) * links.len() as f64 / points.len() as f64)?;
        }
        scan.track(to);
        let (way, collides) = linker.link(from, to);
        path.extend(&way);
        links.push(Link { from, to, collides, way });
        from = to;
    }
    report(DONE[2])?;
    let coverage = coverage(outline, &reached, setup.cell, &path.corners);
    let collisions = links.iter().filter(|link| link.collides).count();
    let resolved = links.iter().filter(|link| link.collides && !link.way.is_empty()).count();
    let length = path.corners.windows(2).map(|piece| (piece[1] - piece[0]).norm()).sum();
    let points = points.iter().zip(&places);
    let points = points.map(|(p, &at)| Subgoal { at, contact: p.contact, line: p.line, obstacle: p.obstacle });
    let subgoals = points.collect();
    report(1.0)?;
    let cell = setup.cell;
    Ok(Sweep { free, cell, scan_width, subgoals, links, collisions, resolved, path: path.corners, length, coverage })
}

/// Says which number is out of range.
fn check(setup: &SweepSetup, scan_width: f64) -> Result<(), SweepError> {
    let refuse = |what: &'static str, value: f64, expected: String| Err(SweepError::Value { what, value, expected });
    if !(MIN_RESOLUTION..=MAX_RESOLUTION).contains(&setup.cell) {
        let expected = format!("{MIN_RESOLUTION} to {MAX_RESOLUTION} m");
        return refuse("the side of the obstacle map's cells", setup.cell, expected);
    }
    // That of an outline that won't do is reported with the outline.
    if setup.scan_width.is_some() && !SCAN_WIDTHS.contains(&scan_width) {
        let expected = format!("{} to {} m", SCAN_WIDTHS.start(), SCAN_WIDTHS.end());
        return refuse("the distance between scan lines", scan_width, expected);
    }
    if !(1..=MAX_HEADINGS).contains(&setup.headings) {
        return refuse("the number of headings", setup.headings as f64, format!("1 to {MAX_HEADINGS}"));
    }
    if let Some(pose) = setup.start {
        for value in [pose.x, pose.y] {
            if !value.is_finite() {
                return refuse("a coordinate of the start", value, "a length in metres".to_owned());
            }
        }
    }
    Ok(())
}

/// The FREE cell in which the robot begins: that of the start or the nearest one, or one of the largest part.
fn begin(free: &Grid<bool>, setup: &SweepSetup) -> Option<Cell> {
    let Some(start) = setup.start else { return largest_part(free) };
    let at = Cell::at(start.position(), setup.cell);
    if free.is_set(at) {
        return Some(at);
    }
    let off = |cell: &Cell| (cell.centre(setup.cell) - start.position()).norm_squared();
    let cells = free.iter().filter(|&(_, &is_free)| is_free).map(|(cell, _)| cell);
    cells.min_by(|a, b| off(a).total_cmp(&off(b)))
}

/// The start itself if the body fits there and can move to the cell's centre, or else that.
fn start_place(start: Pose, begin: Cell, motion: &Motion, cell: f64) -> Point {
    let (place, centre) = (start.position(), begin.centre(cell));
    if Cell::at(place, cell) == begin && motion.is_free(place, centre) { place } else { centre }
}

/// Where the body's origin is when it touches: less than a cell beyond the centre of the last FREE cell of the run.
fn places(points: &[crate::planner::stage::Subgoal], motion: &Motion, cell: f64) -> Vec<Point> {
    let mut blocked = (None, Vec::new());
    let place = |point: &crate::planner::stage::Subgoal| {
        let centre = point.cell.centre(cell);
        if blocked.0 != Some(point.line) {
            blocked = (Some(point.line), motion.blocked(centre.y));
        }
        let next = blocked.1.partition_point(|part| part.0 < centre.x);
        let found = if point.contact.is_left() {
            next.checked_sub(1).and_then(|last| blocked.1.get(last)).map(|part| part.1)
        } else {
            blocked.1.get(next).map(|part| part.0)
        };
        // Never farther than the FULL cell's centre, nor on the wrong side.
        let x = found.filter(|x| (x - centre.x).abs() <= cell).unwrap_or(centre.x);
        let is_on = if point.contact.is_left() { x <= centre.x } else { x >= centre.x };
        Point::new(if is_on { x } else { centre.x }, centre.y)
    };
    points.iter().map(place).collect()
}

/// Makes ways between subgoals.
struct Linker<'a> {
    free: &'a Grid<bool>,
    cells: Vec<Cell>,
    places: &'a [Point],
    motion: &'a Motion,
    detours: Detours<'a>,
    /// Side of a cell, m.
    cell: f64,
}

impl Linker<'_> {
    /// The way from one subgoal to another, and whether the straight one collides.
    fn link(&mut self, from: usize, to: usize) -> (Vec<Point>, bool) {
        self.way((self.cells[from], self.places[from]), (self.cells[to], self.places[to]))
    }

    /// The way from a place in a cell to a place in another. The straight way collides if the line between the cells' centres leaves the
    /// FREE cells (the check of the paper's map). Where it doesn't, it is driven between the places themselves if that is free to the nanometre,
    /// or else by the centres.
    fn way(&mut self, from: (Cell, Point), to: (Cell, Point)) -> (Vec<Point>, bool) {
        let mut line = Line::default();
        line.extend(&[from.1]);
        let collides = !is_straight_free(self.free, from.0, to.0);
        if collides {
            let Some(corners) = self.detours.find(from.0, to.0) else { return (Vec::new(), true) };
            let centres: Vec<Point> = corners.into_iter().map(|corner| corner.centre(self.cell)).collect();
            line.extend(&centres);
        } else if from.0.y != to.0.y && !self.motion.is_free(from.1, to.1) {
            line.extend(&[from.0, to.0].map(|cell| cell.centre(self.cell)));
        }
        line.extend(&[to.1]);
        (line.corners, collides)
    }
}

/// Corners of a line, without those at which it doesn't turn.
#[derive(Default)]
struct Line {
    corners: Vec<Point>,
}

impl Line {
    fn extend(&mut self, points: &[Point]) {
        for &point in points {
            let last = self.corners.last().copied();
            if last.is_some_and(|last| (point - last).norm() < 1e-9) {
                continue;
            }
            if let [.., before, last] = self.corners[..] {
                let (there, on) = (last - before, point - last);
                if there.perp(&on).abs() <= 1e-9 * there.norm() * on.norm() && there.dot(&on) > 0.0 {
                    self.corners.pop();
                }
            }
            self.corners.push(point);
        }
    }
}

/// See [`Sweep::coverage`].
fn coverage(outline: &crate::cspace::Outline, reached: &Grid<bool>, cell: f64, path: &[Point]) -> f64 {
    let nothing = Swath::new(outline, reached.width(), reached.height(), cell);
    let (mut floor, mut swept) = (nothing.clone(), nothing);
    floor.sweep_cells(reached);
    if let &[only] = path {
        swept.sweep(only, only);
    }
    path.windows(2).for_each(|piece| swept.sweep(piece[0], piece[1]));
    floor.add(&swept);
    if floor.count() == 0 { 0.0 } else { swept.count() as f64 / floor.count() as f64 }
}
