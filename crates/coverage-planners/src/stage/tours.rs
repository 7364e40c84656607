//! Stage: walks along tours of parts, of which the cheapest is kept.

use super::{
    best_of::MAX_CELLS_FOR_ALL,
    cost::Costs,
    distances::Links,
    nearest::nearest_first,
    order::{Visit, improve},
    part::{MownBlock, drive},
    shortcut::shortcut,
    sweep::{BlockSweep, SWEEPS},
    transit::Transit,
};
use crate::{CoverageJob, PlanContext, PlanError};
use robovac_core::{
    grid::Cell,
    rng::{Rng, seeded},
};

/// Puts parts in order, drives them, cuts detours, and keeps the cheapest walk.
///
/// Every stage gets the range of progress that it covers.
pub(crate) struct Tours<'j, 'c> {
    job: &'j CoverageJob,
    pub ctx: &'j mut PlanContext<'c>,
    pub costs: Costs,
    transit: Transit,
    /// Cells around every end of a part that are searched for shortest paths.
    reach: usize,
    rng: Rng,
    /// The cheapest walk so far; empty before the first.
    pub best: Vec<Cell>,
}

/// Passes over a walk to cut detours; the first one finds nearly all, and a large room gets no more.
const PASSES: usize = 3;

/// A share of the work between two stages.
pub(crate) fn between([from, to]: [f64; 2], done: f64) -> f64 {
    from + (to - from) * done.min(1.0)
}

impl<'j, 'c> Tours<'j, 'c> {
    /// No walk yet. `reach` cells around every end of a part are searched for shortest paths to others.
    pub fn new(job: &'j CoverageJob, ctx: &'j mut PlanContext<'c>, reach: usize) -> Self {
        let costs = Costs::of(job);
        let transit = Transit::new(&job.free, costs);
        // A fixed seed: the result doesn't depend on the run's.
        Self { job, ctx, costs, transit, reach, rng: seeded(0, 0), best: Vec::new() }
    }

    /// All ways through every part.
    pub fn sweeps(&self, parts: &[MownBlock]) -> Vec<[BlockSweep; SWEEPS]> {
        parts.iter().map(|part| part.sweeps(self.costs)).collect()
    }

    /// The parts in an order, nearest first.
    pub fn nearest_first(
        &mut self,
        sweeps: &[[BlockSweep; SWEEPS]],
        shares: [f64; 2],
    ) -> Result<Vec<Visit>, PlanError> {
        let Self { job, ctx, costs, best, .. } = self;
        nearest_first(&job.free, sweeps, (job.start, job.heading), *costs, |done| {
            ctx.checkpoint(between(shares, done as f64 / sweeps.len() as f64), best)
        })
    }

    /// Searches for a better order. `shares` are those before, after the ways between parts are known, and after.
    pub fn improve(
        &mut self,
        sweeps: &[[BlockSweep; SWEEPS]],
        tour: &mut Vec<Visit>,
        rounds: usize,
        [before, linked, after]: [f64; 3],
    ) -> Result<(), PlanError> {
        let Self { job, ctx, costs, reach, rng, best, .. } = self;
        let links = Links::new(&job.free, sweeps, (job.start, job.heading), *costs, *reach, |done| {
            ctx.checkpoint(between([before, linked], done), best)
        })?;
        improve(&links, tour, rounds, rng, |done| ctx.checkpoint(between([linked, after], done), best))
    }

    /// Drives a tour and [offers](Self::offer) the walk.
    pub fn drive(
        &mut self,
        parts: &[MownBlock],
        sweeps: &[[BlockSweep; SWEEPS]],
        tour: &[Visit],
        [before, after]: [f64; 2],
    ) -> Result<bool, PlanError> {
        let Self { job, ctx, costs, transit, best, .. } = self;
        let middle = f64::midpoint(before, after);
        let report = |done| ctx.checkpoint(between([before, middle], done), best);
        let walk = drive(job, *costs, parts, sweeps, tour, transit, report)?;
        self.offer(walk, [middle, after])
    }

    /// Cuts a walk's detours ([`shortcut`]) and keeps it if it's the cheapest; returns whether it is.
    pub fn offer(&mut self, mut walk: Vec<Cell>, shares: [f64; 2]) -> Result<bool, PlanError> {
        let Self { job, ctx, costs, transit, best, .. } = self;
        let passes = if job.cells() <= MAX_CELLS_FOR_ALL { PASSES } else { 1 };
        for pass in 0..passes {
            let report = |done| ctx.checkpoint(between(shares, (pass as f64 + done) / passes as f64), best);
            if !shortcut(job, *costs, transit, &mut walk, report)? {
                break;
            }
        }
        let cost = |walk: &[Cell]| costs.of_walk(job.heading, walk);
        let is_better = best.is_empty() || cost(&walk) < cost(best);
        if is_better {
            *best = walk;
        }
        Ok(is_better)
    }
}
