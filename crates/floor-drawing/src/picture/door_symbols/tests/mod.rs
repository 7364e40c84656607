//! Doors of generated plans go, and all else stays.

mod plan;
mod sheet;

use super::*;
use crate::{DrawingRegion, Picture, ShadeMethod, Tracing, WallShades, trace_picture};
use plan::drawn_plan;
use robovac_core::{
    grid::{chessboard, largest_part, reachable},
    rng::{normal, seeded},
};

/// The picture without symbols of doors.
fn without(drawn: &Grid<bool>) -> Grid<bool> {
    let mut left = drawn.clone();
    remove(&mut left);
    left
}

/// How many pixels are dark in one and not in the other.
fn more(one: &Grid<bool>, other: &Grid<bool>) -> usize {
    one.values().iter().zip(other.values()).filter(|(one, other)| **one && !**other).count()
}

/// Every door of the plans of these seeds becomes passable, and nothing else changes.
fn only_doors_go(seeds: std::ops::Range<u64>) {
    let (mut doors, mut closed) = (0, 0);
    for seed in seeds {
        let plan = drawn_plan(seed);
        let left = without(&plan.drawn.cells);
        let [before, moves] = [&plan.drawn.cells, &left].map(chessboard);
        assert!(!plan.doors.iter().any(|door| plan.is_passable(door, &before)), "{seed}");
        doors += plan.doors.len();
        closed += plan.doors.iter().filter(|door| !plan.is_passable(door, &moves)).count();
        assert_eq!(more(&left, &plan.drawn.cells), 0, "{seed}");
        // But for corners of turned walls.
        let lost = more(&plan.bare.cells, &left) as f64;
        assert!(lost <= 0.001 * plan.bare.cells.count() as f64, "{seed}: {lost}");
        assert_eq!(without(&plan.bare.cells), plan.bare.cells, "{seed}");
    }
    assert!(closed == 0, "{closed} of {doors}");
}

// slow: large pictures; more of them are the soak's
#[test]
fn doors_become_passable_and_all_else_stays() {
    only_doors_go(0..4);
}

#[test]
#[ignore = "a minute: all styles of doors, pictures that are turned or have broken lines"]
fn doors_of_many_plans_become_passable_and_all_else_stays() {
    only_doors_go(4..24);
}

/// Cells of the traced room that a robot 35 cm wide reaches.
fn reached(cells: &Grid<bool>, scale: f64) -> usize {
    let shades = cells.map(|&is_dark| if is_dark { 30 } else { 240 });
    let specks = 0.15 * scale;
    let how = WallShades { method: ShadeMethod::Level, level: 0.5, contrast: 0.15, negate: false, specks };
    let picture = Picture { name: String::new(), blocked: how.cells(&shades).map(|cell| !cell.is_free()), turn: 0.0 };
    let tracing = Tracing {
        roles: Vec::new(),
        metre: 1.0 / scale,
        gap: 0.1,
        resolution: 0.05,
        region: DrawingRegion::Indoors { outer: 1.25 },
    };
    let plan = trace_picture(&picture, &tracing).unwrap().plan;
    let free = chessboard(&plan.occupancy.map(|cell| !cell.is_free())).map(|&moves| moves >= 4);
    largest_part(&free).map_or(0, |start| reachable(&free, start).count())
}

#[test]
fn a_robot_reaches_the_rooms_of_a_traced_picture() {
    for seed in [1, 4] {
        let plan = drawn_plan(seed);
        let [found, whole] = [&plan.drawn, &plan.bare].map(|sheet| reached(&sheet.cells, sheet.scale) as f64);
        assert!(found >= 0.95 * whole && whole > 0.0, "{seed}: {found} of {whole}");
    }
}

#[test]
fn noise_and_walls_drawn_as_outlines_stay() {
    let mut rng = seeded(1, 0);
    let noise = Grid::from_rows(400, (0..400 * 300).map(|_| normal(&mut rng) > 1.5).collect()).unwrap();
    assert_eq!(without(&noise), noise);
    let outlines = drawn_plan(6).drawn.cells;
    let depth = chessboard(&outlines.map(|&is_dark| !is_dark));
    let outlines = depth.map(|&moves| moves == 1);
    assert_eq!(without(&outlines), outlines);
}
