//! Stage: parts of a room with their lane direction, and the walk along a tour of them.

use super::{
    axis::{swap_cell, swap_direction, swap_walk},
    cost::Costs,
    decompose::Block,
    order::Visit,
    sweep::{BlockSweep, SWEEPS, append_sweep, sweeps_of},
    transit::{Transit, TransitEnd},
};
use crate::{CoverageJob, PlanError};
use robovac_core::grid::Cell;

/// A block that is mown along x or along y.
#[derive(Debug, Clone)]
pub struct MownBlock {
    /// Its runs, with x and y swapped if it's mown along y.
    pub block: Block,
    /// Whether it's mown along y.
    pub is_swapped: bool,
}

impl MownBlock {
    /// All ways through it.
    pub fn sweeps(&self, costs: Costs) -> [BlockSweep; SWEEPS] {
        let sweeps = sweeps_of(&self.block, costs);
        if !self.is_swapped {
            return sweeps;
        }
        sweeps.map(|sweep| BlockSweep {
            entry: swap_cell(sweep.entry),
            entering: sweep.entering.map(swap_direction),
            exit: swap_cell(sweep.exit),
            leaving: sweep.leaving.map(swap_direction),
            cost: sweep.cost,
        })
    }

    /// Every lane of it as a part of its own.
    pub fn lanes(self) -> impl Iterator<Item = Self> {
        let Self { block, is_swapped } = self;
        block.into_iter().map(move |run| Self { block: vec![run], is_swapped })
    }

    /// Appends the cells of sweep number `number` to `walk`; its first cell only if the walk doesn't end there already.
    fn append(&self, number: usize, costs: Costs, walk: &mut Vec<Cell>) {
        if !self.is_swapped {
            append_sweep(&self.block, number, costs, walk);
            return;
        }
        let mut way = Vec::new();
        append_sweep(&self.block, number, costs, &mut way);
        swap_walk(&mut way);
        let is_there = walk.last() == way.first();
        walk.extend_from_slice(&way[usize::from(is_there)..]);
    }
}

/// Parts between two reports while driving.
const REPORT_EVERY: usize = 256;

/// The walk that a tour of `parts` stands for.
pub fn drive(
    job: &CoverageJob,
    costs: Costs,
    parts: &[MownBlock],
    sweeps: &[[BlockSweep; SWEEPS]],
    tour: &[Visit],
    transit: &mut Transit,
    mut report: impl FnMut(f64) -> Result<(), PlanError>,
) -> Result<Vec<Cell>, PlanError> {
    let mut walk = Vec::with_capacity(job.cells() * 17 / 16);
    walk.push(job.start);
    for (i, visit) in tour.iter().enumerate() {
        if i % REPORT_EVERY == 0 {
            report(i as f64 / tour.len() as f64)?;
        }
        let sweep = &sweeps[visit.block][visit.sweep];
        let heading = if let [.., before, last] = *walk { before.direction_to(last) } else { Some(job.heading) };
        let from = TransitEnd { cell: walk[walk.len() - 1], heading };
        let to = TransitEnd { cell: sweep.entry, heading: sweep.entering };
        // All free cells are connected, so a way exists.
        let _ = transit.append_way(from, to, u32::MAX, &mut walk);
        parts[visit.block].append(visit.sweep, costs, &mut walk);
    }
    Ok(walk)
}
