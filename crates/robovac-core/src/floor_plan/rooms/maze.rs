//! A maze without loops.

use super::{RoomInfo, RoomKind};
use crate::{
    floor_plan::Sketch,
    grid::{Cell, Direction, Grid},
    rng::seeded,
};
use rand::RngExt;

/// Columns and rows of passages.
const SIZE: (usize, usize) = (10, 7);
/// From one passage to the next, m; the wall between them is one map cell thick.
const PITCH: f64 = 0.7;
/// Side of a map cell and thickness of a wall, m.
const CELL: f64 = 0.1;
/// A seed whose maze has both long ways and short dead ends.
const SEED: u64 = 8;

pub(super) const ROOM: RoomInfo = RoomInfo {
    id: "maze",
    title: "Maze",
    note: "Good for dead ends: every branch but one is a dead end, which shows the cost of driving back.",
    kind: RoomKind::Maze,
    is_benchmark: true,
    build: || carved(SEED, &[]).finish(ROOM.title, ROOM.note),
};

/// The maze of a seed, with more walls between neighbouring passages taken away.
pub(super) fn carved(seed: u64, more: &[(Cell, Cell)]) -> Sketch {
    let length = |passages: usize| passages as f64 * PITCH - CELL;
    let sketch = Sketch::solid(length(SIZE.0), length(SIZE.1), CELL);
    let sketch = openings(seed).iter().chain(more).fold(sketch, |sketch, (from, to)| {
        let low = (f64::from(from.x.min(to.x)) * PITCH, f64::from(from.y.min(to.y)) * PITCH);
        let high = (f64::from(from.x.max(to.x) + 1) * PITCH - CELL, f64::from(from.y.max(to.y) + 1) * PITCH - CELL);
        sketch.carve(&[[low.0, low.1, high.0, high.1]])
    });
    sketch.start(0.3, length(SIZE.1) - 0.3, 0.0)
}

/// Pairs of neighbouring passages without a wall between them: a random walk that backs up when it is stuck.
fn openings(seed: u64) -> Vec<(Cell, Cell)> {
    let mut rng = seeded(seed, 0);
    let mut seen = Grid::filled(SIZE.0, SIZE.1, false);
    let mut trail = vec![Cell::new(0, SIZE.1 as i32 - 1)];
    let mut openings = Vec::new();
    while let Some(&cell) = trail.last() {
        seen[cell] = true;
        let ways: Vec<Cell> =
            Direction::ALL.map(|d| cell.step(d)).into_iter().filter(|&c| seen.get(c) == Some(&false)).collect();
        if ways.is_empty() {
            trail.pop();
        } else {
            let next = ways[rng.random_range(0..ways.len())];
            openings.push((cell, next));
            trail.push(next);
        }
    }
    openings
}
