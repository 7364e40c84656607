//! What every planner of the registry that plans in metres must do: no piece of its path touches anything, by exact
//! distances; the seed determines the path; it can be watched and cancelled.

use super::support::build;
use coverage_planners::{
    CoverageJob, CoveragePath, JobPlace, PLANNERS, PathError, PlanContext, PlanError, PlannerInfo, ProgressReport,
    lanes::{FreeSpace, swept_share},
};
use robovac_core::{
    floor_plan::{FloorPlan, SourceFile, generate::random_flat, load, room},
    geometry::{Point, Pose},
    registry::{ParamKind, ParamValue, Params},
    robot::model,
};
use robovac_sim::experiment::planning::{RoomSetup, choose_robot};
use std::ops::ControlFlow;

fn planners() -> impl Iterator<Item = &'static PlannerInfo> {
    PLANNERS.iter().copied().filter(|info| info.is_in_metres())
}

fn job(plan: &FloorPlan, robot: &str, start: Option<Pose>) -> CoverageJob {
    let (robot, cell) = choose_robot(robot, plan, None).expect("the robot exists");
    RoomSetup::new(plan, &robot, cell, start).expect("the robot fits").job
}

fn place(job: &CoverageJob) -> &JobPlace {
    job.place.as_deref().expect("the room is laid out")
}

fn drawn(text: &str) -> FloorPlan {
    let bytes = format!("; resolution 0.4\n{text}").into_bytes();
    load(&[SourceFile { name: "drawn.txt".to_owned(), bytes }]).expect("it is a map")
}

/// Rooms with a name: for round and other bodies, with furniture, askew, hardly larger than the robot.
fn jobs() -> Vec<(String, CoverageJob)> {
    let mut jobs: Vec<(String, CoverageJob)> =
        (0..3).map(|seed| (format!("random flat {seed}"), job(&random_flat(1, 1, seed), "roomba600", None))).collect();
    for (id, robot) in [("slanted", "roomba600"), ("kitchen", "octagon"), ("thesis8", "cell"), ("stairs", "roomba600")]
    {
        jobs.push((format!("{id} for {robot}"), job(&(room(id).expect("it ships").build)(), robot, None)));
    }
    for text in [".\n", "..\n", ".\n.\n.\n", "..\n.#\n..\n"] {
        jobs.push((text.to_owned(), job(&drawn(text), "roomba600", None)));
    }
    let open = drawn(".....\n.....\n.....\n");
    jobs.push(("from elsewhere".to_owned(), job(&open, "roomba600", Some(Pose::new(1.3, 0.9, 2.0)))));
    jobs
}

/// Whether a path can be driven: from the start, and no piece touches anything.
pub(super) fn holds(path: &CoveragePath, job: &CoverageJob, what: &str) {
    path.check(job).unwrap_or_else(|error| panic!("{what}: {error}"));
    let floor = &place(job).floor;
    let space = FreeSpace::new(floor.limits(), 0.0);
    for (i, piece) in path.line.windows(2).enumerate() {
        let room = space.distance(piece[0], piece[1]) - floor.limits().body_radius;
        assert!(room >= -1e-6, "{what}: piece {i} has {room} m");
    }
    assert!(path.is_in_metres() && path.cells.is_empty(), "{what}");
}

// slow: searches in several rooms
#[test]
fn paths_touch_nothing_and_sweep_the_floor() {
    for (name, job) in jobs() {
        for info in planners() {
            let what = format!("{} in {name}", info.id);
            // In a room hardly larger than the robot only a search finds the few centimetres to move.
            let effort = if place(&job).floor.area() < 1.0 { 0 } else { usize::MAX };
            let path = build(info, effort).plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
            holds(&path, &job, &what);
            let swept = swept_share(&place(&job).floor, &path.line);
            // A disc doesn't reach into corners of cells that a robot fills.
            let least = if place(&job).robot.fills_cell { 0.8 } else { 0.9 };
            assert!(swept > least, "{what}: {swept}");
        }
    }
}

#[test]
fn seed_determines_the_path_and_watching_changes_nothing() {
    let job = job(&random_flat(1, 1, 7), "roomba600", None);
    for info in planners() {
        let mut params = Params::defaults(info.params);
        if let Some(effort) = info.effort() {
            params.set(info.params, effort.id, ParamValue::Number(0.1)).expect("it is in range");
        }
        let plan = |ctx: &mut PlanContext<'_>| info.build(&params).plan(&job, ctx).expect("nobody cancels");
        let alone = plan(&mut PlanContext::new(1));
        holds(&alone, &job, info.id);
        let (mut calls, mut last) = (0, 0.0);
        let mut observer = |ProgressReport { done, line, walk, .. }: ProgressReport<'_>| {
            calls += 1;
            assert!((last..=1.0).contains(&done) && walk.is_empty(), "{} reports {done} after {last}", info.id);
            last = done;
            if !line.is_empty() {
                holds(&CoveragePath::in_metres(line.to_vec()), &job, info.id);
            }
            ControlFlow::Continue(())
        };
        assert!(
            plan(&mut PlanContext::observed(1, &mut observer)) == alone,
            "{} plans otherwise when watched",
            info.id
        );
        assert!(calls >= 3, "{} reports {calls} times", info.id);
        assert_eq!(plan(&mut PlanContext::new(2)) == alone, info.claims.deterministic, "{}", info.id);
    }
}

#[test]
fn every_value_of_every_parameter_works() {
    let job = job(&drawn("......\n......\n..##..\n......\n"), "roomba600", None);
    for info in planners() {
        for spec in info.params {
            let values: Vec<ParamValue> = match spec.kind {
                // Ten times the effort is as good as a hundred.
                ParamKind::Number { min, max, .. } => vec![ParamValue::Number(min), ParamValue::Number(max.min(99.9))],
                ParamKind::Choice { options } => options.iter().map(|o| ParamValue::Choice(o.0.to_owned())).collect(),
                ParamKind::Flag { .. } => vec![ParamValue::Flag(false), ParamValue::Flag(true)],
            };
            let is_effort = info.effort().is_some_and(|effort| effort.id == spec.id);
            for value in values.into_iter().take(if is_effort { 1 } else { 2 }) {
                let mut params = Params::defaults(info.params);
                if let Some(effort) = info.effort() {
                    params.set(info.params, effort.id, ParamValue::Number(0.1)).expect("it is in range");
                }
                params.set(info.params, spec.id, value.clone()).expect("it is in range");
                let path = info.build(&params).plan(&job, &mut PlanContext::new(1)).expect("nobody cancels");
                holds(&path, &job, &format!("{} with {} = {value}", info.id, spec.id));
            }
        }
    }
}

#[test]
fn cancelling_is_honoured_at_every_checkpoint() {
    let job = job(&random_flat(1, 1, 3), "roomba600", None);
    for info in planners() {
        for stop in 1..8 {
            let mut calls = 0;
            let mut observer = |_: ProgressReport<'_>| {
                calls += 1;
                if calls >= stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let result = build(info, 0).plan(&job, &mut PlanContext::observed(1, &mut observer));
            assert_eq!(result, Err(PlanError::Cancelled), "{}", info.id);
            assert_eq!(calls, stop, "{} goes on after having been cancelled", info.id);
        }
    }
}

#[test]
fn a_bare_grid_and_a_path_through_a_wall_are_refused() {
    let laid_out = job(&drawn("...\n.#.\n...\n"), "roomba600", None);
    let bare = CoverageJob { place: None, ..laid_out.clone() };
    for info in planners() {
        let result = build(info, 0).plan(&bare, &mut PlanContext::new(1));
        assert_eq!(result, Err(PlanError::NoFloor), "{}", info.id);
    }
    let start = place(&laid_out).floor.start.position();
    let path = |line: Vec<Point>| CoveragePath::in_metres(line).check(&laid_out);
    assert_eq!(path(vec![start, Point::new(0.6, 0.6)]), Err(PathError::Touches(1)));
    assert_eq!(path(vec![Point::new(0.5, 0.2)]), Err(PathError::WrongBegin));
    assert_eq!(CoveragePath::in_metres(vec![start]).check(&bare), Err(PathError::NoFloor));
    assert!(model("roomba600").is_some_and(|robot| path(vec![start]).is_ok() && robot.radius < 0.2));
}
