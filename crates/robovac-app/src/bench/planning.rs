//! Benchmarks of planners and the simulator.

use super::Bench;
use crate::explore::Session;
use coverage_planners::{
    CoverageJob, PLANNERS, PlanContext, SLOW_CELLS,
    lanes::{LanesPlan, LanesProgress, LanesSetup, plan_lanes},
};
use robovac_core::{
    coverage::ReachableFloor,
    floor_plan::{FloorPlan, generate::random_hall, room},
    geometry::Pose,
    grid::{Cell, Direction, Occupancy},
    registry::Params,
    robot::model,
};
use robovac_sim::{Run, STEP_S, montecarlo::RunsRequest};
use std::ops::ControlFlow;

/// Steps of the simulator's case: half an hour, less than the flat takes.
const SIMULATED_STEPS: u32 = 120_000;
/// Cells along each side of the hall in which lanes are laid, and their width, m: 10,000 m².
const HALL_SIDE: usize = 1000;
const HALL_CELL: f64 = 0.1;

/// Every planner of walks on 100 x 100 cells and the fast ones on 1000 x 1000; the opening scene, and one of many runs.
pub fn planning(bench: &mut Bench<'_>) {
    for side in [bench.size(100, 12), bench.size(1000, 100)] {
        let Some(job) = hall(side) else { continue };
        for info in PLANNERS.iter().filter(|info| info.claims.fast || job.cells() <= SLOW_CELLS && !info.is_in_metres())
        {
            let planner = info.build(&Params::defaults(info.params));
            let name = format!("plan {} {side} x {side}", info.id);
            bench.take(&name, &mut || drop(planner.plan(&job, &mut PlanContext::new(1))), None);
        }
    }
    let side = bench.size(HALL_SIDE, 50);
    if let Some(flat) = room("flat").map(|room| (room.build)()) {
        bench.take("lanes, first path in the flat", &mut || drop(first_path(&flat)), None);
    }
    let hall = hall_plan(side);
    let name = format!("lanes, first path in a hall of {:.0} m²", hall.width_m() * hall.height_m());
    bench.take(&name, &mut || drop(first_path(&hall)), None);
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
        job: None,
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

/// Such a hall in metres.
fn hall_plan(side: usize) -> FloorPlan {
    let free = random_hall(side, side, 1);
    FloorPlan {
        name: "hall".to_owned(),
        note: String::new(),
        resolution: HALL_CELL,
        occupancy: free.map(|&free| if free { Occupancy::Free } else { Occupancy::Occupied }),
        objects: Vec::new(),
        start: None,
        origin: Pose::new(0.0, 0.0, 0.0),
    }
}

/// What `lanes` shows first, from nothing but a room and a Roomba.
fn first_path(plan: &FloorPlan) -> Option<LanesPlan> {
    let robot = model("roomba600")?;
    let floor = ReachableFloor::new(plan, robot, None).ok()?;
    plan_lanes(&floor, robot, &LanesSetup::default(), &mut |progress: LanesProgress<'_>| {
        if progress.path.is_empty() { ControlFlow::Continue(0.0) } else { ControlFlow::Break(()) }
    })
    .ok()
}

/// A Roomba about to clean the furnished flat, as the page opens with it.
pub fn opening_run() -> Option<Run> {
    let mut session = Session::new();
    session.plan_now(|| 0.0);
    session.recording().map(|recording| recording.run().clone())
}
