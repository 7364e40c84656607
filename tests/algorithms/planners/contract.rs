//! What every planner of the registry that walks from cell to cell must do in every room; [`super::in_metres`] has the others.

use super::support::{LARGE, Scenario, build, scenarios, walking};
use coverage_planners::{
    CoverageJob, CoveragePath, PlanContext, PlanError, PlannerInfo, ProgressReport, SLOW_CELLS, metrics::WalkMetrics,
};
use robovac_core::{
    grid::{Cell, Direction, from_picture},
    registry::{ParamKind, ParamValue, Params},
};
use std::ops::ControlFlow;

fn describe(info: &PlannerInfo, scenario: &Scenario, job: &CoverageJob) -> String {
    format!("{} in {} from {} facing {:?}", info.id, scenario.name, job.start, job.heading)
}

/// Free cells up to which planners that aren't fast are tried in every room; beyond that only in the hall of [`SLOW_CELLS`].
const SLOW_IN_ALL: usize = 6_000;

/// Whether a planner is tried in a room.
fn suits(info: &PlannerInfo, scenario: &Scenario, job: &CoverageJob) -> bool {
    info.claims.fast
        || job.cells() <= SLOW_IN_ALL
        || scenario.free.len() == SLOW_CELLS && scenario.name.contains("hall")
}

/// Plans with those planners in every room, from every `step`th start and heading.
fn walks_hold(planners: &[&PlannerInfo], step: usize) {
    // A million cells, as one of the shared grids has, are the soak's.
    for scenario in scenarios().iter().filter(|s| step == 1 || s.free.len() < 100_000) {
        let jobs = || scenario.jobs().step_by(step).enumerate();
        for (info, (number, job)) in planners.iter().flat_map(|&info| jobs().map(move |job| (info, job))) {
            if !suits(info, scenario, &job) {
                continue;
            }
            // With full effort once in each room.
            let size = if number == 0 { job.cells() } else { usize::MAX };
            let path = build(info, size).plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
            let what = describe(info, scenario, &job);
            path.check(&job).unwrap_or_else(|error| panic!("{what}: {error}"));
            let metrics = WalkMetrics::of(&job, &path);
            if info.claims.complete {
                assert_eq!(metrics.visited_cells, metrics.reachable_cells, "{what}");
            }
        }
    }
}

// slow: the contract, every other planner in every room; two tests, for two cores
#[test]
fn walks_can_be_driven_and_cover_what_they_claim() {
    // From every start, with some of the headings.
    walks_hold(&walking().step_by(2).collect::<Vec<_>>(), 3);
}

// slow: the contract, the other planners in every room
#[test]
fn walks_of_the_other_planners_can_be_driven_and_cover_what_they_claim() {
    walks_hold(&walking().skip(1).step_by(2).collect::<Vec<_>>(), 3);
}

#[test]
#[ignore = "soak: every start with every heading"]
fn walks_from_everywhere_can_be_driven_and_cover_what_they_claim() {
    walks_hold(&walking().collect::<Vec<_>>(), 1);
}

/// In rooms whose whole grids have fewer than `most` cells, with full effort up to `full_effort` cells.
fn seed_determines_walks(most: usize, full_effort: usize) {
    for scenario in scenarios().iter().filter(|s| s.free.len() < most) {
        for (info, job) in walking().filter_map(|info| Some((info, scenario.jobs().next()?))) {
            let what = describe(info, scenario, &job);
            let size = if job.cells() <= full_effort { 0 } else { usize::MAX };
            let plan = |seed| build(info, size).plan(&job, &mut PlanContext::new(seed)).expect("nobody cancels");
            // Whose walk doesn't depend on the seed is held to that.
            let other = if info.claims.deterministic { 2 } else { 1 };
            assert_eq!(plan(1), plan(other), "{what}");
        }
    }
}

// slow: every planner twice in every room but the large ones
#[test]
fn seed_determines_the_walk() {
    seed_determines_walks(600, 40);
}

#[test]
#[ignore = "soak: larger rooms and full effort"]
fn seed_determines_the_walk_of_full_effort() {
    seed_determines_walks(2_000, LARGE);
}

/// In rooms whose whole grids have fewer than so many cells.
fn every_choice_holds(most: usize) {
    let rooms = scenarios();
    for info in walking() {
        for spec in info.params {
            let values: Vec<ParamValue> = match spec.kind {
                ParamKind::Number { min, max, .. } => vec![ParamValue::Number(min), ParamValue::Number(max)],
                ParamKind::Choice { options } => options.iter().map(|o| ParamValue::Choice(o.0.to_owned())).collect(),
                ParamKind::Flag { .. } => vec![ParamValue::Flag(false), ParamValue::Flag(true)],
            };
            for value in values {
                let params = Params::checked(info.params, [(spec.id, value.clone())]).expect("the value is in range");
                for scenario in rooms.iter().filter(|s| s.free.len() < most) {
                    let Some(job) = scenario.jobs().next() else { continue };
                    let planner = info.build(&params);
                    let path = planner.plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
                    let what = format!("{} with {} = {value}", describe(info, scenario, &job), spec.id);
                    path.check(&job).unwrap_or_else(|error| panic!("{what}: {error}"));
                    let metrics = WalkMetrics::of(&job, &path);
                    let is_claimed = info.claims.complete && planner.is_complete();
                    assert!(!is_claimed || metrics.visited_cells == metrics.reachable_cells, "{what}");
                }
            }
        }
    }
}

// slow: a walk for each value of each parameter
#[test]
fn every_choice_of_every_parameter_works() {
    every_choice_holds(56);
}

#[test]
#[ignore = "soak: full effort in larger rooms"]
fn every_choice_of_every_parameter_works_in_larger_rooms() {
    every_choice_holds(LARGE);
}

/// Rooms of a cell or a line of them, and start in a corner that diagonal neighbours don't lead out of.
const TINY: [&str; 6] = [".", "..", ".\n.", ".............", ".\n.\n.\n.\n.\n.", ".#..\n#...\n...."];

#[test]
fn tiny_rooms_and_impossible_times_are_planned() {
    let times = [0.0, 1.0, 1e-300, 1e300, -1.0, f64::INFINITY, f64::NAN];
    for picture in TINY {
        let free = from_picture(picture, |c| c == '.').expect("it is a rectangle");
        let top_left = Cell::new(0, free.height() as i32 - 1);
        for heading in Direction::ALL {
            let job = CoverageJob::new(&free, top_left, heading).expect("the start is free");
            for (step_s, turn_s) in times.into_iter().flat_map(|step_s| times.map(|turn_s| (step_s, turn_s))) {
                let job = CoverageJob { step_s, turn_s, ..job.clone() };
                for info in walking() {
                    let what = format!("{} with {step_s} s and {turn_s} s facing {heading:?} in\n{picture}", info.id);
                    let path = build(info, LARGE + 1).plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
                    path.check(&job).unwrap_or_else(|error| panic!("{what}: {error}"));
                    let metrics = WalkMetrics::of(&job, &path);
                    assert_eq!(metrics.visited_cells, metrics.reachable_cells, "{what}");
                }
            }
        }
    }
}

#[test]
fn cancelling_is_honoured_at_the_first_checkpoint() {
    let free = robovac_core::floor_plan::generate::random_hall(200, 200, 1);
    let job = CoverageJob::new(&free, Cell::new(0, 0), Direction::Right).expect("the start is free");
    for info in walking() {
        let mut calls = 0;
        let mut observer = |_: ProgressReport<'_>| {
            calls += 1;
            ControlFlow::Break(())
        };
        let result = build(info, 0).plan(&job, &mut PlanContext::observed(1, &mut observer));
        assert_eq!(result, Err(PlanError::Cancelled), "{}", info.id);
        assert_eq!(calls, 1, "{} goes on after having been cancelled", info.id);
    }
}

// slow: every planner with full effort, twice, in a hall
#[test]
fn reports_show_progress_and_walks_that_can_be_driven() {
    for info in walking() {
        let side = if info.claims.fast { 200 } else { 40 };
        let free = robovac_core::floor_plan::generate::random_hall(side, side, 1);
        let job = CoverageJob::new(&free, Cell::new(0, 0), Direction::Right).expect("the start is free");
        let (mut calls, mut last) = (0, 0.0);
        let mut observer = |ProgressReport { done, walk: so_far, .. }: ProgressReport<'_>| {
            calls += 1;
            assert!((last..=1.0).contains(&done), "{} reports {done} after {last}", info.id);
            last = done;
            if !so_far.is_empty() {
                let walk = CoveragePath::walk(so_far.to_vec());
                walk.check(&job).unwrap_or_else(|error| panic!("{} reports a walk: {error}", info.id));
            }
            ControlFlow::Continue(())
        };
        let observed = build(info, 0).plan(&job, &mut PlanContext::observed(1, &mut observer)).expect("nobody cancels");
        assert!(calls >= 3, "{} reports {calls} times", info.id);
        let alone = build(info, 0).plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
        assert!(observed == alone, "{} walks otherwise when watched", info.id);
    }
}
