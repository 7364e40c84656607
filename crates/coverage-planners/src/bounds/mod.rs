//! Proven lower bounds on steps, turns and their weighted sum.
//!
//! A job has n free cells, 4-connected, and a start. A *walk* here starts there, visits every free cell, may visit cells
//! again, may end anywhere, and has S steps and T quarter turns between consecutive steps (a reversal counts two). For
//! n = 1 everything is 0; below, n is at least 2.
//!
//! **Steps, by connection** ([`cut_vertices`]). Take a cell c other than the start whose removal leaves k parts. One holds the
//! start; the walk enters each of the other k - 1 by a visit to c and, unless it ends inside, leaves it by a later one. So
//! c is visited at least k times, or k - 1 times if the walk ends in one of those k - 1 parts ("below c"). A start whose
//! removal leaves k parts is visited at least k times. With e(c) = k - 1 for all these cells, and 0 for the others,
//! S + 1 >= n + sum of e(c) - (number of such cells, other than the start, that the walk's end is below), and the end that
//! is below most of them gives the bound.
//!
//! **Steps, by colour.** Cells are coloured as on a chess board, and a walk's cells alternate. If b cells have the start's
//! colour and w have the other one, a walk with V visits to the latter has at most V + 1 to the former and at most one
//! step less than twice those. So S >= 2 b - 2 and S >= 2 w - 1.
//!
//! **Turns, by a square.** Suppose s x s cells are all free. Each of them is on a straight piece of the walk, along x or
//! along y. Either every row of the square has a piece along x, or some row has none and then all its s columns have a
//! piece along y. So there are s parallel pieces on s different lines, and going from a piece to one on another parallel
//! line takes at least two quarter turns: T >= 2 (s - 1).
//!
//! **Any weighted sum, by prices** ([`relaxation`]), with the visits that connection demands; the same for walks whose first
//! turn counts and for closed tours. By more work, strips of the room in place of cells make it stronger ([`strips`]).
//!
//! The bounds on steps and turns hold together, so step x S + turn x T is also at least the sum of both.

mod crossings;
mod cut_vertices;
mod diffusion;
mod dual_prices;
mod graph;
mod primal_dual;
mod profile_dp;
mod relaxation;
mod strips;
mod subgradient;
mod tiles;

use super::{CoverageJob, Objective};
use cut_vertices::CutVertices;
pub use dual_prices::{DualPrices, MOST_WEIGHT};
pub use graph::Graph;
pub use relaxation::Relaxation;
use robovac_core::grid::{Direction, Grid};
use serde::{Deserialize, Serialize};

/// Steps that a quarter turn counts as when steps and turns are combined into one number.
pub const TURN_STEPS: usize = 2;

/// Proven lower bounds for every walk that begins at a job's start, ends anywhere and visits all its cells.
///
/// A walk that reaches a bound is best possible in that number; often none does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Bounds {
    /// Fewest steps.
    pub steps: usize,
    /// Fewest quarter turns; a reversal counts two, the turn before the first step isn't counted.
    pub turns: usize,
    /// Least steps + [`TURN_STEPS`] x quarter turns; can exceed the sum of the two bounds above.
    pub cost: usize,
}

impl Bounds {
    /// The bounds of `job`, in time about proportional to its cells: half a second for a million. In larger rooms they
    /// can be further below what is achievable.
    ///
    /// ```
    /// use robovac_core::grid::{Cell, Direction, Grid};
    /// use coverage_planners::{Bounds, CoverageJob};
    /// // To and fro, 20 lanes: nothing is better.
    /// let job = CoverageJob::new(&Grid::filled(20, 20, true), Cell::new(0, 0), Direction::Right).unwrap();
    /// assert_eq!(Bounds::of(&job), Bounds { steps: 399, turns: 38, cost: 399 + 2 * 38 });
    /// ```
    pub fn of(job: &CoverageJob) -> Self {
        let (graph, cuts) = laid_out(job);
        let (steps, turns) = (fewest_steps(job, &cuts), fewest_turns(job, &graph, &cuts));
        let cost = least(&graph, &cuts, Objective::open(1, TURN_STEPS as u32)) as usize;
        Self { steps, turns, cost: cost.max(steps + TURN_STEPS * turns) }
    }

    /// Least step x steps + turn x quarter turns; weights above 4096 count as 4096.
    pub fn weighted(job: &CoverageJob, step: u32, turn: u32) -> u64 {
        let (step, turn) = (step.min(MOST_WEIGHT), turn.min(MOST_WEIGHT));
        let (graph, cuts) = laid_out(job);
        let parts = u64::from(step) * fewest_steps(job, &cuts) as u64
            + u64::from(turn) * fewest_turns(job, &graph, &cuts) as u64;
        least(&graph, &cuts, Objective::open(step, turn)).max(parts)
    }
}

fn laid_out(job: &CoverageJob) -> (Graph, CutVertices) {
    let graph = Graph::new(&job.free, job.start);
    let cuts = CutVertices::of(&graph);
    (graph, cuts)
}

fn least(graph: &Graph, cuts: &CutVertices, objective: Objective) -> u64 {
    let mut prices = DualPrices::new(graph, objective, Direction::Right);
    prices.diffuse(graph, 0, diffusion::effort(graph.len()));
    prices.bound(graph, cuts)
}

fn fewest_steps(job: &CoverageJob, cuts: &CutVertices) -> usize {
    if job.cells() < 2 {
        return 0;
    }
    let is_start_coloured = |x: i32, y: i32| (x + y + job.start.x + job.start.y) % 2 == 0;
    let same = job.free.iter().filter(|&(cell, &free)| free && is_start_coloured(cell.x, cell.y)).count();
    let other = job.cells() - same;
    cuts.fewest_steps().max(2 * same - 2).max(2 * other - 1)
}

fn fewest_turns(job: &CoverageJob, graph: &Graph, cuts: &CutVertices) -> usize {
    let by_square = 2 * largest_square(&job.free).saturating_sub(1);
    by_square.max(least(graph, cuts, Objective::open(0, 1)) as usize)
}

/// Side of the largest square of free cells.
fn largest_square(free: &Grid<bool>) -> usize {
    // The largest one that ends in a cell is one larger than the smallest of those that end left, below and diagonally.
    let mut sides = vec![0; free.width()];
    let mut largest = 0;
    for row in free.values().chunks_exact(free.width()) {
        let (mut left, mut below_left) = (0, 0);
        for (side, &is_free) in sides.iter_mut().zip(row) {
            let below = *side;
            left = if is_free { 1 + below.min(left).min(below_left) } else { 0 };
            (*side, below_left) = (left, below);
            largest = largest.max(left);
        }
    }
    largest
}
