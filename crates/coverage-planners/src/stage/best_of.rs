//! Stage: the cheapest of several walks.

use super::{
    cost::Costs,
    greedy_walk::{WalkRule, greedy_walk},
    shortcut::shortcut,
    told::{Reasons, tell_walk},
    transit::Transit,
};
use crate::{CoverageJob, CoveragePath, PlanContext, PlanError};
use robovac_core::grid::Cell;

/// Largest room, in free cells, for which planners try all their variants.
pub(crate) const MAX_CELLS_FOR_ALL: usize = 100_000;

/// Takes walks one by one, cuts their detours, keeps the cheapest and reports it.
pub(crate) struct BestOf<'j> {
    pub job: &'j CoverageJob,
    pub costs: Costs,
    transit: Transit,
    /// Number of walks that will be offered.
    tries: usize,
    offered: usize,
    best: Vec<Cell>,
    cost: u64,
    /// Number of the best walk.
    winner: usize,
}

/// Share of the work on a walk that is done before its detours are cut.
const MADE: f64 = 0.8;

impl<'j> BestOf<'j> {
    /// A comparison of `tries` walks for `job`.
    pub fn new(job: &'j CoverageJob, tries: usize) -> Self {
        let costs = Costs::of(job);
        let transit = Transit::new(&job.free, costs);
        Self { job, costs, transit, tries, offered: 0, best: Vec::new(), cost: u64::MAX, winner: 0 }
    }

    /// Reports the share of the next walk that is made.
    pub fn report(&self, ctx: &mut PlanContext<'_>, share: f64) -> Result<(), PlanError> {
        ctx.checkpoint((self.offered as f64 + MADE * share) / self.tries as f64, &self.best)
    }

    /// Offers the walk of a robot that follows `rule` ([`greedy_walk`]).
    pub fn greedy_walk(&mut self, ctx: &mut PlanContext<'_>, rule: &mut dyn WalkRule) -> Result<(), PlanError> {
        let (offered, tries, best) = (self.offered as f64, self.tries as f64, &self.best);
        let walk = greedy_walk(self.job, &mut self.transit, rule, &mut |share, walk| {
            ctx.checkpoint((offered + MADE * share) / tries, if best.is_empty() { walk } else { best })
        })?;
        self.offer(ctx, walk)
    }

    /// Offers a walk, its detours cut ([`shortcut`]).
    pub fn offer(&mut self, ctx: &mut PlanContext<'_>, mut walk: Vec<Cell>) -> Result<(), PlanError> {
        if self.best.is_empty() && ctx.is_observed() {
            // Shown meanwhile; without a cost, so that the offered walk replaces it.
            self.best.clone_from(&walk);
        }
        let (offered, tries, best) = (self.offered as f64, self.tries as f64, &self.best);
        shortcut(self.job, self.costs, &mut self.transit, &mut walk, |share| {
            ctx.checkpoint((offered + MADE + (1.0 - MADE) * share) / tries, best)
        })?;
        let cost = self.costs.of_walk(self.job.heading, &walk);
        if cost < self.cost {
            (self.best, self.cost, self.winner) = (walk, cost, self.offered);
        }
        self.offered += 1;
        Ok(())
    }

    /// How many walks were offered before the cheapest.
    pub fn winner(&self) -> usize {
        self.winner
    }

    /// The cheapest walk, made by `reasons`.
    pub fn finish(self, ctx: &mut PlanContext<'_>, reasons: &mut dyn Reasons) -> CoveragePath {
        tell_walk(ctx, self.job, &self.best, reasons);
        CoveragePath::walk(self.best)
    }
}
