//! The stages in order.

use super::{
    CLEARANCE, LinkOrder, OrderCost, SubgoalLink, Sweep, SweepError, SweepSetup,
    contour::ContourWalk,
    cover::Cover,
    crossings::crossings,
    finish::finish,
    linker::{CornerLine, WayLinker},
};
use crate::stage::{Beside, Detours, Subgoal, SubgoalScan, scan_rows, subgoals};
use robovac_core::{
    cspace::Motion,
    floor_plan::{FloorPlan, MAX_RESOLUTION, MIN_RESOLUTION},
    geometry::{Point, Pose},
    grid::{Cell, Direction, Grid},
};
use std::ops::{ControlFlow, RangeInclusive};

/// Accepted distances between scan lines, m.
pub const SCAN_WIDTHS: RangeInclusive<f64> = 0.001..=100.0;
/// Accepted clearances, m.
const CLEARANCES: RangeInclusive<f64> = 0.0..=1.0;
/// Links between two reports.
const REPORT_EVERY: usize = 256;

/// How far the stages are when they end, 0 to 1: the obstacle map, subgoals, links, finish.
const DONE: [f64; 4] = [0.25, 0.3, 0.8, 0.95];

/// Plans a sweep of `plan`. `observe` receives the progress, 0 to 1, and returns whether to continue.
///
/// The obstacle map is made for heading 0 only, which the sweep needs; for the others see
/// [`robovac_core::cspace::ConfigurationSpace`].
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
    let mut found = plan_once(plan, setup, &mut report)?;
    if setup.order != LinkOrder::Nearest {
        let nearest = SweepSetup { order: LinkOrder::Nearest, ..setup.clone() };
        let other = plan_once(plan, &nearest, &mut |_| report(DONE[3]))?;
        found.nearest = Some(OrderCost { crossings: other.crossings, length: other.length });
    }
    report(1.0)?;
    Ok(found)
}

/// Plans in one order.
fn plan_once(
    plan: &FloorPlan,
    setup: &SweepSetup,
    report: &mut dyn FnMut(f64) -> Result<(), SweepError>,
) -> Result<Sweep, SweepError> {
    let scan_width = setup.scan_width.unwrap_or(0.5 * setup.outline.width());
    check(setup, scan_width)?;
    report(0.0)?;
    let outline = if setup.turns { setup.outline.turning_circle() } else { setup.outline.clone() };
    setup.outline.check()?;
    let motion = Motion::new(plan, &outline, setup.clearance.max(CLEARANCE))?;
    let steps = motion.steps(setup.cell)?;
    // Lines are rows of cells. An invalid outline, which has no width, was refused before.
    if scan_width < setup.cell {
        let expected = format!("at most the distance between scan lines, {scan_width:.3} m");
        return Err(SweepError::Value { what: "the side of the obstacle map's cells", value: setup.cell, expected });
    }
    let free = steps.free();
    report(DONE[0])?;
    let reached = steps.reachable(setup.start.map(|start| nearest_free(&free, start, setup.cell)).unwrap_or_default());
    let rows = scan_rows(&reached, scan_width / setup.cell);
    let is_joined = |cell: Cell| steps.is_open(cell, Direction::Right);
    let points = subgoals(&reached, &rows, &steps.obstacles(), is_joined);
    let places = places(&points, &motion, setup.cell);
    if points.is_empty() {
        return Err(SweepError::FitsNowhere { width: outline.width() });
    }
    report(DONE[1])?;
    let detours = Detours::along(&reached, &steps);
    let mut linker = WayLinker { free: &reached, steps: &steps, motion: &motion, detours, cell: setup.cell };
    let stop = |number: usize| (points[number].at, places[number]);
    let beside = if setup.order == LinkOrder::Printed { Beside::First } else { Beside::Never };
    let mut scan = SubgoalScan::new(&points, beside);
    let start = setup.start.and_then(|pose| {
        let begin = nearest_free(&free, pose, setup.cell)?;
        Some((begin, start_place(pose, begin, &motion, setup.cell)))
    });
    // To the first point.
    let (first, mut path) = match start {
        None => (0, CornerLine::default()),
        Some(start) => {
            let first = scan.next(&mut |_, _| false, Err(start.0)).map_or(0, |(first, _)| first);
            let mut path = CornerLine::default();
            path.extend(&linker.way(start, stop(first)).0);
            (first, path)
        }
    };
    scan.track(first);
    path.extend(&[places[first]]);
    let mut told = |share: f64| report(DONE[1] + (DONE[2] - DONE[1]) * share);
    let links = LinkStage { points: &points, places: &places, linker: &mut linker, scan, report: &mut told };
    let links = if setup.order == LinkOrder::Uncrossed { links.uncrossed(first) } else { links.in_order(first) }?;
    let last = links.last().map_or(first, |link| link.to);
    for link in &links {
        path.extend(&link.way);
    }
    report(DONE[2])?;
    let mut cover = Cover::new((&setup.outline, &outline), &reached, &steps, setup.cell, &path.corners);
    let linked_share = cover.share();
    let mut told = |share: f64| report(DONE[2] + (DONE[3] - DONE[2]) * share);
    let finish = finish(&mut linker, &mut cover, &rows, stop(last), &mut told)?;
    let length = |path: &[Point]| path.windows(2).map(|piece| (piece[1] - piece[0]).norm()).sum::<f64>();
    let linked_length = length(&path.corners);
    for way in &finish {
        path.extend(way);
    }
    let collisions = links.iter().filter(|link| link.collides).count();
    let resolved = links.iter().filter(|link| link.collides && !link.way.is_empty()).count();
    let length = length(&path.corners);
    let points = points.iter().zip(&places);
    let placed = |(&Subgoal { contact, line, obstacle, .. }, &at)| Subgoal { at, contact, line, obstacle };
    let subgoals = points.map(placed).collect();
    let ways: Vec<&[Point]> = links.iter().map(|link| link.way.as_slice()).collect();
    let crossings = crossings(&ways);
    Ok(Sweep {
        outline,
        free,
        cell: setup.cell,
        scan_width,
        subgoals,
        links,
        collisions,
        resolved,
        crossings,
        nearest: None,
        linked_share,
        finish,
        path: path.corners,
        length,
        finish_length: length - linked_length,
        coverage: cover.share(),
    })
}

/// Stages 2 and 3: links, with their detours.
struct LinkStage<'a, 'b> {
    points: &'a [Subgoal],
    places: &'a [Point],
    linker: &'a mut WayLinker<'b>,
    scan: SubgoalScan<'a>,
    /// Takes the share done, 0 to 1.
    report: &'a mut dyn FnMut(f64) -> Result<(), SweepError>,
}

impl LinkStage<'_, '_> {
    fn told(&mut self, links: usize) -> Result<(), SweepError> {
        if links.is_multiple_of(REPORT_EVERY) { (self.report)(links as f64 / self.points.len() as f64) } else { Ok(()) }
    }

    fn link(&mut self, from: usize, to: usize) -> SubgoalLink {
        let stop = |number: usize| (self.points[number].at, self.places[number]);
        let (way, collides) = self.linker.way(stop(from), stop(to));
        SubgoalLink { from, to, collides, way }
    }

    /// In the order of the paper, from the first point.
    fn in_order(mut self, first: usize) -> Result<Vec<SubgoalLink>, SweepError> {
        let mut links: Vec<SubgoalLink> = Vec::with_capacity(self.points.len());
        let (motion, places) = (self.linker.motion, self.places);
        let mut is_clear = |from: usize, to: usize| motion.is_free(places[from], places[to]);
        let mut from = first;
        while let Some((to, _)) = self.scan.next(&mut is_clear, Ok(from)) {
            self.scan.track(to);
            self.told(links.len())?;
            links.push(self.link(from, to));
            from = to;
        }
        Ok(links)
    }

    /// Without crossings, from the first point.
    fn uncrossed(mut self, first: usize) -> Result<Vec<SubgoalLink>, SweepError> {
        let mut links: Vec<SubgoalLink> = Vec::with_capacity(self.points.len());
        let (motion, places) = (self.linker.motion, self.places);
        let mut walk = ContourWalk::new(self.points, places, motion);
        let (mut from, mut last) = (first, first);
        loop {
            for (to, way) in walk.walk(from) {
                self.told(links.len())?;
                self.scan.track(to);
                links.push(SubgoalLink { from: last, to, collides: !motion.is_free(places[last], places[to]), way });
                last = to;
            }
            // What no straight move joins to the rest.
            let next = self.scan.next(&mut |_, _| false, Err(self.points[last].at));
            let Some((next, _)) = next else { return Ok(links) };
            self.scan.track(next);
            links.push(self.link(last, next));
            (from, last) = (next, next);
        }
    }
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
    if !CLEARANCES.contains(&setup.clearance) {
        let expected = format!("{} to {} m", CLEARANCES.start(), CLEARANCES.end());
        return refuse("the clearance", setup.clearance, expected);
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

/// The FREE cell that holds a pose or is the nearest to it.
fn nearest_free(free: &Grid<bool>, start: Pose, size: f64) -> Option<Cell> {
    let at = Cell::at(start.position(), size);
    if free.is_set(at) {
        return Some(at);
    }
    let off = |cell: &Cell| (cell.centre(size) - start.position()).norm_squared();
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
