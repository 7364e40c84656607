//! The snake in a room that it discovers.

use super::support::{conditions, drive, lay_out, run, run_with};
use coverage_planners::{CoverageJob, PlanContext};
use rand::RngExt;
use robovac_core::{
    floor_plan::{
        FloorPlan, Sketch,
        generate::{FlatSpec, generate_flat},
    },
    geometry::{Point, Vector},
    grid::{Cell, Direction, from_picture},
    registry::{ParamValue, Params},
    rng::seeded,
    robot::model,
};
use robovac_sim::{NoiseLevel, controller};
use std::collections::BTreeSet;

/// Side of the preset's cells, m: the tool's width of the `CBot`.
const CELL: f64 = 0.2;
/// From a wall to the centre of the first cell, m: the body and two centimetres.
const EDGE: f64 = 0.24;

/// The preset of the thesis' program, laid out so that the `CBot`'s body fits exactly into the cells that are free there.
fn preset() -> FloorPlan {
    let centre = |cell: u32| EDGE + CELL * f64::from(cell);
    let side = centre(7) + EDGE;
    Sketch::open(side, side, 0.02)
        .fill(&[
            [centre(2) + EDGE, centre(4) + EDGE, centre(5) - EDGE, side],
            [0.0, 0.0, centre(2) - EDGE, centre(2) - EDGE],
        ])
        .start(EDGE, centre(7), 0.0)
        .finish("Preset", "The thesis' 8 x 8 cells")
}

#[test]
fn with_perfect_sensing_it_walks_the_preset_as_planned() {
    let rows = ["...##...", "...##...", "...##...", "........", "........", "........", "##......", "##......"];
    let free = from_picture(&rows.join("\n"), |c| c == '.').unwrap();
    let job = CoverageJob::new(&free, Cell::new(0, 7), Direction::Right).unwrap();
    let planner = coverage_planners::find("snake").unwrap();
    let planner = planner.build(&Params::defaults(planner.params));
    let planned = planner.plan(&job, &mut PlanContext::new(0)).unwrap().cells;

    let (info, robot) = (controller::find("online_snake").unwrap(), model("cbot").unwrap());
    let mut params = Params::defaults(info.params);
    params.set(info.params, "cell", ParamValue::Number(100.0)).unwrap();
    let setup = lay_out(&preset(), robot, conditions(NoiseLevel::Off)).unwrap();
    let mut run = run_with(&setup, info, &params, 1);
    let mut walk: Vec<Cell> = Vec::new();
    while !run.is_finished() && run.time_s() < 600.0 {
        run.step();
        let at = (run.pose().position() - Point::new(EDGE, EDGE)) / CELL;
        let cell = Cell::new(at.x.round() as i32, at.y.round() as i32);
        let is_there = (at.x - f64::from(cell.x)).hypot(at.y - f64::from(cell.y)) < 0.3;
        if is_there && walk.last() != Some(&cell) {
            walk.push(cell);
        }
    }
    assert!(run.is_finished(), "it is {} after {} s", run.activity(), run.time_s());
    assert_eq!(walk, planned);
}

/// A room of some 9 m² with three pieces of furniture.
fn furnished(seed: u64) -> FloorPlan {
    let mut rng = seeded(seed, 70);
    let (width, height) = (rng.random_range(3.0..4.0), rng.random_range(2.4..3.0));
    let mut sketch = Sketch::open(width, height, 0.05);
    for _ in 0..3 {
        let (x, y) = (rng.random_range(0.9..width - 0.5), rng.random_range(0.7..height - 0.5));
        let (w, h) = (rng.random_range(0.1..0.8), rng.random_range(0.1..0.8));
        sketch = sketch.fill(&[[x, y, x + w, y + h]]);
    }
    sketch.start(0.4, 0.4, 0.0).finish("Furnished", "Made by a seed")
}

/// Share of the cells that it came to, of those on its grid that the body reaches with two centimetres to spare.
fn cleaned(robot: &str, seed: u64) -> f64 {
    let (info, robot) = (controller::find("online_snake").unwrap(), model(robot).unwrap());
    let setup = lay_out(&furnished(seed), robot, conditions(NoiseLevel::Typical)).unwrap();
    let mut run = run(&setup, info, seed);
    let (start, side) = (run.pose().position(), 0.75 * robot.tool_width);
    let centre = |cell: Cell| start + Vector::new(f64::from(cell.x), f64::from(cell.y)) * side;
    let (mut reached, mut queue) = (BTreeSet::new(), vec![Cell::new(0, 0)]);
    while let Some(cell) = queue.pop() {
        if reached.insert(cell) {
            let has_room = |cell: &Cell| setup.floor.walls.has_room(centre(*cell), robot.radius + 0.02);
            queue.extend(cell.neighbours().into_iter().filter(has_room));
        }
    }
    let mut visited = BTreeSet::new();
    while !run.is_finished() && run.time_s() < 3600.0 {
        run.step();
        let at = (run.pose().position() - start) / side;
        visited.insert(Cell::new(at.x.round() as i32, at.y.round() as i32));
    }
    assert!(run.is_finished(), "{} {seed}: it is {} after {} s", robot.id, run.activity(), run.time_s());
    let share = reached.intersection(&visited).count() as f64 / reached.len() as f64;
    let (coverage, time) = (100.0 * run.coverage(), run.time_s());
    println!(
        "{} {seed}: {:.1} % of its cells, {coverage:.1} % of the floor after {time:.0} s",
        robot.id,
        100.0 * share
    );
    share
}

#[test]
fn it_comes_to_the_cells_of_rooms_that_nobody_has_seen_and_ends() {
    assert!(cleaned("cbot", 1) > 0.95);
}

#[test]
fn cells_beside_walls_that_noise_opens_and_closes_do_not_keep_it() {
    // It went to and fro between two cells for 24 minutes, and was done after 76.
    assert!(cleaned("roomba600_lidar", 6) > 0.95);
}

#[test]
fn narrow_places_of_flats_that_nobody_has_seen_do_not_end_it() {
    let (info, robot) = (controller::find("online_snake").unwrap(), model("cbot").unwrap());
    for flat in [7, 8] {
        let plan = generate_flat(flat, &FlatSpec::default());
        let setup = lay_out(&plan, robot, conditions(NoiseLevel::Typical)).unwrap();
        let mut run = run(&setup, info, 1);
        // It was done after 3 and 6 minutes when what noise or a corner had closed stayed closed.
        drive(&mut run, 7.0);
        while run.coverage() <= 0.3 && run.time_s() < 600.0 && !run.is_finished() {
            drive(&mut run, 0.5);
        }
        let coverage = run.coverage();
        assert!(!run.is_finished() && coverage > 0.3, "{flat}: {coverage} after {} s", run.time_s());
    }
}

#[test]
#[ignore = "soak: twenty rooms with each robot"]
fn it_comes_to_the_cells_of_many_rooms_that_nobody_has_seen() {
    for robot in ["cbot", "roomba600_lidar"] {
        let mut shares: Vec<f64> = (1..=20).map(|seed| cleaned(robot, seed)).collect();
        shares.sort_by(f64::total_cmp);
        assert!(shares[0] > 0.8 && shares[10] > 0.95, "{robot}: {shares:?}");
    }
}
