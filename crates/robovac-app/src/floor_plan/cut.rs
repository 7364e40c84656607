//! Floor that a robot can't get to: an arc of a door that was read as a wall, or a narrow door, is in its way.

use robovac_core::{
    floor_plan::FloorPlan,
    grid::{Cell, Grid, chessboard},
    math::ceil,
};
use std::collections::VecDeque;

/// Width of the passage that is asked about, m: a Roomba, the most usual robot, drives through it with a centimetre on either side, as
/// Explore asks for.
const PASSAGE: f64 = 0.37;
/// Cells with longer sides, m, are halved, as long as there are at most so many then: passages are measured in odd numbers of them.
const COARSE: (f64, usize) = (0.03, 2_000_000);
/// Least floor that is told about, m², and as a share of all (ours): less is a niche.
const LEAST: f64 = 0.5;
const LEAST_SHARE: f64 = 0.02;
/// No part.
const NONE: u32 = u32::MAX;

/// The floor that a robot can't get to from where it starts, or from the largest part of the floor; with its area, m².
/// `free` is the floor without objects. `None` if it is hardly any.
///
/// ```
/// use robovac_app::floor_plan::cut_off;
/// use robovac_core::floor_plan::Sketch;
/// // Two rooms, with a door of 0.9 m and one of 0.3 m.
/// let plan = |door: f64| Sketch::open(6.0, 4.0, 0.05).fill(&[[3.0, 0.0, 3.1, 2.0], [3.0, 2.0 + door, 3.1, 4.0]]).finish("", "");
/// let free = |door: f64| plan(door).occupancy.map(|cell| cell.is_free());
/// assert!(cut_off(&plan(0.9), &free(0.9)).is_none());
/// let (cells, area) = cut_off(&plan(0.3), &free(0.3)).unwrap();
/// assert!((area - 2.9 * 4.0).abs() < 0.5 && area < 0.5 * 23.8, "{area}");
/// // A Roomba, which is 0.35 m wide, gets through 0.4 m, and not through 0.35 m.
/// assert!(cut_off(&plan(0.4), &free(0.4)).is_none() && cut_off(&plan(0.35), &free(0.35)).is_some());
/// assert_eq!(cells.count() as f64 * 0.05 * 0.05, area);
/// ```
pub fn cut_off(plan: &FloorPlan, free: &Grid<bool>) -> Option<(Grid<bool>, f64)> {
    let by = if plan.resolution > COARSE.0 && 4 * free.len() <= COARSE.1 { 2 } else { 1 };
    let resolution = plan.resolution / f64::from(by);
    let mut fine = Grid::filled(by as usize * free.width(), by as usize * free.height(), false);
    for index in 0..fine.len() {
        let Cell { x, y } = fine.cell(index);
        fine.values_mut()[index] = free[Cell::new(x / by, y / by)];
    }
    let start = plan.start.map(|start| Cell::at(start.position(), resolution));
    let fine = cut_off_cells(&fine, resolution, start)?;
    let mut cut = free.map(|_| false);
    for index in 0..cut.len() {
        let Cell { x, y } = cut.cell(index);
        cut.values_mut()[index] = fine[Cell::new(by * x, by * y)];
    }
    let area = cut.count() as f64 * plan.resolution * plan.resolution;
    Some((cut, area))
}

/// The same for cells with sides of `resolution` m.
fn cut_off_cells(free: &Grid<bool>, resolution: f64, start: Option<Cell>) -> Option<Grid<bool>> {
    let moves = chessboard(&free.map(|&is_free| !is_free));
    // A square of 2 n - 1 cells lies around a cell that is n moves from the next wall.
    let least = ceil(f64::midpoint(PASSAGE / resolution, 1.0) - 1e-9).clamp(1, 250);
    let is_wide = |cell: Cell| moves.get(cell).is_some_and(|&moves| i32::from(moves) >= least);
    let mut parts = free.map(|_| NONE);
    let mut areas: Vec<usize> = Vec::new();
    let mut reached = VecDeque::new();
    for index in 0..parts.len() {
        let seed = parts.cell(index);
        if parts[seed] != NONE || !is_wide(seed) {
            continue;
        }
        let part = areas.len() as u32;
        areas.push(0);
        parts[seed] = part;
        let mut waiting = vec![seed];
        while let Some(cell) = waiting.pop() {
            reached.push_back((cell, 1));
            for next in cell.neighbours() {
                if is_wide(next) && parts[next] == NONE {
                    parts[next] = part;
                    waiting.push(next);
                }
            }
        }
    }
    // The squares themselves.
    while let Some((cell, away)) = reached.pop_front() {
        areas[parts[cell] as usize] += 1;
        for next in cell.block().filter(|_| away < least) {
            if free.is_set(next) && parts[next] == NONE {
                parts[next] = parts[cell];
                reached.push_back((next, away + 1));
            }
        }
    }
    let start = start.and_then(|start| parts.get(start));
    let largest = || (0..areas.len() as u32).max_by_key(|&part| areas[part as usize]);
    let home = start.copied().filter(|&part| part != NONE).or_else(largest)?;
    let cell = resolution * resolution;
    let area = |part: u32| areas[part as usize] as f64 * cell;
    let is_told = |part: u32| part != NONE && part != home && area(part) >= LEAST;
    let cut = parts.map(|&part| is_told(part));
    let area = cut.count() as f64 * cell;
    (area > LEAST_SHARE * free.count() as f64 * cell).then_some(cut)
}
