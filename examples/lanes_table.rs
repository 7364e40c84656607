//! Paths in metres beside walks on planning cells: `cargo run --release --example lanes_table --
//! [SECONDS [COVERAGE [CLEARANCE [ROOM...]]]]`.
//!
//! For a Roomba 600: bounds, `boustrophedon`, `near_optimal` and lanes, searched for some seconds (30) for a share of the floor
//! (99 %), that many millimetres off obstacles (3); the same with the least distance, and for a robot that rounds corners.
//! Seconds are those of the processor on Linux, as other programs may run. A room is the id of a built-in one, the seed of a random
//! flat, or a map file: a text map, or an image with 5 cm a pixel.

mod processor_clock;

use coverage_planners::{
    CoverageJob, Params, PlanContext, find,
    lanes::{LanesObjective, LanesPlan, LanesProgress, LanesSetup, MetricBound, plan_lanes, swept_share},
    metrics::DriveMetrics,
    smooth::{SmoothSetup, limits_of, smooth},
};
use processor_clock::Clock;
use robovac_core::{
    coverage::{PlanningGrid, ReachableFloor},
    floor_plan::{FloorPlan, SourceFile, generate::random_flat, load, room},
    robot::{RobotModel, model},
};
use std::{error::Error, fs, ops::ControlFlow};

const ROOMS: [&str; 8] = ["flat", "room12ft", "bedroom", "living", "hotel", "office", "warehouse", "hall20"];

/// A room by its id, seed or file.
fn plan_of(name: &str) -> Result<FloorPlan, Box<dyn Error>> {
    if let Ok(seed) = name.parse() {
        return Ok(random_flat(1 + (seed % 3) as u32, 1 + (seed % 2) as u32, seed));
    }
    match room(name) {
        Some(room) => Ok((room.build)()),
        None => Ok(load(&[SourceFile { name: name.into(), bytes: fs::read(name)? }])?),
    }
}

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

/// Lanes, searched for so many seconds; also what is known of the search, in a sentence.
fn search(
    floor: &ReachableFloor,
    robot: &RobotModel,
    setup: &LanesSetup,
    seconds: f64,
) -> Result<(LanesPlan, String), Box<dyn Error>> {
    let clock = Clock::start();
    let mut first = String::new();
    let mut observe = |progress: LanesProgress<'_>| {
        let now = clock.seconds();
        if first.is_empty() && !progress.path.is_empty() {
            let (minutes, percent) = (progress.duration_s / 60.0, 100.0 * progress.coverage);
            first = format!("First path after {now:.2} s: {minutes:.2} min, {percent:.2} %");
        }
        ControlFlow::Continue(now / seconds)
    };
    let found = plan_lanes(floor, robot, setup, &mut observe)?;
    let note = format!("{first}; {} corners after {:.0} s.", found.path.len(), clock.seconds());
    Ok((found, note))
}

/// The row of lanes with rounded corners, which has no bound of its own.
fn rounded(
    floor: &ReachableFloor,
    robot: &RobotModel,
    found: &LanesPlan,
    least: f64,
) -> Result<String, Box<dyn Error>> {
    let setup = SmoothSetup { loss: 0.0, least, clearance: found.clearance, ..SmoothSetup::default() };
    let path = smooth(floor, &found.path, &limits_of(robot)?, &setup);
    let (metres, minutes) = (path.trajectory.length_m(), path.trajectory.duration_s() / 60.0);
    Ok(format!("| lanes, rounded | {metres:.1} | {minutes:.2} | {:.2} | | |", 100.0 * path.coverage))
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
    let short = LanesSetup { objective: LanesObjective::Distance, ..setup };
    let curved = LanesSetup { is_rounded: true, ..setup };
    let chosen: Vec<&str> = arguments.iter().skip(3).map(String::as_str).collect();
    let robot = model("roomba600").ok_or("no such robot")?;
    for name in if chosen.is_empty() { &ROOMS[..] } else { &chosen[..] } {
        let floor = ReachableFloor::new(&plan_of(name)?, robot, None)?;
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
        let (found, note) = search(&floor, robot, &setup, seconds)?;
        println!("{}", row("lanes", &floor, robot, [found.length_m, found.duration_s, found.coverage]));
        let (shortest, _) = search(&floor, robot, &short, seconds)?;
        println!(
            "{}",
            row("lanes, shortest", &floor, robot, [shortest.length_m, shortest.duration_s, shortest.coverage])
        );
        let (found, _) = search(&floor, robot, &curved, seconds)?;
        println!("{}", rounded(&floor, robot, &found, setup.coverage)?);
        println!("\n{note}");
    }
    Ok(())
}
