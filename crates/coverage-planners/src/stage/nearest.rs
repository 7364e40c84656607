//! Stage: a first order in which to visit blocks, from each to the nearest one left.

use super::{
    cost::Costs,
    flood::Flood,
    order::Visit,
    sweep::{BlockSweep, SWEEPS},
};
use crate::PlanError;
use robovac_core::grid::{Cell, Direction, Grid};
use std::ops::ControlFlow;

/// Goes from each block to the nearest one that is left, by the number of steps and turns of the way there and of the
/// sweep through it beyond its shortest. `report` receives the number of blocks done every few hundred.
pub fn nearest_first(
    free: &Grid<bool>,
    sweeps: &[[BlockSweep; SWEEPS]],
    start: (Cell, Direction),
    costs: Costs,
    mut report: impl FnMut(usize) -> Result<(), PlanError>,
) -> Result<Vec<Visit>, PlanError> {
    let mut search = Nearest::new(free, sweeps, costs);
    let mut tour = Vec::with_capacity(sweeps.len());
    let (mut at, mut heading) = start;
    while tour.len() < sweeps.len() {
        if tour.len() % REPORT_EVERY == 0 {
            report(tour.len())?;
        }
        // All blocks are connected, so a way to the next exists.
        let Some(visit) = search.next(at, heading) else { break };
        search.close(visit.block);
        let sweep = &sweeps[visit.block][visit.sweep];
        heading = sweep.leaving.unwrap_or(heading);
        at = sweep.exit;
        tour.push(visit);
    }
    Ok(tour)
}

/// Blocks between two reports.
const REPORT_EVERY: usize = 256;
/// No block.
const NONE: u32 = u32::MAX;

/// Breadth-first search for the next block.
struct Nearest<'a> {
    flood: Flood,
    sweeps: &'a [[BlockSweep; SWEEPS]],
    costs: Costs,
    /// The block left to visit that a sweep enters in a cell, or [`NONE`], by the flood's numbers.
    open: Vec<u32>,
}

impl<'a> Nearest<'a> {
    fn new(free: &Grid<bool>, sweeps: &'a [[BlockSweep; SWEEPS]], costs: Costs) -> Self {
        let flood = Flood::new(free);
        let mut open = flood.frame().filled(NONE);
        for (block, all) in sweeps.iter().enumerate() {
            for sweep in all {
                open[flood.frame().index(sweep.entry)] = block as u32;
            }
        }
        Self { flood, sweeps, costs, open }
    }

    /// Removes a block from the search.
    fn close(&mut self, block: usize) {
        for sweep in &self.sweeps[block] {
            self.open[self.flood.frame().index(sweep.entry)] = NONE;
        }
    }

    /// The open block that is cheapest to visit next.
    fn next(&mut self, from: Cell, heading: Direction) -> Option<Visit> {
        let Self { flood, sweeps, costs, open } = self;
        let frame = flood.frame();
        // The least cost so far, and the number of steps that alone cost as much.
        let (mut best, mut least, mut enough) = (None, u32::MAX, u32::MAX);
        flood.search(from, |index, steps| {
            if steps >= enough {
                return ControlFlow::Break(());
            }
            if open[index] != NONE {
                let block = open[index] as usize;
                if let Some((cost, sweep)) =
                    cheapest_entry(&sweeps[block], *costs, (from, heading), frame.cell(index), steps)
                    && cost < least
                {
                    (best, least, enough) = (Some(Visit { block, sweep }), cost, cost.div_ceil(costs.step));
                }
            }
            ControlFlow::Continue(())
        });
        best
    }
}

/// The sweep that is cheapest if entered in `entry`, `steps` from the robot, and its cost beyond the block's cheapest,
/// way included.
fn cheapest_entry(
    sweeps: &[BlockSweep; SWEEPS],
    costs: Costs,
    (from, heading): (Cell, Direction),
    entry: Cell,
    steps: u32,
) -> Option<(u32, usize)> {
    let shortest = sweeps.iter().map(|s| s.cost).min().unwrap_or(0);
    let detour = (steps - from.manhattan(entry)) * costs.step;
    let cost = |s: &BlockSweep| costs.at_least(from, Some(heading), entry, s.entering) + detour + s.cost - shortest;
    sweeps.iter().zip(0..).filter(|(s, _)| s.entry == entry).map(|(s, number)| (cost(s), number)).min()
}
