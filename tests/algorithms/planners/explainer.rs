//! The texts of the planners, checked by measurement.

use super::support::build;
use coverage_planners::{
    CoverageJob, JobPlace, PLANNERS, PlanContext, PlannerClaims, PlannerInfo,
    metrics::{DriveMetrics, MetricExcess, WalkMetrics},
};
use robovac_core::{floor_plan::room, registry::Params, robot::model};
use robovac_sim::experiment::planning::RoomSetup;
use std::{collections::BTreeMap, fs};

/// A room as the page opens it: for a Roomba, whose cells leave rooms small enough for full effort.
fn job(id: &str) -> CoverageJob {
    let plan = (room(id).expect("the room ships").build)();
    let robot = model("roomba600").expect("the robot exists");
    RoomSetup::new(&plan, robot, robot.default_cell, None).expect("the robot fits").job
}

/// Steps + 2 x quarter turns; for a path in metres how far its time is above the least.
fn cost(info: &PlannerInfo, job: &CoverageJob) -> f64 {
    if info.is_in_metres() {
        let path = build(info, usize::MAX).plan(job, &mut PlanContext::new(1)).expect("nobody cancels");
        let JobPlace { floor, robot, .. } = job.place.as_deref().expect("the room is laid out");
        let drive = DriveMetrics::of(floor, robot, &path.line);
        return MetricExcess::of(floor, robot, &path.line, &drive).expect("its tool is a disc").above[1];
    }
    let path = info.build(&Params::defaults(info.params)).plan(job, &mut PlanContext::new(1)).expect("nobody cancels");
    WalkMetrics::of(job, &path).cost() as f64
}

/// Costs are taken relative to the best of the planners that are fast and the planner itself: those that search for
/// seconds are nearly always a little better, but would take this test minutes. Paths in metres are taken for themselves, as
/// first laid.
// slow: full effort, which is what the claims are about
#[test]
fn planners_shine_and_fail_where_they_say() {
    // Several planners name the same rooms.
    let mut known: BTreeMap<(&str, &str), f64> = BTreeMap::new();
    for info in PLANNERS {
        let rooms = {
            let explainer = coverage_planners::explainer(info.id).expect("it is listed");
            [explainer.shines, explainer.fails]
        };
        let [shines, fails] = rooms.map(|example| {
            let job = job(example.room);
            let mut cost = |other: &PlannerInfo| -> f64 {
                *known.entry((example.room, other.id)).or_insert_with(|| cost(other, &job))
            };
            let own = cost(info);
            if info.is_in_metres() {
                return own;
            }
            let fast = PLANNERS.iter().filter(|other| other.claims.fast);
            own / fast.map(|other| cost(other)).fold(own, f64::min)
        });
        println!("{:20} {shines:.3} {fails:.3}", info.id);
        assert!(
            shines < fails,
            "{}: {shines:.3} times the best in {}, where it `shines`, and {fails:.3} times in {}, where it `fails`: choose \
             other rooms",
            info.id,
            rooms[0].room,
            rooms[1].room
        );
    }
}

/// A row a planner, in the order of the menus: id, idea, source, and whether it's complete, deterministic and fast.
#[test]
fn documentation_lists_all_planners_and_their_claims() {
    let page = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/docs/planners.md")).expect("it can be read");
    let section = page.split("\n## ").next().expect("it has a beginning");
    let rows = section.lines().filter(|line| line.starts_with("| `"));
    let listed: Vec<(String, Vec<bool>)> = rows
        .map(|line| {
            let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
            (cells[0].trim_matches('`').to_owned(), cells[3..].iter().map(|&cell| cell == "yes").collect())
        })
        .collect();
    let claimed = PLANNERS.iter().map(|info| {
        let PlannerClaims { complete, deterministic, fast, .. } = info.claims;
        (info.id.to_owned(), vec![complete, deterministic, fast])
    });
    assert_eq!(
        listed,
        claimed.collect::<Vec<_>>(),
        "rows of docs/planners.md, and planners in the order of `registry!`: id, then complete, deterministic, fast"
    );
}
