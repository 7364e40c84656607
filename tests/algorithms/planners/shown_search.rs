//! What planners show of their search.

use super::{
    in_metres::holds,
    support::{EIGHT, drawn},
};
use coverage_planners::{CoverageJob, PLANNERS, PlanContext, PlannerInfo, ProgressReport, ShownSearch, TraceStep};
use robovac_core::{
    floor_plan,
    grid::{Cell, Direction},
    registry::{ParamValue, Params},
    robot::model,
};
use robovac_sim::experiment::planning::{PlanRequest, RoomSetup};
use std::ops::ControlFlow;

fn request(planner: &'static PlannerInfo) -> PlanRequest {
    let job = CoverageJob::new(&drawn(EIGHT), Cell::new(0, 7), Direction::Right).expect("the start is free");
    PlanRequest { id: 1, planner, params: Params::defaults(planner.params), seed: 1, job }
}

#[test]
fn every_planner_shows_its_search() {
    for &info in PLANNERS {
        match info.shown_search() {
            ShownSearch::Decisions => tells_its_decisions(info),
            ShownSearch::Film if info.is_in_metres() => is_filmed(&in_room(info)),
            ShownSearch::Film => is_filmed(&request(info)),
        }
    }
}

fn tells_its_decisions(info: &'static PlannerInfo) {
    let request = request(info);
    let mut steps: Vec<TraceStep> = Vec::new();
    let mut tell = |step| steps.push(step);
    let walk = info
        .build(&request.params)
        .plan(&request.job, &mut PlanContext::new(1).traced(&mut tell))
        .expect("nobody cancels")
        .cells;
    assert!(!steps.is_empty() && steps.is_sorted_by_key(|step| step.step), "{}", info.id);
    assert!(steps.iter().any(|step| step.marks.len() > 1), "{} never has a choice", info.id);
    for step in steps {
        assert_eq!(walk[step.step], step.at, "{}: {step:?}", info.id);
        assert!(!step.rule.is_empty() && !step.note.is_empty(), "{}: {step:?}", info.id);
        assert!(step.marks.iter().all(|&(cell, _)| request.job.free.is_set(cell)), "{}: {step:?}", info.id);
    }
}

/// For a planner that has to know the floor below the cells.
fn in_room(planner: &'static PlannerInfo) -> PlanRequest {
    let room = (floor_plan::room("living").expect("it is built in").build)();
    let room = RoomSetup::new(&room, model("roomba600").expect("it is known"), 0.12, None).expect("it fits");
    let params = Params::checked(planner.params, [("effort", ParamValue::Number(0.1))]).expect("they are valid");
    PlanRequest { id: 1, planner, params, seed: 1, job: room.job }
}

fn is_filmed(request: &PlanRequest) {
    let info = request.planner;
    let mut film = request.film().expect("the room is small");
    let mut observe = |report: ProgressReport<'_>| {
        film.take(&report);
        ControlFlow::Continue(())
    };
    let answer = request.serve(|| 0.0, Some(&mut observe)).expect("nobody cancels");
    let frames = film.ended(&answer.path, answer.proof);
    for frame in frames.iter().filter(|_| info.is_in_metres()) {
        holds(&frame.path, &request.job, info.id);
    }
    let (firsts, search): (Vec<_>, Vec<_>) = frames.iter().partition(|frame| frame.proof.is_none());
    assert!(firsts.iter().any(|first| !first.planner.is_empty()), "{}", info.id);
    assert!(search.len() > 1 || !info.is_in_metres(), "{}", info.id);
    assert_eq!(search.last().expect("a path with a proof").path, answer.path, "{}", info.id);
    for frame in search {
        assert!(frame.proof.is_some_and(|proof| proof.bound <= proof.cost), "{}: {frame:?}", info.id);
    }
}
