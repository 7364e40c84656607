//! The benchmark that runs natively (`robovac bench`) and in the browser (`bench.html`), so that both can be compared.

use super::{Session, montecarlo::RunsRequest};
use crate::{
    floorplan::generate::random_hall,
    grid::{Cell, Direction},
    planner::{CoverageJob, PLANNERS, Params, PlanContext, SLOW_CELLS},
    sim::{Run, STEP_S},
};
use serde::Serialize;
use std::array;

/// Samples of each case but long ones; the median is reported.
const SAMPLES: usize = 5;
/// Shortest sample, s: a browser's clock is coarse, and it optimises only what has run for a while. Shorter cases are
/// repeated.
const LEAST_S: f64 = 0.05;
/// A case that takes longer is measured once, s.
const LONG_S: f64 = 0.5;
/// Most repetitions, whatever the clock says.
const MOST_REPEATS: u32 = 1024;
/// Steps of the simulator's case: half an hour, less than the flat takes.
const SIMULATED_STEPS: u32 = 120_000;

/// One case's result.
#[derive(Debug, Clone, Serialize)]
pub struct BenchResult {
    /// What was measured.
    pub name: String,
    /// Median time of one run, ms.
    pub ms: f64,
    /// Times real time, for the simulator.
    pub times_real_time: Option<f64>,
}

/// Runs all cases. `clock` gives seconds; `report` is told each result as it comes.
pub fn run(clock: &dyn Fn() -> f64, report: &mut dyn FnMut(&BenchResult)) -> Vec<BenchResult> {
    let mut results = Vec::new();
    let mut take = |name: String, case: &mut dyn FnMut(), simulated: Option<f64>| {
        let mut sample = |repeats: u32| {
            let began = clock();
            (0..repeats).for_each(|_| case());
            clock() - began
        };
        let (mut repeats, mut seconds) = (1, sample(1));
        while seconds < LEAST_S && repeats < MOST_REPEATS {
            repeats *= 2;
            seconds = sample(repeats);
        }
        if seconds < LONG_S {
            let mut times: [f64; SAMPLES] = array::from_fn(|_| sample(repeats) / f64::from(repeats));
            times.sort_by(f64::total_cmp);
            seconds = times[SAMPLES / 2];
        }
        let result = BenchResult { name, ms: 1000.0 * seconds, times_real_time: simulated.map(|s| s / seconds) };
        report(&result);
        results.push(result);
    };
    for side in [100, 1000] {
        let Some(job) = hall(side) else { continue };
        for info in PLANNERS.iter().filter(|info| info.claims.fast || job.cells() <= SLOW_CELLS) {
            let planner = info.build(&Params::defaults(info.params));
            let name = format!("plan {} {side} x {side}", info.id);
            take(name, &mut || drop(planner.plan(&job, &mut PlanContext::new(1))), None);
        }
    }
    if let Some(start) = opening_run() {
        let mut simulate = || {
            let mut run = start.clone();
            for _ in 0..SIMULATED_STEPS {
                run.step();
            }
        };
        take("simulate the furnished flat".to_owned(), &mut simulate, Some(f64::from(SIMULATED_STEPS) * STEP_S));
    }
    let request = cycle();
    if let Ok(mut lab) = request.lab() {
        let mut runs = || drop(request.run(&mut lab, None));
        take("simulate the cleaning cycle in the flat".to_owned(), &mut runs, Some(request.duration_s));
    }
    results
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
