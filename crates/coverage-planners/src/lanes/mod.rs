//! A coverage path in metres: lanes in the free space of a disc, improved as one line.
//!
//! Other planners of the registry walk from cell to cell. This one needs no cells: it knows the exact distance of every
//! straight piece from walls and furniture, lays lanes as far apart as the tool allows, and lets a search shift, drop and
//! reconnect them until the robot needs as little time, or distance, as it can find for the required share of the floor.
//!
//! 1. *Layout*: rooms that stand askew to the others are parts with a direction of their own. Samples of the free space of each are
//!    divided further, into parts with the direction of their longer chords. From one side of a part to the other, a lane is laid
//!    where it's the last that can sweep some floor below it.
//! 2. *Order*: from each lane to the nearest end of one that is left, by shortest ways on a lattice, pulled tight.
//! 3. *Search*: simulated annealing (Kirkpatrick et al. 1983) of the finished line. Moves shift, delete and insert corners, shift
//!    lanes, reach for floor that isn't swept, reverse parts of the path (2-opt, Croes 1958) and carry parts elsewhere (Or-opt,
//!    Or 1976). The objective is the time that the robot takes, with stops and turns, plus a price for floor that isn't swept; the
//!    price is adjusted until the required share is met. It begins with a short descent from the first path of each of several
//!    layouts, and goes on from the best. Small rooms leave time for several such descents.
//!
//! The search counts what is swept on samples; what is reported is measured independently by [`swept_share`].

mod anneal;
mod bound;
mod cost;
mod curves;
mod directions;
mod error;
mod free_space;
mod lattice;
mod layout;
mod moves;
mod nearby;
mod order;
mod planner;
mod raster;
mod row_ends;
mod scan;
mod stroke;
mod tool;
mod trade_off;
mod walker;

pub use bound::MetricBound;
pub use error::LanesError;
pub use free_space::FreeSpace;
pub(crate) use planner::BUILD;
pub use planner::{EXPLAINER, INFO};
pub(crate) use scan::across;
pub use scan::swept_share;
pub(crate) use tool::ToolPlace;

use anneal::{SearchStage, anneal};
use cost::MotionTimes;
use curves::CurveTimes;
use lattice::Lattice;
use layout::{Directions, RoomLayout};
use raster::SweptRaster;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::Point,
    grid::Cell,
    robot::{RobotModel, Tool},
};
use std::ops::ControlFlow;

/// Share of the floor swept in addition where corners will be rounded: so much, or half of what may be missed, can curves leave out.
const SPARE: f64 = 0.006;

/// What a search minimises.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LanesObjective {
    /// The robot's time.
    Time,
    /// The way, m. Stops, turns and curves count a tenth of their time, so that no corner is made for millimetres.
    Distance,
}

impl LanesObjective {
    /// Share that stops, turns and curves count.
    fn stops(self) -> f64 {
        match self {
            Self::Time => 1.0,
            Self::Distance => 0.1,
        }
    }
}

/// What to plan for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LanesSetup {
    /// Share of the reachable floor that is to be swept, 0 to 1.
    pub coverage: f64,
    /// Room between body and obstacles, m, at least; less only if the robot starts nearer to one.
    pub clearance: f64,
    /// By how much neighbouring lanes overlap, m: a robot that is off its path by up to half of it still sweeps the share. Of
    /// floor at walls that only the whole tool reaches, as much may be left as before.
    pub overlap: f64,
    /// Moves tried by the search for every metre of the bound on the length; 0 keeps the first path.
    pub effort: f64,
    /// Seed of the search.
    pub seed: u64,
    /// What the search minimises.
    pub objective: LanesObjective,
    /// Whether corners will be rounded. Then the search counts the time of curves where they fit, and sweeps a little more than is
    /// to be swept, which curves can leave out.
    pub is_rounded: bool,
}

impl Default for LanesSetup {
    fn default() -> Self {
        Self {
            coverage: 0.99,
            clearance: 0.003,
            overlap: 0.0,
            effort: 10_000.0,
            seed: 0,
            objective: LanesObjective::Time,
            is_rounded: false,
        }
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

/// Receives progress every few thousand moves. Returns whether to continue, and how much of a budget of its own, such as
/// seconds, is spent, 0 to 1: the search ends when that or the effort is spent; 0 for none. A search that is stopped returns its
/// best path.
pub type LanesObserver<'a> = &'a mut dyn FnMut(LanesProgress<'_>) -> ControlFlow<(), f64>;

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

/// Plans a path for `robot` from the start of `floor`. Its tool is taken to be a disc, in the middle or elsewhere.
///
/// If the required share can't be reached at this clearance, the path sweeps as much as the search finds. Deterministic for a
/// seed and an effort, unless the observer stops it.
pub fn plan_lanes(
    floor: &ReachableFloor,
    robot: &RobotModel,
    setup: &LanesSetup,
    observer: LanesObserver<'_>,
) -> Result<LanesPlan, LanesError> {
    setup.check(robot)?;
    let asked = setup.coverage;
    let mut setup = LanesSetup { coverage: setup.with_spare(), ..*setup };
    let whole = floor;
    let narrower = (setup.overlap > 0.0).then(|| narrowed(floor, setup.overlap));
    let floor = narrower.as_ref().map_or(floor, |(floor, _)| floor);
    setup.coverage *= narrower.as_ref().map_or(1.0, |&(_, share)| share);
    let setup = &setup;
    // What the whole tool sweeps is told, measured again for every other path.
    let mut told = ShownPath::default();
    let observer: LanesObserver<'_> = &mut |mut progress| {
        if narrower.is_some() {
            if told.path != progress.path {
                told.path = progress.path.to_vec();
                told.coverage = swept_share(whole, progress.path);
            }
            progress.coverage = told.coverage;
        }
        observer(progress)
    };
    let start = floor.start.position();
    let (space, clearance) = free_space(floor, setup.clearance);
    let heading = floor.start.direction();
    let curves = setup.is_rounded.then(|| CurveTimes::of(robot)).flatten();
    let clock = MotionTimes::of(robot, curves);
    let times = clock.clone().with_stops(setup.objective.stops());
    let mut report = |first: &ShownPath| {
        let &ShownPath { ref path, duration_s, coverage } = first;
        observer(LanesProgress { done: 0.0, path, duration_s, coverage })
    };
    // The first path is shown before others are laid.
    let mut first = ShownPath::default();
    if report(&first).is_break() {
        return Err(LanesError::Cancelled);
    }
    let layout = RoomLayout::new(floor, &space);
    let mut lattice = Lattice::new(floor, &space);
    let mut raster = SweptRaster::new(floor, &layout.along());
    let mut starts: Vec<(f64, Vec<Point>)> = Vec::new();
    let mut is_stopped = false;
    for directions in [Directions::Both, Directions::First, Directions::Second, Directions::Fewest] {
        is_stopped = report(&first).is_break();
        if is_stopped {
            break;
        }
        let path = order::in_order(&space, &mut lattice, start, &layout.lanes(&space, directions));
        // Lanes at full speed sweep so much; what is missed takes three times as long.
        let price = 3.0 / (robot.tool_width * robot.cruise_speed);
        let cost = times.path(&path, heading, Some(&space)) + price * raster.left_by(&path);
        if starts.is_empty() {
            let duration_s = clock.path(&path, heading, Some(&space));
            first = ShownPath { path: path.clone(), duration_s, coverage: swept_share(whole, &path) };
        }
        starts.push((cost, path));
    }
    let path = if is_stopped {
        if starts.is_empty() {
            return Err(LanesError::Cancelled);
        }
        first.path
    } else {
        starts.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        let starts: Vec<Vec<Point>> = starts.into_iter().map(|(_, path)| path).collect();
        let search = anneal::LaneSearch { floor, space: &space, times: &times, clock: &clock, heading, setup };
        anneal(&search, &raster, &starts, SearchStage::Trial(0), observer)
    };
    let coverage = swept_share(whole, &path);
    let (length_m, duration_s) = (cost::length(&path), MotionTimes::of(robot, None).path(&path, heading, None));
    Ok(LanesPlan {
        length_m,
        duration_s,
        coverage,
        clearance,
        bound: MetricBound::new(whole, robot, asked),
        excess: MetricBound::new(whole, robot, coverage).excess(length_m, duration_s),
        path,
    })
}

/// A path that is shown while others are laid; empty at first.
#[derive(Default)]
struct ShownPath {
    path: Vec<Point>,
    duration_s: f64,
    coverage: f64,
}

/// The floor for a tool whose disc is narrower by `overlap`, m, and how much of the floor that can reach, as a share of what the
/// whole disc can.
fn narrowed(floor: &ReachableFloor, overlap: f64) -> (ReachableFloor, f64) {
    let mut narrow = floor.clone();
    narrow.tool_radius -= 0.5 * overlap;
    // Discs around all places where the robot can stand, a stroke for each run of a row.
    let mut strokes: Vec<(Point, Point)> = Vec::new();
    let mut last = None;
    for (cell, _) in floor.standing.iter().filter(|&(_, &is_standing)| is_standing) {
        match strokes.last_mut() {
            Some(stroke) if last == Some(Cell::new(cell.x - 1, cell.y)) => stroke.1 = floor.centre(cell),
            _ => strokes.push((floor.centre(cell), floor.centre(cell))),
        }
        last = Some(cell);
    }
    let aside = if let Tool::Disc([x, y]) = floor.tool { x.hypot(y) } else { 0.0 };
    let reach = |floor: &ReachableFloor| {
        let mut lines = scan::FloorLines::new(floor).with_radius(floor.tool_radius + aside);
        lines.share_of(&strokes)
    };
    let share = reach(&narrow) / reach(floor).max(f64::MIN_POSITIVE);
    (narrow, share)
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
    /// The most effort.
    pub const MOST_EFFORT: f64 = 1e9;

    /// The share to sweep with what curves can leave out.
    fn with_spare(&self) -> f64 {
        if self.is_rounded { self.coverage + SPARE.min(0.5 * (1.0 - self.coverage)) } else { self.coverage }
    }

    fn check(&self, robot: &RobotModel) -> Result<(), LanesError> {
        let value = |what, value: f64, is_good: bool, expected| {
            if is_good { Ok(()) } else { Err(LanesError::Value { what, value, expected }) }
        };
        value("coverage", self.coverage, (0.0..=1.0).contains(&self.coverage), "0 to 1")?;
        value("clearance", self.clearance, (0.0..=1.0).contains(&self.clearance), "0 to 1 m")?;
        let is_narrower = (0.0..0.5 * robot.tool_width).contains(&self.overlap);
        value("overlap", self.overlap, is_narrower, "0 m to less than half the tool's width")?;
        value("effort", self.effort, (0.0..=Self::MOST_EFFORT).contains(&self.effort), "0 to 1,000,000,000")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::DriveMetrics;
    use robovac_core::{
        floor_plan::{FloorPlan, Object, generate::random_flat},
        geometry::{Pose, Vector, nearest_on_segment},
        robot::model,
    };

    const EFFORT: f64 = 60.0;

    fn floor(plan: &FloorPlan) -> ReachableFloor {
        ReachableFloor::new(plan, model("roomba600").unwrap(), None).unwrap()
    }

    fn plan(floor: &ReachableFloor, setup: &LanesSetup) -> LanesPlan {
        plan_lanes(floor, model("roomba600").unwrap(), setup, &mut |_| ControlFlow::Continue(0.0)).unwrap()
    }

    /// Swept share by samples 13 mm apart on a raster of its own, askew to plan, planner and measure.
    fn sampled_share(floor: &ReachableFloor, path: &[Point]) -> f64 {
        let turn = scan::rotation(0.23);
        let size = floor.floor.width().max(floor.floor.height()) as f64 * floor.resolution;
        let count = (1.5 * size / 0.013) as i32;
        let (mut all, mut swept) = (0, 0);
        for i in -count..count {
            for j in -count..count {
                let (x, y) = (f64::from(i) * 0.013, f64::from(j) * 0.013);
                let at = Point::new(turn.x * x - turn.y * y, turn.y * x + turn.x * y);
                if floor.floor.is_set(floor.cell_at(at)) {
                    let near =
                        |pair: &[Point]| (nearest_on_segment(pair[0], pair[1], at) - at).norm() <= floor.tool_radius;
                    all += 1;
                    swept += u32::from(path.windows(2).any(near));
                }
            }
        }
        f64::from(swept) / f64::from(all)
    }

    /// The room, now with a slanted sofa, a leg and stairs.
    fn with_objects(mut plan: FloorPlan) -> FloorPlan {
        let outline = |corners: [[f64; 2]; 4]| corners.map(|[x, y]| Point::new(x, y)).to_vec();
        let (x, y) = (plan.width_m(), plan.height_m());
        let sofa = outline([[1.2, 1.3], [1.9, 1.0], [2.1, 1.4], [1.4, 1.75]]);
        let stairs = outline([[x - 0.6, y - 0.5], [x, y - 0.5], [x, y], [x - 0.6, y]]);
        plan.objects.push(Object::Furniture { outline: sofa });
        plan.objects.push(Object::Leg { at: Point::new(0.9, 1.9), radius: 0.02 });
        plan.objects.push(Object::DropOff { outline: stairs });
        plan
    }

    // slow: the contract over several rooms, each with its own search
    #[test]
    fn paths_keep_their_distance_and_sweep_what_they_claim() {
        for seed in 0..4 {
            let room = random_flat(1, 1, seed);
            let room = if seed % 2 == 0 { room } else { with_objects(room) };
            let floor = floor(&room);
            let setup = LanesSetup { coverage: 0.97, effort: EFFORT, seed, ..LanesSetup::default() };
            let found = plan(&floor, &setup);
            let space = FreeSpace::new(floor.limits(), 0.0);
            for piece in found.path.windows(2) {
                let room = space.distance(piece[0], piece[1]) - floor.limits().body_radius;
                assert!(room >= found.clearance - 1e-6, "seed {seed}: {} to {} has {room} m", piece[0], piece[1]);
            }
            assert_eq!(found.path[0], floor.start.position());
            assert!((found.clearance - 0.003).abs() < 1e-12);
            let sampled = sampled_share(&floor, &found.path);
            assert!(
                (found.coverage - sampled).abs() < 0.002,
                "seed {seed}: {} claimed, {sampled} found",
                found.coverage
            );
            assert!(found.coverage >= setup.coverage, "seed {seed}: {}", found.coverage);
            assert!(found.excess[0] > 0.0 && found.excess[1] > 0.0, "no path beats its bound: {:?}", found.excess);
            assert!(found.bound.length_m < found.length_m && found.bound.duration_s < found.duration_s);
            let first = plan(&floor, &LanesSetup { effort: 0.0, ..setup });
            assert!(found.duration_s < first.duration_s || first.coverage < setup.coverage, "the search helps");
            if seed == 0 {
                assert_eq!(plan(&floor, &setup), found, "same seed, same path");
                assert_ne!(plan(&floor, &LanesSetup { seed: 9, ..setup }).path, found.path);
            }
        }
    }

    #[test]
    fn the_least_distance_is_shorter_and_takes_longer_than_the_least_time() {
        let mut sums = [[0.0; 2]; 2];
        for seed in 0..3 {
            let floor = floor(&random_flat(1, 1, seed));
            let objectives = [LanesObjective::Time, LanesObjective::Distance];
            for (sum, objective) in sums.iter_mut().zip(objectives) {
                let setup =
                    LanesSetup { coverage: 0.97, effort: 20.0 * EFFORT, seed, objective, ..LanesSetup::default() };
                let mut told = 0.0;
                let observer: LanesObserver<'_> = &mut |progress| {
                    told = progress.duration_s;
                    ControlFlow::Continue(0.0)
                };
                let found = plan_lanes(&floor, model("roomba600").unwrap(), &setup, observer).unwrap();
                assert!(found.coverage >= 0.97, "seed {seed}, {objective:?}: {}", found.coverage);
                assert!((told - found.duration_s).abs() < 1e-6, "its time is told, not what is minimised");
                *sum = [sum[0] + found.length_m, sum[1] + found.duration_s];
            }
        }
        let [[metres, seconds], [least_metres, more_seconds]] = sums;
        println!("{metres:.1} m in {seconds:.0} s, {least_metres:.1} m in {more_seconds:.0} s");
        assert!(least_metres < 0.98 * metres && more_seconds > seconds, "{sums:?}");
    }

    #[test]
    fn a_tool_beside_the_middle_sweeps_what_is_required() {
        let room = random_flat(1, 1, 4);
        for at in [[0.08, 0.0], [-0.03, 0.05]] {
            let robot = RobotModel { tool: Tool::Disc(at), ..model("roomba600").unwrap().clone() };
            let floor = ReachableFloor::new(&room, &robot, None).unwrap();
            let setup = LanesSetup { coverage: 0.85, effort: 10.0 * EFFORT, ..LanesSetup::default() };
            let found = plan_lanes(&floor, &robot, &setup, &mut |_| ControlFlow::Continue(0.0)).unwrap();
            let driven = DriveMetrics::of(&floor, &robot, &found.path);
            assert!(found.coverage >= 0.85, "{at:?}: {}", found.coverage);
            assert!((driven.coverage - found.coverage).abs() < 0.02, "{at:?}: {} {}", driven.coverage, found.coverage);
            assert!(found.bound.length_m > 0.0 && found.excess.iter().all(|&above| above > 0.0), "{:?}", found.excess);
        }
    }

    #[test]
    fn a_search_that_is_stopped_returns_its_best_path() {
        let floor = floor(&random_flat(1, 1, 5));
        let robot = model("roomba600").unwrap();
        let setup = LanesSetup { effort: LanesSetup::MOST_EFFORT, ..LanesSetup::default() };
        for stop in 0..9 {
            let mut reports = 0;
            let mut last = Vec::new();
            let result = plan_lanes(&floor, robot, &setup, &mut |progress| {
                reports += 1;
                last = progress.path.to_vec();
                if reports > stop { ControlFlow::Break(()) } else { ControlFlow::Continue(0.0) }
            });
            assert_eq!(reports, stop + 1, "it isn't asked again");
            match result {
                Ok(plan) => assert_eq!(plan.path, last),
                Err(error) => assert!(error == LanesError::Cancelled && last.is_empty()),
            }
        }
        // The caller's own budget ends it, too.
        let mut reports = 0.0;
        let result = plan_lanes(&floor, robot, &setup, &mut |_| {
            reports += 1.0;
            ControlFlow::Continue(reports / 12.0)
        });
        assert!(result.is_ok());
    }

    #[test]
    fn more_than_can_be_swept_is_swept_as_far_as_can_be() {
        let floor = floor(&random_flat(1, 1, 2));
        let setup = LanesSetup { coverage: 1.0, clearance: 0.05, effort: 10.0 * EFFORT, ..LanesSetup::default() };
        let found = plan(&floor, &setup);
        let first = plan(&floor, &LanesSetup { effort: 0.0, ..setup });
        assert!(found.coverage < 1.0 && found.coverage > first.coverage, "{} {}", found.coverage, first.coverage);
    }

    #[test]
    fn a_start_near_a_wall_lowers_the_clearance() {
        let mut room = random_flat(1, 1, 1);
        room.start = Some(Pose::new(0.15 + 0.1775, 0.45, 0.0));
        let floor = floor(&room);
        let has = floor.start.x - 0.15 - floor.limits().body_radius;
        let found = plan(&floor, &LanesSetup { clearance: 0.02, effort: 0.0, ..LanesSetup::default() });
        assert!((found.clearance - has).abs() < 1e-9 && has < 0.02, "{} {has}", found.clearance);
        assert!(found.path.len() > 10);
    }

    #[test]
    fn a_room_askew_is_swept_along_its_walls() {
        for degrees in [10.0, 35.0, 60.0_f64] {
            let (floor, middle) = directions::tests::rooms_askew(degrees);
            let first = plan(&floor, &LanesSetup { effort: 0.0, ..LanesSetup::default() });
            for (at, degrees) in [(middle, degrees), (Point::new(3.2, 3.5), 0.0)] {
                let (mut all, mut along) = (0.0, 0.0);
                for pair in first.path.windows(2) {
                    let way = pair[1] - pair[0];
                    // Links are shorter.
                    if way.norm() > 0.5 && (pair[0] + way * 0.5 - at).norm() < 2.2 {
                        let off = directions::apart(robovac_core::math::atan2(way.y, way.x), degrees.to_radians());
                        all += way.norm();
                        along += if off.to_degrees() < 3.0 { way.norm() } else { 0.0 };
                    }
                }
                assert!(all > 60.0 && along > 0.9 * all, "{degrees} degrees: {along} of {all} m");
            }
        }
    }

    #[test]
    fn lanes_that_overlap_sweep_the_share_when_the_robot_drifts() {
        let floor = floor(&random_flat(1, 1, 6));
        let (_, reached) = narrowed(&floor, 0.02);
        assert!(reached < 0.999 && reached > 0.95, "only floor along walls isn't reached: {reached}");
        let found = [0.0, 0.02].map(|overlap| {
            let mut told = 0.0;
            let setup = LanesSetup { coverage: 0.98, overlap, effort: 20.0 * EFFORT, ..LanesSetup::default() };
            let observer: LanesObserver<'_> = &mut |progress| {
                told = progress.coverage;
                ControlFlow::Continue(0.0)
            };
            let found = plan_lanes(&floor, model("roomba600").unwrap(), &setup, observer).unwrap();
            assert!((told - found.coverage).abs() < 1e-12 && found.coverage >= 0.98, "{told} {}", found.coverage);
            found
        });
        // Always to the left of its way, or to the right: neighbouring lanes come nearer to or farther from each other.
        let drifted = |path: &[Point], aside: f64| {
            let strokes: Vec<(Point, Point)> = path
                .windows(2)
                .map(|pair| {
                    let along = (pair[1] - pair[0]).try_normalize(1e-9).unwrap_or_default();
                    let by = Vector::new(-along.y, along.x) * aside;
                    (pair[0] + by, pair[1] + by)
                })
                .collect();
            scan::FloorLines::new(&floor).share_of(&strokes)
        };
        for aside in [-0.0095, -0.005, 0.005, 0.0095] {
            let [without, with] = [0, 1].map(|i| drifted(&found[i].path, aside));
            assert!(with >= 0.98, "{aside} m aside: {with}");
            assert!(aside.abs() < 0.009 || without < 0.97, "{aside} m aside: {without}");
        }
        assert!(found[1].length_m > found[0].length_m);
    }

    #[test]
    fn values_out_of_range_are_named() {
        let floor = floor(&random_flat(1, 1, 1));
        let bad = [
            LanesSetup { coverage: 99.0, ..LanesSetup::default() },
            LanesSetup { clearance: -0.1, ..LanesSetup::default() },
            LanesSetup { effort: f64::NAN, ..LanesSetup::default() },
            LanesSetup { overlap: -0.01, ..LanesSetup::default() },
            LanesSetup { overlap: 0.085, ..LanesSetup::default() },
        ];
        for (setup, name) in bad.iter().zip(["coverage", "clearance", "effort", "overlap", "overlap"]) {
            let result = plan_lanes(&floor, model("roomba600").unwrap(), setup, &mut |_| ControlFlow::Continue(0.0));
            assert!(result.unwrap_err().to_string().contains(name));
        }
    }
}
