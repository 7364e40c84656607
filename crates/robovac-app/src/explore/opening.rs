//! The precomputed plan of the opening scene, so that the first load needs no planner.
//!
//! It equals the planner's result for the opening scene: `tests/opening.rs` compares the two, and writes the file again
//! when it is run with `UPDATE=1`.

use coverage_planners::{Proof, metrics::SweepBound};
use robovac_core::grid::{Cell, Direction};

/// The walk, see [`to_runs`].
pub const WALK: &str = include_str!("opening.txt");

/// Its proof, in steps + 2 x quarter turns.
pub const PROOF: Proof = Proof { cost: 4618, bound: 4037 };

/// What any path needs that sweeps as much, see [`MetricExcess`](coverage_planners::metrics::MetricExcess).
pub const LEAST: SweepBound = SweepBound { coverage: 0.9856, length_m: 273.42, duration_s: 932.94 };

const LETTERS: [(char, Direction); 4] =
    [('R', Direction::Right), ('U', Direction::Up), ('L', Direction::Left), ('D', Direction::Down)];

/// A walk as straight runs: `R12 U1 L12` goes twelve cells to the right, one up and twelve back.
pub fn to_runs(cells: &[Cell]) -> String {
    let mut runs: Vec<(Direction, usize)> = Vec::new();
    for direction in cells.windows(2).filter_map(|pair| pair[0].direction_to(pair[1])) {
        match runs.last_mut() {
            Some((last, count)) if *last == direction => *count += 1,
            _ => runs.push((direction, 1)),
        }
    }
    let words = runs.iter().map(|(direction, count)| {
        let letter = LETTERS.iter().find(|(_, d)| d == direction).map_or(' ', |&(letter, _)| letter);
        format!("{letter}{count}")
    });
    words.collect::<Vec<_>>().join(" ")
}

/// The walk from `start` by the text of [`to_runs`]; invalid runs are skipped.
pub fn from_runs(start: Cell, runs: &str) -> Vec<Cell> {
    let mut cells = vec![start];
    let mut at = start;
    for run in runs.split_ascii_whitespace() {
        for &(_, direction) in LETTERS.iter().filter(|(letter, _)| run.starts_with(*letter)) {
            for _ in 0..run[1..].parse().unwrap_or(0_usize) {
                at = at.step(direction);
                cells.push(at);
            }
        }
    }
    cells
}
