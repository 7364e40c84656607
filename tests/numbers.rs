//! What the planners reach on the shared grids, to be compared with what others reach there.
//!
//! `cargo test --release --test numbers -- --ignored --nocapture`; `ONLY=snake` and `ROOM=hall` choose.

mod support;

use robovac_playground::{
    metrics::WalkMetrics,
    planner::{PLANNERS, Params, PlanContext},
};
use std::{env, time::Instant};

#[test]
#[ignore = "prints a table"]
fn numbers_on_shared_grids() {
    let [only, room] = ["ONLY", "ROOM"].map(|name| env::var(name).unwrap_or_default());
    println!("| room | planner | steps | revisits | quarter turns | steps + 2 x turns | ms, best of 5 |");
    for scenario in support::shared_grids().iter().filter(|s| s.name.contains(&room)) {
        for info in PLANNERS.iter().filter(|info| info.id.contains(&only)) {
            let job = scenario.jobs().next().expect("there is a start");
            let planner = (info.build)(&Params::defaults(info.params));
            let mut best_s = f64::MAX;
            let mut path = None;
            for _ in 0..5 {
                let began = Instant::now();
                path = planner.plan(&job, &mut PlanContext::new(0)).ok();
                best_s = best_s.min(began.elapsed().as_secs_f64());
            }
            let WalkMetrics { steps, turns, revisits, .. } = WalkMetrics::of(&job, &path.expect("nobody cancels"));
            let (name, cost, ms) = (&scenario.name, steps + 2 * turns, best_s * 1e3);
            println!("| {name} | {} | {steps} | {revisits} | {turns} | {cost} | {ms:.2} |", info.id);
        }
    }
}
