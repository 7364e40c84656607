//! A coverage path in metres: lanes in the free space of a disc, improved as one line.
//!
//! The planners of the registry walk from cell to cell. This one needs no cells: it knows the exact distance of every
//! straight piece from walls and furniture, lays lanes as far apart as the tool allows, and lets a search shift, drop and
//! reconnect them until the robot needs as little time as it can find for the required share of the floor.
//!
//! 1. *Layout*: samples of the free space are divided into parts, each with the direction of its longer chords. From one side
//!    of a part to the other, a lane is laid where it's the last that can sweep some floor below it.
//! 2. *Order*: from each lane to the nearest end of one that is left, by shortest ways on a lattice, pulled tight.
//! 3. *Search*: simulated annealing (Kirkpatrick et al. 1983) of the finished line. Moves shift, delete and insert corners, shift
//!    lanes, reach for floor that isn't swept, reverse parts of the path (2-opt, Croes 1958) and carry parts elsewhere (Or-opt,
//!    Or 1976). The objective is the time that the robot takes, with stops and turns, plus a price for floor that isn't swept; the
//!    price is adjusted until the required share is met.
//!
//! The search counts what is swept on samples; what is reported is measured independently by [`swept_share`].

mod anneal;
mod bound;
mod cost;
mod error;
mod free_space;
mod lattice;
mod layout;
mod moves;
mod nearby;
mod order;
mod raster;
mod scan;

pub use bound::MetricBound;
pub use error::LanesError;
pub use free_space::FreeSpace;
pub use scan::swept_share;

use anneal::anneal;
use cost::MotionTimes;
use lattice::Lattice;
use layout::{Directions, Layout};
use raster::SweptRaster;
use robovac_core::{coverage::ReachableFloor, geometry::Point, robot::RobotModel};
use std::ops::ControlFlow;

/// What to plan for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LanesSetup {
    /// Share of the reachable floor that is to be swept, 0 to 1.
    pub coverage: f64,
    /// Room between body and obstacles, m, at least; less only if the robot starts nearer to one.
    pub clearance: f64,
    /// Moves tried by the search for every metre of the bound on the length; 0 keeps the first path.
    pub effort: f64,
    /// Seed of the search.
    pub seed: u64,
}

impl Default for LanesSetup {
    fn default() -> Self {
        Self { coverage: 0.99, clearance: 0.003, effort: 10_000.0, seed: 0 }
    }
}

/// The best path so far.
#[derive(Debug, Clone, Copy)]
pub struct LanesProgress<'a> {
    /// Share of the search that is done, 0 to 1.
    pub done: f64,
    /// The best path so far, corners in metres.
    pub path: &'a [Point],
    /// Its time by the robot's motion model, s.
    pub duration_s: f64,
    /// The share of the floor that it sweeps, 0 to 1.
    pub coverage: f64,
}

/// Receives progress every few thousand moves; returns whether to continue. A search that is stopped returns its best path.
pub type LanesObserver<'a> = &'a mut dyn FnMut(LanesProgress<'_>) -> ControlFlow<()>;

/// A path with its numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct LanesPlan {
    /// Corners from the start on, m.
    pub path: Vec<Point>,
    /// Length, m.
    pub length_m: f64,
    /// Time by the robot's motion model, with stops and turns on the spot, s.
    pub duration_s: f64,
    /// The share of the reachable floor that it sweeps, 0 to 1, by [`swept_share`].
    pub coverage: f64,
    /// Room between body and obstacles, m.
    pub clearance: f64,
    /// Bounds on any path that sweeps the required share.
    pub bound: MetricBound,
    /// How far length and time exceed the bounds on a path that sweeps as much as this one, as shares.
    pub excess: [f64; 2],
}

/// Plans a path for `robot` from the start of `floor`.
///
/// If the required share can't be reached at this clearance, the path sweeps as much as the search finds. Deterministic for a
/// seed and an effort, unless the observer stops it.
pub fn plan_lanes(
    floor: &ReachableFloor,
    robot: &RobotModel,
    setup: &LanesSetup,
    observer: LanesObserver<'_>,
) -> Result<LanesPlan, LanesError> {
    setup.check()?;
    let start = floor.start.position();
    let (space, clearance) = free_space(floor, setup.clearance);
    let heading = floor.start.direction();
    let times = MotionTimes::of(robot);
    let cancelled = |flow: ControlFlow<()>| if flow.is_break() { Err(LanesError::Cancelled) } else { Ok(()) };
    let mut report = |done: f64| observer(LanesProgress { done, path: &[], duration_s: 0.0, coverage: 0.0 });
    cancelled(report(0.0))?;
    let layout = Layout::new(floor, &space);
    let mut lattice = Lattice::new(floor, &space);
    let mut raster = SweptRaster::new(floor);
    let mut best: Option<(f64, Vec<Point>)> = None;
    for directions in [Directions::Both, Directions::First, Directions::Second] {
        cancelled(report(0.0))?;
        let path = order::in_order(&space, &mut lattice, start, &layout.lanes(directions));
        // Lanes at full speed sweep so much; what is missed takes three times as long.
        let price = 3.0 / (robot.tool_width * robot.cruise_speed);
        let cost = times.path(&path, heading) + price * raster.left_by(&path);
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, path));
        }
    }
    let first = best.map_or_else(|| vec![start], |(_, path)| path);
    let search = anneal::Search { floor, space: &space, times, heading, setup };
    let path = anneal(&search, raster, first, observer);
    let coverage = swept_share(floor, &path);
    let (length_m, duration_s) = (cost::length(&path), times.path(&path, heading));
    Ok(LanesPlan {
        length_m,
        duration_s,
        coverage,
        clearance,
        bound: MetricBound::new(floor, robot, setup.coverage),
        excess: MetricBound::new(floor, robot, coverage).excess(length_m, duration_s),
        path,
    })
}

/// The free space at a clearance, or at the most that the start has.
fn free_space(floor: &ReachableFloor, clearance: f64) -> (FreeSpace, f64) {
    let limits = floor.limits();
    let start = floor.start.position();
    let has = limits.nearest(start, limits.body_radius + clearance).map_or(clearance, |(_, d)| d - limits.body_radius);
    let clearance = clearance.min(has).max(0.0);
    (FreeSpace::new(limits, limits.body_radius + clearance), clearance)
}

impl LanesSetup {
    fn check(&self) -> Result<(), LanesError> {
        let value = |what, value: f64, is_good: bool, expected| {
            if is_good { Ok(()) } else { Err(LanesError::Value { what, value, expected }) }
        };
        value("coverage", self.coverage, (0.0..=1.0).contains(&self.coverage), "0 to 1")?;
        value("clearance", self.clearance, (0.0..=1.0).contains(&self.clearance), "0 to 1 m")?;
        value("effort", self.effort, (0.0..=1e9).contains(&self.effort), "0 to 1,000,000,000")
    }
}
