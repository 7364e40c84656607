//! Paths in metres beside walks on planning cells: `cargo run --release --example lanes_table --
//! [SECONDS [COVERAGE [CLEARANCE [ROOM...]]]]`.
//!
//! For a Roomba 600: bounds, `boustrophedon`, `near_optimal` and lanes, searched for so many seconds (30) for a share of the floor
//! (99 %), that many millimetres off obstacles (3). Seconds are those of the processor on Linux, as other programs may run. A room is
//! the id of a built-in one, or the seed of a random flat.

mod processor_clock;

use coverage_planners::{
    CoverageJob, Params, PlanContext, find,
    lanes::{LanesProgress, LanesSetup, MetricBound, plan_lanes, swept_share},
    metrics::DriveMetrics,
};
use processor_clock::Clock;
use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    floor_plan::{generate::random_flat, room},
    robot::{RobotModel, model},
};
use std::{error::Error, ops::ControlFlow};

const ROOMS: [&str; 8] = ["flat", "room12ft", "bedroom", "living", "hotel", "office", "warehouse", "hall20"];

/// A row: length in metres, time in seconds and coverage, 0 to 1, with their excess over the bound for that coverage.
fn row(name: &str, floor: &ReachableFloor, robot: &RobotModel, [length, duration, coverage]: [f64; 3]) -> String {
    let excess = MetricBound::new(floor, robot, coverage).excess(length, duration);
    format!(
        "| {name} | {length:.1} | {:.2} | {:.2} | {:.1} % | {:.1} % |",
        duration / 60.0,
        100.0 * coverage,
        100.0 * excess[0],
        100.0 * excess[1]
    )
}

/// A planner of the registry on cells that fit the robot.
fn on_cells(id: &str, floor: &ReachableFloor, robot: &RobotModel) -> Result<[f64; 3], Box<dyn Error>> {
    let planner = find(id).ok_or("no such planner")?;
    let cells = PlanningGrid::new(floor, robot.default_cell);
    let job = CoverageJob::on_planning_grid(&cells, floor, robot);
    let walk = planner.build(&Params::defaults(planner.params)).plan(&job, &mut PlanContext::new(0))?;
    let line = cells.polyline(floor, &walk.cells);
    let drive = DriveMetrics::of(floor, robot, &line);
    Ok([drive.length_m, drive.duration_s, swept_share(floor, &line)])
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |index: usize, default: f64| arguments.get(index).map_or(Ok(default), |text| text.parse());
    let seconds: f64 = number(0, 30.0)?;
    let setup = LanesSetup {
        coverage: number(1, 99.0)? / 100.0,
        clearance: number(2, 3.0)? / 1000.0,
        effort: LanesSetup::MOST_EFFORT,
        ..LanesSetup::default()
    };
    let chosen: Vec<&str> = arguments.iter().skip(3).map(String::as_str).collect();
    let robot = model("roomba600").ok_or("no such robot")?;
    for name in if chosen.is_empty() { &ROOMS[..] } else { &chosen[..] } {
        let plan = match name.parse() {
            Ok(seed) => random_flat(1 + (seed % 3) as u32, 1 + (seed % 2) as u32, seed),
            Err(_) => (room(name).ok_or("no such room")?.build)(),
        };
        let floor = ReachableFloor::new(&plan, robot, None)?;
        let bound = MetricBound::new(&floor, robot, setup.coverage);
        println!(
            "\n**{name}**, {:.1} m², bound {:.1} m and {:.2} min\n",
            floor.area(),
            bound.length_m,
            bound.duration_s / 60.0
        );
        println!("| planner | m | min | coverage, % | excess, m | excess, min |\n|---|---|---|---|---|---|");
        for id in ["boustrophedon", "near_optimal"] {
            println!("{}", row(id, &floor, robot, on_cells(id, &floor, robot)?));
        }
        let clock = Clock::start();
        let mut first = None;
        let mut observe = |progress: LanesProgress<'_>| {
            let now = clock.seconds();
            if !progress.path.is_empty() {
                first.get_or_insert((now, progress.duration_s, progress.coverage));
            }
            ControlFlow::Continue(now / seconds)
        };
        let found = plan_lanes(&floor, robot, &setup, &mut observe)?;
        println!("{}", row("lanes", &floor, robot, [found.length_m, found.duration_s, found.coverage]));
        if let Some((after, duration, coverage)) = first {
            println!(
                "\nFirst path after {after:.2} s: {:.2} min, {:.2} %; {} corners after {:.0} s.",
                duration / 60.0,
                100.0 * coverage,
                found.path.len(),
                clock.seconds()
            );
        }
    }
    Ok(())
}
