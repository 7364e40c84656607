//! Plans that come, are kept, are cancelled or are refused.

use super::opened;
use coverage_planners::{CoveragePath, ProgressReport, Proof, metrics::SweepBound};
use robovac_app::explore::{Session, SessionState};
use robovac_core::{floor_plan::SourceFile, geometry::Pose, grid::Cell};
use robovac_sim::experiment::planning::PlanAnswer;
use std::ops::ControlFlow;

fn answer(cells: Vec<Cell>) -> PlanAnswer {
    PlanAnswer { path: CoveragePath::walk(cells), seconds: 0.1, proof: None, trace: Vec::new() }
}

#[test]
fn late_answers_of_older_plans_are_dropped() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    let old = session.take_plan_request().unwrap();
    session.select_room("empty").unwrap();
    session.plan_finished(old.id, answer(vec![old.job.start]));
    assert_eq!(session.state(), SessionState::Planning);
    session.plan_progress(old.id, ProgressReport { done: 0.5, walk: &[Cell::new(0, 0)], line: &[], proof: None });
    session.plan_proven(old.id, Some(Proof { cost: 2, bound: 1 }), None);
    assert!(session.preview().is_empty());
}

#[test]
fn walk_through_walls_is_refused() {
    let mut session = Session::new();
    session.select_room("empty").unwrap();
    let request = session.take_plan_request().unwrap();
    session.plan_finished(request.id, answer(vec![request.job.start, Cell::new(-1, 100_000)]));
    assert_eq!(session.state(), SessionState::Failed);
    let view = session.view();
    assert!(view.message.starts_with("The planner failed: step 1 leads into (-1, 100000)"), "{}", view.message);
}

#[test]
fn cancelled_plan_leaves_the_room_and_says_so() {
    let mut session = Session::new();
    session.cancel_plan();
    assert_eq!(session.state(), SessionState::Failed);
    assert_eq!(session.view().message_kind, "notice");
    session.play();
    session.plan_now(|| 0.0);
    assert_eq!(session.state(), SessionState::Playing);
}

#[test]
fn gap_is_shown_while_planning_and_afterwards() {
    let mut session = Session::new();
    session.select_room("empty").unwrap();
    let request = session.take_plan_request().unwrap();
    let shown = |session: &Session| session.view().plan.unwrap().gap;
    assert_eq!(shown(&session), None);
    let proof = Some(Proof { cost: 110, bound: 100 });
    session.plan_progress(request.id, ProgressReport { done: 0.5, walk: &[request.job.start], line: &[], proof });
    assert_eq!(shown(&session), Some(0.1));
    let mut answer = request.serve(|| 0.0, None).unwrap();
    answer.proof = proof;
    session.plan_finished(request.id, answer);
    assert_eq!(shown(&session), Some(0.1));
    // As plans are compared is another number.
    let compared = |session: &Session| session.view().plan.unwrap().above_bound;
    assert_eq!(compared(&session), None);
    session.plan_proven(
        request.id,
        Some(Proof { cost: 120, bound: 100 }),
        Some(SweepBound { coverage: 0.99, length_m: 3.0, duration_s: 9.0 }),
    );
    assert_eq!((shown(&session), compared(&session)), (Some(0.1), Some(0.2)));
    // Of another plan it says nothing.
    session.plan_now(|| 0.0);
    session.plan_proven(request.id + 1, Some(Proof { cost: 3, bound: 1 }), None);
    assert_eq!(compared(&session), Some(0.2));
}

#[test]
fn best_walk_so_far_is_kept() {
    let mut session = Session::new();
    session.select_room("office").unwrap();
    session.configure(|s| s.select_algorithm("near_optimal")).unwrap();
    let request = session.take_plan_request().unwrap();
    let mut gaps = Vec::new();
    // As on the page: the button is pressed as soon as there is one.
    let mut watch = |report: ProgressReport<'_>| {
        session.plan_progress(request.id, report);
        gaps.extend(session.view().plan.unwrap().gap);
        if session.view().can.keep { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    assert!(request.serve(|| 0.0, Some(&mut watch)).is_err());
    session.keep_plan(1.5);
    let plan = session.view().plan.unwrap();
    assert_eq!((session.state(), plan.planning_s), (SessionState::Playing, Some(1.5)));
    let walk = plan.walk;
    assert_eq!(walk.visited_cells, walk.reachable_cells);
    assert!(plan.gap.is_some_and(|gap| gap > 0.0 && Some(&gap) == gaps.last()), "{gaps:?}");
}

#[test]
fn cancelled_walk_is_no_longer_drawn() {
    let mut session = Session::new();
    session.select_room("lshape").unwrap();
    let request = session.take_plan_request().unwrap();
    let (start, other) = (request.job.start, Cell::new(request.job.start.x + 1, request.job.start.y));
    session.plan_progress(request.id, ProgressReport { done: 0.5, walk: &[start, other], line: &[], proof: None });
    let drawn = session.scene().planned_version;
    assert_eq!(session.scene().preview.len(), 2);
    session.cancel_plan();
    assert!(session.scene().preview.is_empty() && session.scene().planned_version != drawn);
}

#[test]
fn half_a_walk_is_not_kept() {
    let mut session = Session::new();
    session.select_room("empty").unwrap();
    session.configure(|s| s.select_algorithm("snake")).unwrap();
    let request = session.take_plan_request().unwrap();
    session.plan_progress(request.id, ProgressReport { done: 0.5, walk: &[request.job.start], line: &[], proof: None });
    assert!(session.view().can.cancel && !session.view().can.keep);
    session.keep_plan(1.0);
    assert_eq!((session.state(), session.planned().is_some()), (SessionState::Failed, false));
}

#[test]
fn cells_finer_than_the_map_are_refused_before_memory_runs_out() {
    let mut session = opened();
    let hall = format!("; resolution 5\n{}", format!("{}\n", ".".repeat(400)).repeat(400));
    session.load(&[SourceFile { name: "hall.txt".into(), bytes: hall.into_bytes() }]).unwrap();
    session.configure(|s| s.select_robot("cell")).unwrap();
    session.configure(|s| s.set_cell_size(0.02)).unwrap();
    assert_eq!(session.state(), SessionState::Failed);
    assert!(session.view().message.contains("too small for this map"), "{}", session.view().message);
}

#[test]
fn start_in_a_closet_is_told_with_the_floor_that_is_left_out() {
    let map = "; resolution 0.5\n........\n........\n######..\n.....#..\n#####...\n........\n";
    let mut session = Session::new();
    session.load(&[SourceFile { name: "closet.txt".into(), bytes: map.into() }]).unwrap();
    session.configure(|s| s.select_robot("cell")).unwrap();
    session.configure(|s| s.set_cell_size(0.5)).unwrap();
    assert_eq!(session.view().message, "", "the default start is in the large part");
    assert_eq!(session.view().room.left_out_m2, 5.0 * 0.25);
    session.move_start(Pose::new(0.25, 1.25, 0.0));
    let view = session.view();
    assert_eq!((view.room.reachable_m2, view.room.left_out_m2), (1.25, 31.0 * 0.25));
    assert!(
        view.message.starts_with("From this start the robot can reach only 1.2 m² of floor; 7.8 m² (hatched)"),
        "{}",
        view.message
    );
    session.move_start(Pose::new(0.25, 0.25, 0.0));
    assert_eq!(session.view().message, "");
}
