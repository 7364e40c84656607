//! Stage: distances between the ends of blocks.

use super::{
    cost::{Costs, fewest_turns},
    flood::Flood,
    order::Visit,
    sweep::{BlockSweep, SWEEPS},
};
use crate::PlanError;
use robovac_core::grid::{Cell, Direction, Grid};
use std::ops::ControlFlow;

/// Cost of the way from one sweep to the next, for all pairs of them.
///
/// Steps are those of shortest paths between cells not too far apart, and estimated beyond; turns are those of a way
/// without detour. So it guides the search for a good order and isn't the cost of the final walk.
#[derive(Debug)]
pub struct Links<'a> {
    sweeps: &'a [[BlockSweep; SWEEPS]],
    costs: Costs,
    start: SweepEnd,
    /// Where each sweep begins.
    entries: Vec<[SweepEnd; SWEEPS]>,
    /// Where each sweep ends.
    exits: Vec<[SweepEnd; SWEEPS]>,
    corners: usize,
    /// Cost of ways between corners without the turns of a way without detour, row by row; the start is corner 0.
    ways: Vec<u32>,
    /// Cost of the steps between the nearest corners of two blocks, row by row.
    nearest: Vec<u32>,
    /// Cost of the cheapest sweep of every block.
    cheapest: Vec<u32>,
}

/// One end of a sweep.
#[derive(Debug, Clone, Copy)]
struct SweepEnd {
    cell: Cell,
    heading: Option<Direction>,
    /// Number of the corner that it's in.
    corner: u32,
}

/// Corners between two reports.
const REPORT_EVERY: usize = 64;
/// Not a corner.
const NONE: u32 = u32::MAX;
/// Sweeps that start at the four corners of a block.
const CORNERS: [usize; 4] = [0, 2, 4, 5];
/// Steps that a detour adds to the straight distance where no path was searched, as a divisor of it.
const DETOUR_SHARE: u32 = 4;
/// Turns of an estimated way beyond those of one without detour.
const DETOUR_TURNS: u32 = 2;

impl<'a> Links<'a> {
    /// Searches `reach` cells around every corner. `report` receives the share of corners done every few dozen.
    pub fn new(
        free: &Grid<bool>,
        sweeps: &'a [[BlockSweep; SWEEPS]],
        start: (Cell, Direction),
        costs: Costs,
        reach: usize,
        report: impl FnMut(f64) -> Result<(), PlanError>,
    ) -> Result<Self, PlanError> {
        let mut flood = Flood::new(free);
        let frame = flood.frame();
        let mut numbers = frame.filled(NONE);
        let mut corners = Vec::new();
        let mut number = |cell: Cell| {
            let number = &mut numbers[frame.index(cell)];
            if *number == NONE {
                *number = corners.len() as u32;
                corners.push(cell);
            }
            *number
        };
        let mut end = |cell, heading| SweepEnd { cell, heading, corner: number(cell) };
        let start = end(start.0, Some(start.1));
        let entries: Vec<_> = sweeps.iter().map(|all| all.each_ref().map(|s| end(s.entry, s.entering))).collect();
        let exits = sweeps.iter().map(|all| all.each_ref().map(|s| end(s.exit, s.leaving))).collect();
        let steps = steps_between(&mut flood, &corners, &numbers, reach, report)?;
        let cheapest = sweeps.iter().map(|all| all.iter().map(|s| s.cost).min().unwrap_or(0)).collect();
        let nearest = nearest_corners(&entries, &steps, corners.len()).iter().map(|&s| s * costs.step).collect();
        let ways = costs_of_ways(&corners, steps, costs);
        Ok(Self { sweeps, costs, start, entries, exits, corners: corners.len(), ways, nearest, cheapest })
    }

    /// Costs of steps and turns.
    pub fn costs(&self) -> Costs {
        self.costs
    }

    /// The sweep of a visit.
    pub fn sweep(&self, visit: Visit) -> &BlockSweep {
        &self.sweeps[visit.block][visit.sweep]
    }

    /// Cost of the steps between the corners of two blocks that are nearest to each other.
    pub fn nearest_cost(&self, a: usize, b: usize) -> u32 {
        self.nearest[a * self.sweeps.len() + b]
    }

    /// Cost of a block's cheapest sweep.
    pub fn cheapest(&self, block: usize) -> u32 {
        self.cheapest[block]
    }

    /// Cost of the way from the end of `from` to the beginning of `to`; from the start, or to nowhere, if `None`.
    #[inline]
    pub fn between(&self, from: Option<Visit>, to: Option<Visit>) -> u32 {
        let Some(to) = to else { return 0 };
        let from = from.map_or(&self.start, |from| &self.exits[from.block][from.sweep]);
        let to = &self.entries[to.block][to.sweep];
        self.ways[from.corner as usize * self.corners + to.corner as usize]
            + self.costs.turn * fewest_turns(from.cell, from.heading, to.cell, to.heading)
    }
}

/// Costs of ways between corners from their steps; without the turns of a way without detour.
fn costs_of_ways(corners: &[Cell], mut steps: Vec<u32>, costs: Costs) -> Vec<u32> {
    for (from, row) in corners.iter().zip(steps.chunks_mut(corners.len())) {
        for (to, steps) in corners.iter().zip(row) {
            let turns = if *steps == from.manhattan(*to) { 0 } else { DETOUR_TURNS };
            *steps = *steps * costs.step + turns * costs.turn;
        }
    }
    steps
}

/// Steps of shortest paths between all pairs of corners, estimated for those that aren't among the `reach` cells nearest
/// to each other.
fn steps_between(
    flood: &mut Flood,
    corners: &[Cell],
    numbers: &[u32],
    reach: usize,
    mut report: impl FnMut(f64) -> Result<(), PlanError>,
) -> Result<Vec<u32>, PlanError> {
    let mut steps = Vec::with_capacity(corners.len() * corners.len());
    for from in corners {
        steps.extend(corners.iter().map(|to| from.manhattan(*to) + from.manhattan(*to) / DETOUR_SHARE + 1));
    }
    for (number, (&from, row)) in corners.iter().zip(steps.chunks_mut(corners.len())).enumerate() {
        if number % REPORT_EVERY == 0 {
            report(number as f64 / corners.len() as f64)?;
        }
        let mut left = reach;
        flood.search(from, |index, steps| {
            if left == 0 {
                return ControlFlow::Break(());
            }
            left -= 1;
            if numbers[index] != NONE {
                row[numbers[index] as usize] = steps;
            }
            ControlFlow::Continue(())
        });
    }
    make_symmetric(&mut steps, corners.len());
    Ok(steps)
}

/// Steps between the nearest corners of all pairs of blocks.
fn nearest_corners(entries: &[[SweepEnd; SWEEPS]], steps: &[u32], corners: usize) -> Vec<u32> {
    let mut nearest = Vec::with_capacity(entries.len() * entries.len());
    for a in entries {
        nearest.extend(entries.iter().map(|b| {
            let pairs = CORNERS
                .iter()
                .flat_map(|&s| CORNERS.map(|t| steps[a[s].corner as usize * corners + b[t].corner as usize]));
            pairs.min().unwrap_or(0)
        }));
    }
    nearest
}

/// Uses a distance found by one search only in both directions.
fn make_symmetric(steps: &mut [u32], side: usize) {
    for a in 0..side {
        for b in 0..a {
            // An estimate is never below the truth by more than a detour, so the smaller one is at least as good.
            let least = steps[a * side + b].min(steps[b * side + a]);
            steps[a * side + b] = least;
            steps[b * side + a] = least;
        }
    }
}
