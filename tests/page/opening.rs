//! The plan that the page opens with is what the planner finds, made in advance.
//!
//! After a change of a planner: `UPDATE=1 cargo test --test page opening` writes it again.

use coverage_planners::{
    Bounds, CoveragePath, Proof,
    metrics::{MetricExcess, SweepBound, WalkMetrics},
};
use robovac_app::explore::{Session, opening};
use robovac_core::floor_plan::ROOMS;
use robovac_sim::experiment::{
    Settings,
    planning::{PlanAnswer, PlanRequest, Planned, RoomSetup},
};

/// The opening scene's request, as any other would be made.
fn request() -> PlanRequest {
    let settings = Settings::new();
    let plan = (ROOMS[0].build)();
    let prepared = RoomSetup::new(&plan, &settings.robot_model(), settings.cell_size, None).unwrap();
    PlanRequest {
        id: 1,
        planner: settings.algorithm.planner().unwrap(),
        params: settings.params,
        seed: settings.seed,
        job: prepared.job,
    }
}

/// The runs in lines that can be read.
fn lines(runs: &str) -> String {
    let words: Vec<&str> = runs.split(' ').collect();
    words.chunks(20).map(|line| line.join(" ") + "\n").collect()
}

#[test]
fn kept_plan_is_the_planners_own() {
    let request = request();
    let cells = request.serve(|| 0.0, None).unwrap().path.cells;
    if std::env::var_os("UPDATE").is_some() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/crates/robovac-app/src/explore/opening.txt");
        std::fs::write(file, lines(&opening::to_runs(&cells))).unwrap();
        return;
    }
    let kept = opening::from_runs(request.job.start, opening::WALK);
    assert!(kept == cells, "the planner finds another walk now: UPDATE=1 cargo test --test page opening keeps it");
}

#[test]
fn kept_plan_is_as_good_as_it_says() {
    let job = request().job;
    let path = CoveragePath::walk(opening::from_runs(job.start, opening::WALK));
    let cost = WalkMetrics::of(&job, &path).cost() as u64;
    assert_eq!(opening::PROOF, Proof { cost, bound: Bounds::of(&job).cost as u64 }, "opening.rs tells something else");
    let place = job.place.as_deref().unwrap();
    let prepared = RoomSetup::new(&(ROOMS[0].build)(), &place.robot, Settings::new().cell_size, None).unwrap();
    let answer = PlanAnswer { path, seconds: 0.0, proof: None, trace: Vec::new() };
    let numbers = Planned::new(&prepared, &answer).unwrap().numbers(&prepared, Bounds::of(&job));
    let MetricExcess { swept, bound, .. } = numbers.excess.unwrap();
    let is_near = |told: f64, found: f64| (told - found).abs() < 0.05;
    let SweepBound { coverage, length_m, duration_s } = opening::LEAST;
    let is_right = is_near(length_m, bound.length_m) && is_near(duration_s, bound.duration_s);
    assert!(is_right && (coverage - swept).abs() < 5e-5, "opening.rs should tell {swept} and {bound:?}");
    // It is available at once, without a worker.
    let mut session = Session::new();
    assert!(session.take_plan_request().is_none());
    assert_eq!(session.view().plan.unwrap().above_bound, Some(opening::PROOF.gap()));
}

#[test]
fn opens_without_a_planner_and_without_an_invented_time() {
    let mut session = Session::new();
    assert!(session.take_plan_request().is_none());
    let kept = session.view().plan.unwrap();
    assert!(kept.walk.steps > 0 && kept.planning_s.is_none());
    // A link to just that changes nothing, and neither does what isn't planned for.
    session.restore(&session.link()).unwrap();
    assert!(session.take_plan_request().is_none() && session.planned().is_some());
    session.configure(|s| s.set_slip("typical")).unwrap();
    assert!(session.take_plan_request().is_none() && session.planned().is_some());
    // After another request, planners answer.
    session.select_room("empty").unwrap();
    session.plan_now(|| 0.0);
    session.select_room(ROOMS[0].id).unwrap();
    assert!(session.take_plan_request().is_some());
}

#[test]
fn anything_but_the_opening_scene_is_planned() {
    for link in ["room=empty", "seed=2", "cell=0.2", "robot=cell", "planner=snake", "p.effort=3", "start=1.0,1.0,0.0"] {
        let mut session = Session::new();
        session.restore(link).unwrap();
        assert!(session.take_plan_request().is_some(), "{link}");
    }
}
