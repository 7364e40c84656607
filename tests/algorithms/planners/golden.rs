//! Walks that must stay as they are: a change here is a change of an algorithm.

use super::support::{EIGHT, drawn};
use coverage_planners::{CoverageJob, CoveragePath, PlanContext, find, metrics::WalkMetrics};
use robovac_core::{
    grid::{Cell, Direction},
    registry::Params,
};

fn walk(id: &str, picture: &str, heading: Direction) -> (CoverageJob, CoveragePath) {
    let free = drawn(picture);
    let top_left = Cell::new(0, free.height() as i32 - 1);
    let job = CoverageJob::new(&free, top_left, heading).expect("the start is free");
    let info = find(id).expect("the planner exists");
    let planner = info.build(&Params::defaults(info.params));
    let path = planner.plan(&job, &mut PlanContext::new(0)).expect("nobody cancels");
    (job, path)
}

#[test]
fn snake_walks_as_the_printed_program_on_its_own_room() {
    let expected: Vec<Cell> = include_str!("../../golden/snake_8x8_program.txt")
        .lines()
        .filter(|line| !line.starts_with(';'))
        .map(|line| {
            let (x, y) = line.split_once(' ').expect("column and row");
            Cell::new(x.parse().expect("a column"), y.parse().expect("a row"))
        })
        .collect();
    let (job, path) = walk("snake", EIGHT, Direction::Right);
    assert_eq!(path.cells, expected);
    let metrics = WalkMetrics::of(&job, &path);
    assert_eq!((metrics.visited_cells, metrics.steps, metrics.revisits), (54, 65, 12));
    let changes = path.cells.windows(3).filter(|w| w[0].direction_to(w[1]) != w[1].direction_to(w[2])).count();
    assert_eq!(changes, 32);
}

/// Draws walks as in `CoveragePath::arrows`, with what they cost; room and heading are those that the name says.
fn assert_drawn(id: &str, room: &str, heading: Direction, expected: &str) {
    let (job, path) = walk(id, room, heading);
    let metrics = WalkMetrics::of(&job, &path);
    let drawn = format!("{}steps {} turns {}\n", path.arrows(&job), metrics.steps, metrics.turns);
    assert_eq!(drawn, expected, "{id} walks\n{drawn}");
}

const ISLANDS: &str = "
    ............
    .##.....###.
    .##..#..###.
    .....#......
    ..##.#......
    ..##........
    ............";

/// Room for one spiral, and scraps.
const OPEN: &str = "
    ...........
    ...........
    ...........
    ...........
    ...........
    ...........
    ...........
    .........##
    .........##";

#[test]
fn snake_round_islands() {
    assert_drawn("snake", ISLANDS, Direction::Right, include_str!("../../golden/snake_islands.txt"));
}

#[test]
fn snake_facing_down_on_the_thesis_room() {
    assert_drawn("snake", EIGHT, Direction::Down, include_str!("../../golden/snake_8x8_down.txt"));
}

#[test]
fn boustrophedon_round_islands() {
    assert_drawn("boustrophedon", ISLANDS, Direction::Right, include_str!("../../golden/boustrophedon_islands.txt"));
}

#[test]
fn boustrophedon_on_the_thesis_room() {
    assert_drawn("boustrophedon", EIGHT, Direction::Right, include_str!("../../golden/boustrophedon_8x8.txt"));
}

#[test]
fn contour_round_islands() {
    assert_drawn("contour", ISLANDS, Direction::Right, include_str!("../../golden/contour_islands.txt"));
}

#[test]
fn s_shape_round_islands() {
    assert_drawn("s_shape", ISLANDS, Direction::Right, include_str!("../../golden/s_shape_islands.txt"));
}

#[test]
fn subgoal_sweep_round_islands() {
    assert_drawn("subgoal_sweep", ISLANDS, Direction::Right, include_str!("../../golden/subgoal_sweep_islands.txt"));
}

#[test]
fn subgoal_sweep_on_the_thesis_room() {
    assert_drawn("subgoal_sweep", EIGHT, Direction::Right, include_str!("../../golden/subgoal_sweep_8x8.txt"));
}

#[test]
fn spiral_in_an_open_room() {
    assert_drawn("spiral", OPEN, Direction::Right, include_str!("../../golden/spiral_open.txt"));
}

#[test]
fn spiral_round_islands() {
    assert_drawn("spiral", ISLANDS, Direction::Right, include_str!("../../golden/spiral_islands.txt"));
}

#[test]
fn genetic_round_islands() {
    assert_drawn("genetic", ISLANDS, Direction::Right, include_str!("../../golden/genetic_islands.txt"));
}

#[test]
fn backtracking_spiral_round_islands() {
    assert_drawn(
        "backtracking_spiral",
        ISLANDS,
        Direction::Right,
        include_str!("../../golden/backtracking_spiral_islands.txt"),
    );
}

#[test]
fn backtracking_spiral_on_the_thesis_room() {
    assert_drawn(
        "backtracking_spiral",
        EIGHT,
        Direction::Right,
        include_str!("../../golden/backtracking_spiral_8x8.txt"),
    );
}

#[test]
fn spiral_stc_round_islands() {
    assert_drawn("spiral_stc", ISLANDS, Direction::Right, include_str!("../../golden/spiral_stc_islands.txt"));
}

#[test]
fn spiral_stc_on_the_thesis_room() {
    assert_drawn("spiral_stc", EIGHT, Direction::Right, include_str!("../../golden/spiral_stc_8x8.txt"));
}

#[test]
fn wavefront_distance_round_islands() {
    assert_drawn(
        "wavefront_distance",
        ISLANDS,
        Direction::Right,
        include_str!("../../golden/wavefront_distance_islands.txt"),
    );
}

#[test]
fn wavefront_distance_on_the_thesis_room() {
    assert_drawn(
        "wavefront_distance",
        EIGHT,
        Direction::Right,
        include_str!("../../golden/wavefront_distance_8x8.txt"),
    );
}

#[test]
fn wavefront_path_round_islands() {
    assert_drawn("wavefront_path", ISLANDS, Direction::Right, include_str!("../../golden/wavefront_path_islands.txt"));
}

#[test]
fn wavefront_path_on_the_thesis_room() {
    assert_drawn("wavefront_path", EIGHT, Direction::Right, include_str!("../../golden/wavefront_path_8x8.txt"));
}

#[test]
fn boustrophedon_cells_round_islands() {
    let expected = include_str!("../../golden/boustrophedon_cells_islands.txt");
    assert_drawn("boustrophedon_cells", ISLANDS, Direction::Right, expected);
}

#[test]
fn grid_tsp_round_islands() {
    assert_drawn("grid_tsp", ISLANDS, Direction::Right, include_str!("../../golden/grid_tsp_islands.txt"));
}

/// No walk costs less: both numbers have been proven with a MIP solver.
#[test]
fn grid_tsp_finds_the_optimum_of_the_thesis_room() {
    let (job, path) = walk("grid_tsp", EIGHT, Direction::Right);
    let metrics = WalkMetrics::of(&job, &path);
    assert_eq!((metrics.steps, metrics.turns), (53, 14));
}

#[test]
fn energy_round_islands() {
    assert_drawn("energy", ISLANDS, Direction::Right, include_str!("../../golden/energy_islands.txt"));
}

#[test]
fn energy_on_the_thesis_room() {
    assert_drawn("energy", EIGHT, Direction::Right, include_str!("../../golden/energy_8x8.txt"));
}

#[test]
fn neural_round_islands() {
    assert_drawn("neural", ISLANDS, Direction::Right, include_str!("../../golden/neural_islands.txt"));
}
