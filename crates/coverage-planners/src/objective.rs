//! The cost that a walk should minimise.

use super::CoverageJob;
use robovac_core::grid::{Cell, Direction};

/// Where a walk ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finish {
    /// Anywhere: an open walk.
    Anywhere,
    /// In the start again: a closed tour. The turn from its last step to its first counts like any other, and the
    /// robot's heading doesn't matter, as a tour can be started at any of its visits to the start.
    Start,
}

/// A weighted sum of steps and quarter turns (a reversal counts two), in whole numbers so that sums don't depend on their
/// order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Objective {
    /// Cost of a step.
    pub step: u32,
    /// Cost of a quarter turn.
    pub turn: u32,
    /// Where the walk ends.
    pub finish: Finish,
    /// Whether the turn from the robot's heading to the first step of an open walk counts.
    pub counts_first_turn: bool,
}

impl Objective {
    /// The cost of an open walk, `step` x steps + `turn` x quarter turns, without the turn to its first step. Tables
    /// compare this cost.
    pub fn open(step: u32, turn: u32) -> Self {
        Self { step, turn, finish: Finish::Anywhere, counts_first_turn: false }
    }

    /// The same for a closed tour.
    pub fn closed(step: u32, turn: u32) -> Self {
        Self { step, turn, finish: Finish::Start, counts_first_turn: false }
    }

    /// Cost of `walk`, which starts at the job's start and, for a closed tour, ends there.
    ///
    /// ```
    /// use robovac_core::grid::*;
    /// use coverage_planners::{CoverageJob, Objective};
    /// let job = CoverageJob::new(&Grid::filled(2, 2, true), Cell::new(0, 0), Direction::Left).unwrap();
    /// let walk = [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)].map(|(x, y)| Cell::new(x, y));
    /// assert_eq!(Objective::closed(1, 50).of_walk(&job, &walk), 4 + 4 * 50);
    /// assert_eq!(Objective::open(1, 50).of_walk(&job, &walk[..4]), 3 + 2 * 50);
    /// let timed = Objective { counts_first_turn: true, ..Objective::open(1, 50) };
    /// assert_eq!(timed.of_walk(&job, &walk[..4]), 3 + 4 * 50);
    /// ```
    pub fn of_walk(self, job: &CoverageJob, walk: &[Cell]) -> u64 {
        let mut steps = walk.windows(2).filter_map(|pair| pair[0].direction_to(pair[1]));
        let Some(first) = steps.next() else { return 0 };
        let (mut cost, mut last) = (u64::from(self.step), first);
        for direction in steps {
            cost += u64::from(self.step) + u64::from(self.turn) * u64::from(last.quarter_turns(direction));
            last = direction;
        }
        let extra: Option<Direction> = match self.finish {
            Finish::Start => Some(last),
            Finish::Anywhere => self.counts_first_turn.then_some(job.heading),
        };
        cost + extra.map_or(0, |before| u64::from(self.turn) * u64::from(before.quarter_turns(first)))
    }
}

/// The cost of a walk and a lower bound of all walks, both in the weights of one objective.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Proof {
    /// Cost of the walk.
    pub cost: u64,
    /// Proven lower bound: no walk costs less.
    pub bound: u64,
}

impl Proof {
    /// The optimality gap: cost above the bound, as a share of the bound; 0 if the walk is proven optimal.
    pub fn gap(self) -> f64 {
        if self.bound == 0 { 0.0 } else { self.cost.saturating_sub(self.bound) as f64 / self.bound as f64 }
    }
}
