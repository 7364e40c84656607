//! Results of every planner on the given maps, as a table: fast planners on all of them, the others on those of up to
//! `SLOW_CELLS` cells.
//!
//! `cargo run --release --example planner_table -- MAP...`

use coverage_planners::{Bounds, PLANNERS, PlanContext, SLOW_CELLS, metrics::WalkMetrics};
use robovac_core::{
    floor_plan::{FloorPlan, SourceFile, load},
    registry::Params,
    robot::cell_robot,
};
use robovac_sim::experiment::planning::RoomSetup;
use std::{
    error::Error,
    fs,
    time::{Duration, Instant},
};

/// Runs of each planner; the fastest is shown.
const RUNS: usize = 5;
/// No further run once a planner has taken this long.
const PATIENCE: Duration = Duration::from_secs(3);

fn main() -> Result<(), Box<dyn Error>> {
    println!("| room | planner | steps | revisits | quarter turns | steps + 2 x turns | above bound, % | ms |");
    println!("|---|---|---|---|---|---|---|---|");
    for name in std::env::args().skip(1) {
        let plan = load(&[SourceFile { bytes: fs::read(&name)?, name }])?;
        table(&plan)?;
    }
    Ok(())
}

fn table(plan: &FloorPlan) -> Result<(), Box<dyn Error>> {
    let prepared = RoomSetup::new(plan, &cell_robot(plan.resolution), plan.resolution, None)?;
    let bound = Bounds::of(&prepared.job).cost;
    for info in
        PLANNERS.iter().filter(|info| info.claims.fast || prepared.job.cells() <= SLOW_CELLS && !info.is_in_metres())
    {
        let planner = info.build(&Params::defaults(info.params));
        let mut best_ms = f64::MAX;
        let mut metrics = None;
        let all = Instant::now();
        for run in 0..RUNS {
            if run > 0 && all.elapsed() > PATIENCE {
                break;
            }
            let began = Instant::now();
            let path = planner.plan(&prepared.job, &mut PlanContext::new(1))?;
            best_ms = best_ms.min(began.elapsed().as_secs_f64() * 1e3);
            metrics = Some(WalkMetrics::of(&prepared.job, &path));
        }
        let Some(WalkMetrics { steps, turns, revisits, .. }) = metrics else { continue };
        let (room, cost) = (&plan.name, steps + 2 * turns);
        let above = 100.0 * (cost as f64 / bound.max(1) as f64 - 1.0);
        println!("| {room} | {} | {steps} | {revisits} | {turns} | {cost} | {above:.1} | {best_ms:.2} |", info.id);
    }
    Ok(())
}
