//! What every planner reaches on the maps given, as a table for comparison with others.
//!
//! `cargo run --release --example planner_table -- MAP...`

use robovac_playground::{
    app::Prepared,
    floorplan::{FloorPlan, SourceFile, load},
    metrics::WalkMetrics,
    planner::{PLANNERS, Params, PlanContext},
    robot::cell_robot,
};
use std::{error::Error, fs, time::Instant};

/// Runs of each planner; the fastest is shown.
const RUNS: usize = 5;

fn main() -> Result<(), Box<dyn Error>> {
    println!("| room | planner | steps | revisits | quarter turns | steps + 2 x turns | ms |");
    println!("|---|---|---|---|---|---|---|");
    for name in std::env::args().skip(1) {
        let plan = load(&[SourceFile { bytes: fs::read(&name)?, name }])?;
        table(&plan)?;
    }
    Ok(())
}

fn table(plan: &FloorPlan) -> Result<(), Box<dyn Error>> {
    let prepared = Prepared::new(plan, &cell_robot(plan.resolution), plan.resolution, None)?;
    for info in PLANNERS {
        let planner = info.build(&Params::defaults(info.params));
        let mut best_ms = f64::MAX;
        let mut metrics = None;
        for _ in 0..RUNS {
            let began = Instant::now();
            let path = planner.plan(&prepared.job, &mut PlanContext::new(1))?;
            best_ms = best_ms.min(began.elapsed().as_secs_f64() * 1e3);
            metrics = Some(WalkMetrics::of(&prepared.job, &path));
        }
        let Some(WalkMetrics { steps, turns, revisits, .. }) = metrics else { continue };
        let (room, cost) = (&plan.name, steps + 2 * turns);
        println!("| {room} | {} | {steps} | {revisits} | {turns} | {cost} | {best_ms:.2} |", info.id);
    }
    Ok(())
}
