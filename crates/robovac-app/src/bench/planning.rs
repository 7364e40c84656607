//! Benchmarks of planners and the simulator.

use super::Bench;
use crate::explore::Session;
use coverage_planners::{CoverageJob, PLANNERS, PlanContext, SLOW_CELLS};
use robovac_core::{
    floor_plan::generate::random_hall,
    grid::{Cell, Direction},
    registry::Params,
};
use robovac_sim::{Run, STEP_S, montecarlo::RunsRequest};

/// Steps of the simulator's case: half an hour, less than the flat takes.
const SIMULATED_STEPS: u32 = 120_000;

/// Every planner of walks on 100 x 100 cells and the fast ones on 1000 x 1000; the opening scene, and one of many runs.
pub fn planning(bench: &mut Bench<'_>) {
    for side in [bench.size(100, 30), bench.size(1000, 300)] {
        let Some(job) = hall(side) else { continue };
        for info in
            PLANNERS.iter().filter(|info| info.claims.fast || job.cells() <= SLOW_CELLS && !info.claims.in_metres)
        {
            let planner = info.build(&Params::defaults(info.params));
            let name = format!("plan {} {side} x {side}", info.id);
            bench.take(&name, &mut || drop(planner.plan(&job, &mut PlanContext::new(1))), None);
        }
    }
    if let Some(start) = opening_run() {
        let mut simulate = || {
            let mut run = start.clone();
            for _ in 0..SIMULATED_STEPS {
                run.step();
            }
        };
        bench.take("simulate the furnished flat", &mut simulate, Some(f64::from(SIMULATED_STEPS) * STEP_S));
    }
    let request = cycle();
    if let Ok(lab) = request.lab() {
        let mut runs = || drop(request.run(&lab, None));
        bench.take("simulate the cleaning cycle in the flat", &mut runs, Some(request.duration_s));
    }
}

/// One of many runs: half an hour of the cleaning cycle by a Roomba in the furnished flat, with typical slip and noise.
pub fn cycle() -> RunsRequest {
    RunsRequest {
        id: 0,
        room: Some("flat".to_owned()),
        scenario: None,
        settings: "robot=roomba600&slip=typical&noise=typical".to_owned(),
        duration_s: 1800.0,
        plan_seed: 1,
        behaves: true,
        entrant: "cleaning_cycle".to_owned(),
        seeds: vec![1],
        place: String::new(),
    }
}

/// The job of a hall of `side` x `side` cells, a tenth of it blocked by rectangles.
pub fn hall(side: usize) -> Option<CoverageJob> {
    // The generator keeps the lower-left cell free.
    CoverageJob::new(&random_hall(side, side, 1), Cell::new(0, 0), Direction::Right)
}

/// A Roomba about to clean the furnished flat, as the page opens with it.
pub fn opening_run() -> Option<Run> {
    let mut session = Session::new();
    session.plan_now(|| 0.0);
    session.recording().map(|recording| recording.run().clone())
}
