//! The stages in order.

use super::{
    SubgoalLink, Sweep, SweepError, SweepSetup,
    cover::Cover,
    finish::finish,
    linker::{CornerLine, WayLinker},
};
use crate::stage::{Beside, Detours, Subgoal, SubgoalScan, scan_rows, subgoals};
use robovac_core::{
    cspace::{ConfigurationSpace, Motion, ObstacleRuns},
    floor_plan::{FloorPlan, MAX_RESOLUTION, MIN_RESOLUTION},
    geometry::{Point, Pose},
    grid::{Cell, Grid, largest_part, reachable},
};
use std::ops::{ControlFlow, RangeInclusive};

/// Accepted distances between scan lines, m.
pub const SCAN_WIDTHS: RangeInclusive<f64> = 0.001..=100.0;
/// Links between two reports.
const REPORT_EVERY: usize = 256;

/// How far the stages are when they end, 0 to 1: the obstacle map, subgoals, links, finish.
const DONE: [f64; 4] = [0.25, 0.3, 0.8, 0.95];

/// Plans a sweep of `plan`. `observe` receives the progress, 0 to 1, and returns whether to continue.
///
/// The obstacle map is made for heading 0 only, which the sweep needs; for the others see [`ConfigurationSpace`].
/// Without a start the robot begins at the first subgoal point of the largest part of the room, as the paper's does
/// (section 4). With one that isn't FREE it begins in the nearest cell that is. Unreachable subgoals are left out.
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
    // Lines are rows of cells. An invalid outline, which has no width, was refused before.
    if scan_width < setup.cell {
        let expected = format!("at most the distance between scan lines, {scan_width:.3} m");
        return Err(SweepError::Value { what: "the side of the obstacle map's cells", value: setup.cell, expected });
    }
    let motion = Motion::new(plan, outline)?;
    let free = map.slice(0);
    report(DONE[0])?;
    let fits_nowhere = SweepError::FitsNowhere { width: outline.width() };
    let begin = begin(&free, setup).ok_or(fits_nowhere.clone())?;
    let reached = reachable(&free, begin);
    let rows = scan_rows(&reached, scan_width / setup.cell);
    let points = subgoals(&reached, &rows, &ObstacleRuns::of(&free));
    let places = places(&points, &motion, setup.cell);
    if points.is_empty() {
        return Err(fits_nowhere);
    }
    report(DONE[1])?;
    let mut linker = WayLinker { free: &reached, motion: &motion, detours: Detours::new(&reached), cell: setup.cell };
    let stop = |number: usize| (points[number].at, places[number]);
    let mut scan = SubgoalScan::new(&points, Beside::Never);
    let start = setup.start.map(|pose| start_place(pose, begin, &motion, setup.cell));
    let mut path = CornerLine::default();
    let mut links: Vec<SubgoalLink> = Vec::with_capacity(points.len());
    let first = start.map_or(Ok(0), |_| Err(begin));
    if first.is_ok() {
        scan.track(0);
        path.extend(&[places[0]]);
    }
    let last = scan.link_all(&reached, first, |from, to, _| {
        let Ok(from) = from else {
            path.extend(&linker.way((begin, start.unwrap_or(places[to])), stop(to)).0);
            path.extend(&[places[to]]);
            return Ok(());
        };
        if links.len().is_multiple_of(REPORT_EVERY) {
            report(DONE[1] + (DONE[2] - DONE[1]) * links.len() as f64 / points.len() as f64)?;
        }
        let (way, collides) = linker.way(stop(from), stop(to));
        path.extend(&way);
        links.push(SubgoalLink { from, to, collides, way });
        Ok::<(), SweepError>(())
    })?;
    report(DONE[2])?;
    let mut cover = Cover::new(outline, &reached, setup.cell, &path.corners);
    let linked_share = cover.share();
    let mut told = |share: f64| report(DONE[2] + (DONE[3] - DONE[2]) * share);
    let finish = finish(&mut linker, &mut cover, &rows, stop(last.unwrap_or(0)), &mut told)?;
    for way in &finish {
        path.extend(way);
    }
    let collisions = links.iter().filter(|link| link.collides).count();
    let resolved = links.iter().filter(|link| link.collides && !link.way.is_empty()).count();
    let length = path.corners.windows(2).map(|piece| (piece[1] - piece[0]).norm()).sum();
    let points = points.iter().zip(&places);
    let placed = |(&Subgoal { contact, line, obstacle, .. }, &at)| Subgoal { at, contact, line, obstacle };
    let subgoals = points.map(placed).collect();
    report(1.0)?;
    Ok(Sweep {
        free,
        cell: setup.cell,
        scan_width,
        subgoals,
        links,
        collisions,
        resolved,
        linked_share,
        finish,
        path: path.corners,
        length,
        coverage: cover.share(),
    })
}

/// Checks the ranges of all numbers.
fn check(setup: &SweepSetup, scan_width: f64) -> Result<(), SweepError> {
    let refuse = |what: &'static str, value: f64, expected: String| Err(SweepError::Value { what, value, expected });
    if !(MIN_RESOLUTION..=MAX_RESOLUTION).contains(&setup.cell) {
        let expected = format!("{MIN_RESOLUTION} to {MAX_RESOLUTION} m");
        return refuse("the side of the obstacle map's cells", setup.cell, expected);
    }
    // The distance derived from an invalid outline is reported with the outline.
    if setup.scan_width.is_some() && !SCAN_WIDTHS.contains(&scan_width) {
        let expected = format!("{} to {} m", SCAN_WIDTHS.start(), SCAN_WIDTHS.end());
        return refuse("the distance between scan lines", scan_width, expected);
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

/// The start itself if the body fits there and can move to the cell's centre; otherwise the centre.
fn start_place(start: Pose, begin: Cell, motion: &Motion, cell: f64) -> Point {
    let (place, centre) = (start.position(), begin.centre(cell));
    if Cell::at(place, cell) == begin && motion.is_free(place, centre) { place } else { centre }
}

/// The position of the body's origin at contact: less than a cell beyond the centre of the last FREE cell of the run.
fn places(points: &[Subgoal], motion: &Motion, cell: f64) -> Vec<Point> {
    let mut blocked = (None, Vec::new());
    let place = |point: &Subgoal| {
        let centre = point.at.centre(cell);
        if blocked.0 != Some(point.line) {
            blocked = (Some(point.line), motion.blocked(centre.y));
        }
        let next = blocked.1.partition_point(|part| part.0 < centre.x);
        let found = if point.contact.is_left() {
            next.checked_sub(1).and_then(|last| blocked.1.get(last)).map(|part| part.1)
        } else {
            blocked.1.get(next).map(|part| part.0)
        };
        // A nanometre off, so that rounding doesn't put it inside.
        let found = found.map(|x| if point.contact.is_left() { x + 1e-9 } else { x - 1e-9 });
        // Never farther than the FULL cell's centre, nor on the wrong side.
        let x = found.filter(|x| (x - centre.x).abs() <= cell).unwrap_or(centre.x);
        let is_on = if point.contact.is_left() { x <= centre.x } else { x >= centre.x };
        Point::new(if is_on { x } else { centre.x }, centre.y)
    };
    points.iter().map(place).collect()
}
