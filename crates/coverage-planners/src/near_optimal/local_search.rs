//! Local search: the current walk, the best so far, the dual prices, and the effort left.

use super::{
    improver::{Improver, Settling},
    region::Ground,
    tour::Tour,
};
use crate::{
    CoverageJob, Finish, Objective, PlanContext, PlanError, Proof, Relaxation,
    stage::{Costs, Transit, TransitEnd, between},
};
use robovac_core::{
    grid::{Cell, Direction, Grid},
    rng::Rng,
};

/// State of a run.
pub(super) struct LocalSearch<'j> {
    job: &'j CoverageJob,
    objective: Objective,
    numbers: Grid<u32>,
    pub relaxation: Relaxation,
    improver: Improver,
    /// Noise of the next shake.
    noise: f64,
    /// The cells by their numbers, if the room is small enough to show every change of the walk.
    filmed: Vec<Cell>,
    /// The best walk so far, by the cells' numbers, and its cost in price units.
    best: (Vec<u32>, i64),
    /// The same walk for the observer, if there is one.
    pub shown: Vec<Cell>,
    /// The effort: ways to try in windows.
    most: usize,
    /// Whether the best walk is proven optimal by an exhaustive search.
    is_solved: bool,
}

/// No cell.
const NONE: u32 = u32::MAX;
/// Least and most noise of a shake in steps and quarter turns. It grows by a factor after every shake without
/// improvement and falls after every other, and so adapts to the room and the time spent (ours).
const NOISES: [f64; 2] = [0.3, 8.0];
const GROWS: f64 = 1.05;
const FALLS: f64 = 0.7;
/// Largest window of a shaken block, cells, and states kept: many quick windows find more than few thorough ones.
const SHAKEN: (i32, usize) = (12, 50);
/// Cells up to which every change of the walk is shown.
const MOST_FILMED: usize = 2_000;
/// Largest grid, walls included, that is solved exhaustively.
const LARGEST_SOLVED: usize = 1_000;
/// Cells visited to find the first prices, and at least between two reports meanwhile.
const HASTY: usize = 500_000;
const GLANCE: usize = 50_000;
/// Work between two improvements of the prices, visits of each cell per improvement, limits of these visits, and
/// improvements after the second walk.
const WORK_PER_PRICING: usize = 3_000_000;
const ROUNDS: usize = 100;
const VISITS: [usize; 2] = [500_000, 1_500_000];
const PATIENT: usize = 12;

impl<'j> LocalSearch<'j> {
    /// Nothing found yet.
    pub fn new(job: &'j CoverageJob, objective: Objective, most: usize, rng: Rng) -> Self {
        let mut count = 0;
        let numbers = job.free.map(|&is_free| {
            let number = if is_free { count } else { NONE };
            count += u32::from(is_free);
            number
        });
        let cells: Vec<Cell> = job.free.iter().filter(|&(_, &is_free)| is_free).map(|(cell, _)| cell).collect();
        let is_closed = objective.finish == Finish::Start;
        let filmed = if cells.len() <= MOST_FILMED { cells.clone() } else { Vec::new() };
        let improver = Improver::new(cells, Tour::new(count as usize, Vec::new(), is_closed), rng);
        let relaxation = Relaxation::new(job, objective);
        Self {
            job,
            objective,
            numbers,
            relaxation,
            improver,
            noise: NOISES[0],
            filmed,
            best: (Vec::new(), i64::MAX),
            shown: Vec::new(),
            most,
            is_solved: false,
        }
    }

    /// Continues with `walk`, which is closed if the objective is a tour.
    pub fn begin_with(&mut self, mut walk: Vec<Cell>, ctx: &PlanContext<'_>) {
        let is_closed = self.objective.finish == Finish::Start;
        if is_closed {
            close(self.job, self.objective, &mut walk);
        }
        let unit = i64::from(self.relaxation.prices.unit);
        self.improver.cost = self.objective.of_walk(self.job, &walk) as i64 * unit;
        let steps = walk.len() - usize::from(is_closed);
        self.improver.tour.replace(walk[..steps].iter().map(|&cell| self.numbers[cell]).collect());
        self.keep(ctx);
    }

    /// Continues with the best walk so far.
    pub fn begin_with_best(&mut self) {
        self.improver.tour.replace(self.best.0.clone());
        self.improver.cost = self.best.1;
    }

    /// Stores the walk if it's the best so far.
    fn keep(&mut self, ctx: &PlanContext<'_>) {
        if self.improver.cost < self.best.1 {
            self.best.0.clone_from(&self.improver.tour.cells);
            self.best.1 = self.improver.cost;
            if ctx.is_observed() {
                self.shown = self.walk();
            }
        }
    }

    /// The best walk so far.
    pub fn walk(&self) -> Vec<Cell> {
        self.improver.walk(&self.best.0, self.job.start)
    }

    /// Proof of the best walk.
    pub fn proof(&self) -> Proof {
        let unit = i64::from(self.relaxation.prices.unit);
        let cost = (self.best.1 / unit) as u64;
        Proof { cost, bound: if self.is_solved { cost } else { self.relaxation.bound() } }
    }

    /// Whether there is nothing left to do.
    fn is_over(&self) -> bool {
        let Proof { cost, bound } = self.proof();
        cost <= bound || self.improver.work >= self.most
    }

    /// Share of the work done, starting from `before`.
    fn share(&self, before: f64) -> f64 {
        between([before, 1.0], self.improver.work as f64 / self.most.max(1) as f64)
    }

    /// Finds the first prices. The walk so far is reported meanwhile, without a proof, as the bound is still weak.
    pub fn price_hastily(&mut self, done: f64, ctx: &mut PlanContext<'_>) -> Result<(), PlanError> {
        let cells = self.relaxation.graph.len().max(1);
        let mut rounds = HASTY.div_ceil(cells);
        while rounds > 0 && self.relaxation.is_diffusing() {
            ctx.checkpoint(done, &self.shown)?;
            let some = rounds.min(GLANCE.div_ceil(cells));
            self.relaxation.improve(some * cells);
            rounds -= some;
        }
        Ok(())
    }

    /// Improves the prices for a while; returns whether more work can help.
    fn improve_prices(&mut self) -> bool {
        let [few, many] = VISITS;
        self.relaxation.improve((ROUNDS * self.relaxation.graph.len()).clamp(few, many))
    }

    /// Finds good prices.
    pub fn price(&mut self, before: f64, ctx: &mut PlanContext<'_>) -> Result<(), PlanError> {
        for _ in 0..PATIENT {
            ctx.proof = Some(self.proof());
            ctx.checkpoint(self.share(before), &self.shown)?;
            if !self.improve_prices() {
                break;
            }
        }
        Ok(())
    }

    /// Settles windows of some side, with some states kept, in the whole room. `shares` are the shares of all work
    /// before and after; if `None`, they follow from the work done.
    pub fn settle(
        &mut self,
        windows: (usize, usize),
        before: f64,
        after: Option<f64>,
        ctx: &mut PlanContext<'_>,
    ) -> Result<(), PlanError> {
        let blocks = self.improver.blocks(&self.numbers, windows.0);
        // Windows that are queued again would make progress run backwards.
        let mut told = before;
        for (i, &block) in blocks.iter().enumerate() {
            if self.is_over() {
                break;
            }
            ctx.proof = Some(self.proof());
            let (most, unit, mut result) = (self.most, i64::from(self.relaxation.prices.unit), Ok(()));
            let Self { improver, relaxation, numbers, shown, filmed, best, .. } = self;
            let ground = Ground::new(self.job, self.objective, relaxation, numbers);
            let (begun_at, mut shown_at) = (improver.cost, best.1);
            let is_shown = ctx.is_observed() && !filmed.is_empty() && self.objective.finish == Finish::Anywhere;
            improver.settle(&ground, block, windows, |Settling { work, done, walk, change }| {
                if is_shown && begun_at + change < shown_at {
                    shown_at = begun_at + change;
                    *shown = walk.iter().map(|&number| filmed[number as usize]).collect();
                    ctx.proof = ctx.proof.map(|proof| Proof { cost: (shown_at / unit) as u64, ..proof });
                }
                let done = match after {
                    Some(after) => between([before, after], (i as f64 + done) / blocks.len() as f64),
                    None => between([before, 1.0], work as f64 / most as f64),
                };
                told = done.max(told);
                result = ctx.checkpoint(told, shown);
                result.is_ok() && work < most
            });
            result?;
            self.keep(ctx);
        }
        Ok(())
    }

    /// Tries all walks that can be better than the best so far, if the room is small enough: no more than `most_states`
    /// states of the frontier at a time.
    pub fn solve(&mut self, most_states: usize, before: f64, ctx: &mut PlanContext<'_>) -> Result<(), PlanError> {
        let Proof { cost, bound } = self.proof();
        if cost <= bound || self.numbers.len() > LARGEST_SOLVED {
            return Ok(());
        }
        let (done, mut result) = (self.share(before), Ok(()));
        let Self { improver, relaxation, numbers, shown, .. } = self;
        let ground = Ground::new(self.job, self.objective, relaxation, numbers);
        self.is_solved = improver.solve(&ground, most_states, || {
            result = ctx.checkpoint(done, shown);
            result.is_ok()
        });
        result?;
        self.keep(ctx);
        Ok(())
    }

    /// Shakes the walk until that share of the effort is spent, or the walk is proven optimal.
    pub fn shake(&mut self, share: f64, before: f64, ctx: &mut PlanContext<'_>) -> Result<(), PlanError> {
        let until = (share * self.most as f64) as usize;
        let mut priced = self.improver.work;
        while !self.is_over() && self.improver.work < until {
            ctx.proof = Some(self.proof());
            let (done, mut result) = (self.share(before), Ok(()));
            let Self { improver, relaxation, numbers, shown, .. } = self;
            let ground = Ground::new(self.job, self.objective, relaxation, numbers);
            let before = improver.cost;
            improver.shake(&ground, self.noise, SHAKEN, || {
                result = result.and_then(|()| ctx.checkpoint(done, shown));
                result.is_ok()
            });
            let change = if improver.cost < before { FALLS } else { GROWS };
            self.noise = (self.noise * change).clamp(NOISES[0], NOISES[1]);
            result?;
            self.keep(ctx);
            if self.improver.work > priced + WORK_PER_PRICING {
                priced = self.improver.work;
                self.improve_prices();
            }
        }
        Ok(())
    }
}

impl<'a> Ground<'a> {
    fn new(job: &CoverageJob, objective: Objective, relaxation: &'a Relaxation, numbers: &'a Grid<u32>) -> Self {
        Self {
            graph: &relaxation.graph,
            prices: &relaxation.prices,
            numbers,
            heading: job.heading as usize,
            counts_first_turn: objective.counts_first_turn,
        }
    }
}

/// Appends the cheapest way back to the start.
fn close(job: &CoverageJob, objective: Objective, walk: &mut Vec<Cell>) {
    let Some(&last) = walk.last().filter(|&&last| last != job.start) else { return };
    let looks = |a: Option<&Cell>, b: Option<&Cell>| -> Option<Direction> { a?.direction_to(*b?) };
    let arrived = walk.len().checked_sub(2).and_then(|i| looks(walk.get(i), Some(&last)));
    let leaves = looks(walk.first(), walk.get(1));
    let mut transit = Transit::new(&job.free, Costs { step: objective.step, turn: objective.turn });
    let (from, to) = (TransitEnd { cell: last, heading: arrived }, TransitEnd { cell: job.start, heading: leaves });
    let _ = transit.append_way(from, to, u32::MAX, walk);
}
